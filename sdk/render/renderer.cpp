// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/renderer.h"

#include <algorithm>

#include "sdk/render/passes/balls.h"
#include "sdk/render/passes/foam.h"
#include "sdk/render/passes/grains.h"
#include "sdk/render/passes/needles.h"
#include "sdk/render/passes/slice.h"
#include "sdk/render/passes/solids.h"
#include "sdk/render/pictures.h"

namespace meniscus::render {
namespace {

constexpr int shadow_size = 2048;

void check_size(int width, int height) {
  const auto check = [](const char* name, int value) {
    if (value >= 1 && value <= 16384) return;
    throw Error(ErrorCode::invalid_argument,
                std::string(name) + " is " + std::to_string(value) + ", but a picture has 1 to 16384 pixels");
  };
  check("width", width);
  check("height", height);
}

const io::PreviewScene& checked(const io::PreviewScene& scene) {
  check_size(scene.width, scene.height);
  return scene;
}

Bounds bounds_of(const Solids& solids, const Moment& moment) {
  Bounds bounds = solids.bounds();
  for (const Ellipsoid& e : moment.ellipsoids) {
    if (is_finite(e.centre)) bounds.add(e.centre);
  }
  for (const std::vector<Vec3>* points : {&moment.cloth.vertices, &moment.ropes.vertices}) {
    for (const Vec3 p : *points) {
      if (is_finite(p)) bounds.add(p);
    }
  }
  return bounds;
}

/// Grains are as they were.
std::vector<Ellipsoid> balls_at(const Moment& moment, const io::PreviewScene& scene) {
  std::vector<Ellipsoid> balls(moment.ellipsoids.begin(), moment.ellipsoids.end());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (moment.fluids[i] >= scene.first_granular) continue;
    const float r = scene.particle_spacing;
    balls[i] = {moment.positions[i], {r, r, r}, {0, 0, 0, 1}};
  }
  return balls;
}

/// Rows from the top, where OpenGL has them from the bottom.
template <class T>
void turn_over(std::vector<T>& pixels, int row, int rows) {
  for (int y = 0; y < rows / 2; ++y) {
    const auto top = pixels.begin() + std::ptrdiff_t{y} * row;
    std::swap_ranges(top, top + row, pixels.begin() + std::ptrdiff_t{rows - 1 - y} * row);
  }
}

void bind_uniforms(GLuint binding, const DataBuffer& buffer) {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.name());
}

/// One a triangle, where the view asks for them.
std::vector<Vec3> strain_colors(const io::ClothFrame& cloth, const ViewData& view) {
  std::vector<Vec3> colors;
  if (!view.choice.strain) return colors;
  for (const float strain : cloth.strains)
    colors.push_back(color_at(view.strain.map, view.strain.place(strain)));
  return colors;
}

/// From each contact along its normal, in a colour for each kind of thing that is touched.
std::vector<Needle> contact_needles(std::span<const ParticleContact> contacts, float length) {
  constexpr Vec3 of_shapes{1.0f, 0.55f, 0.05f}, of_bodies{0.9f, 0.05f, 0.05f}, of_cloth{0.1f, 0.8f, 0.15f};
  std::vector<Needle> needles;
  for (const ParticleContact& c : contacts) {
    const Vec3 color = c.body != BodyId{} ? of_bodies : c.cloth != ClothId{} ? of_cloth : of_shapes;
    needles.push_back({c.point, c.point + length * c.normal, color});
  }
  return needles;
}

}  // namespace

/// All that is made once, and the passes of a frame in their order.
struct Renderer::Parts {
  Parts(const io::PreviewScene& s, const Moment& first, const RenderSettings& set)
      : scene(checked(s)),
        settings(set),
        solids(s),
        bounds(bounds_of(solids, first)),
        stage(stage_of(s, bounds)) {
    shadow.compare_depths();
    if (scene.first_granular < scene.fluid_colors.size()) grains.emplace();
    const FluidUniforms fluids = fluid_uniforms_of(scene);
    fluid_buffer.write(std::span<const FluidUniforms>(&fluids, 1));
    look();
  }

  /// As the stage says, in a picture of the present size.
  void look() {
    frame = uniforms_of(stage, to->width, to->height);
    // Three pixels: thinner ones would be dotted.
    const float pixel = 2 * frame.lens[1] * length(stage.centre - stage.camera.position) * frame.viewport[3];
    solids.set_edges(1.3f * pixel * std::max(share, 0.6f));
    frame_buffer.write(std::span<const FrameUniforms>(&frame, 1));
  }

  void load(const Moment& moment) {
    if (moment.fluids.size() != moment.ellipsoids.size()) {
      throw Error(ErrorCode::invalid_argument, "fluids has " + std::to_string(moment.fluids.size()) +
                                                   " elements, but there are " +
                                                   std::to_string(moment.ellipsoids.size()) + " ellipsoids");
    }
    if (!settings.anisotropic && moment.positions.size() != moment.ellipsoids.size()) {
      throw Error(ErrorCode::invalid_argument, "positions has " + std::to_string(moment.positions.size()) +
                                                   " elements, but there are " +
                                                   std::to_string(moment.ellipsoids.size()) + " ellipsoids");
    }
    const ViewData none, &view = moment.view ? *moment.view : none;
    solids.place(moment.bodies, moment.cloth, moment.ropes, strain_colors(moment.cloth, view));
    if (view.choice.particles != ParticleView::surface)
      particles.set({}, {});  // but balls in their place
    else if (settings.anisotropic)
      particles.set(moment.ellipsoids, moment.fluids);
    else
      particles.set(balls_at(moment, scene), moment.fluids);
    foam.set(view.choice.particles == ParticleView::surface ? moment.diffuse
                                                            : std::span<const DiffuseParticle>());
    load_view(moment, view);
    to->has_shadows = false;
    if (before) before->has_shadows = false;
  }

  void load_view(const Moment& moment, const ViewData& view) {
    balls.set(moment.ellipsoids, view);
    needles.set(contact_needles(view.contacts, 1.2f * stage.spacing));
    if (view.choice.distances)
      slice.set(view.slice, view.distances);
    else
      slice.clear();
    shows_normals = view.choice.normals;
  }

  void bind() const {
    bind_uniforms(frame_binding, frame_buffer);
    bind_uniforms(fluids_binding, fluid_buffer);
    shadow.bind(unit::shadow);
    to->thickness.sun().bind(unit::fluid_shadow);
  }

  void draw_shadows() {
    to_shadow.use();
    to_shadow.clear_depth();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 4);
    solids.draw_shadows();
    if (grains) grains->draw_shadows(particles);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_TEST);
    timer.mark("shadow map");
    to->thickness.draw_for_sun(particles, frame, stage.spacing);
    timer.mark("sun thickness");
    to->has_shadows = true;
  }

  void draw_scene() {
    to->to_scene.use();
    to->to_scene.clear_depth();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    backdrop.use();
    screen.draw();
    timer.mark("backdrop");
    glDepthFunc(GL_LESS);
    solids.draw_opaque();
    if (grains) grains->draw(particles);
    balls.draw(0.5f * stage.spacing);
    solids.draw_glass();
    glDisable(GL_DEPTH_TEST);
    timer.mark("solids");
  }

  void draw_fluid() {
    const float reach = settings.filter_reach * stage.spacing;
    const float away = std::max(length(stage.centre - stage.camera.position), stage.spacing);
    to->surface.draw(particles, to->scene_depth, screen, settings.filter, reach,
                     settings.filter_threshold * stage.spacing,
                     reach * frame.viewport[1] / (2 * frame.lens[1] * away));
    timer.mark("surface");
    to->thickness.draw_for_camera(particles, frame, to->scene_depth, stage.spacing);
    timer.mark("thickness");
    foam.gather(frame, to->scene_depth, to->surface.depth(), stage.spacing, to->to_foam);
    timer.mark("foam");
    to->to_lit.use();
    to->scene_color.bind(unit::color);
    to->scene_depth.bind(unit::depth);
    to->surface.depth().bind(unit::fluid_depth);
    to->thickness.camera().bind(unit::thickness);
    glEnable(GL_DEPTH_TEST);  // for the depths to be written
    glDepthFunc(GL_ALWAYS);
    fluid.use();
    screen.draw();
    glDisable(GL_DEPTH_TEST);
    timer.mark("shading");
    foam.lay_over(screen, to->foam);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    solids.draw_edges();
    needles.draw(1.2f);
    slice.draw();
    glDisable(GL_DEPTH_TEST);
    timer.mark("over");
  }

  void draw_picture() {
    to->to_toned.use();
    to->lit.bind(unit::color);
    to->lit_depth.bind(unit::depth);
    to->surface.depth().bind(unit::fluid_depth);
    (shows_normals ? view_normals : tone).use();
    screen.draw();
    to->to_picture.use();
    to->toned.bind(unit::color);
    smooth.use();
    screen.draw();
    timer.mark("tone");
  }

  io::Image read() const {
    io::Image image{to->width, to->height, std::vector<uint8_t>(std::size_t{3} * to->width * to->height)};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(to->picture.name(), 0, GL_RGB, GL_UNSIGNED_BYTE, static_cast<GLsizei>(image.rgb.size()),
                      image.rgb.data());
    check_success();
    turn_over(image.rgb, 3 * to->width, to->height);
    return image;
  }

  void check_success() const {
    if (const GLenum failure = glGetError()) {
      throw Error(ErrorCode::device, "OpenGL failed to draw " + std::to_string(to->width) + " x " +
                                         std::to_string(to->height) + " pixels (error " +
                                         std::to_string(failure) + ")");
    }
  }

  io::PreviewScene scene;
  RenderSettings settings;
  Solids solids;
  Bounds bounds;
  Stage stage;
  FrameUniforms frame;
  DataBuffer frame_buffer, fluid_buffer;
  Screen screen;
  float share = 1;  // of the pixels that the picture will be shown with, along a side
  Particles particles;
  Foam foam;
  std::optional<Grains> grains;  // where the scene has any
  Balls balls{scene.fluid_colors};
  Needles needles;
  Slice slice;
  bool shows_normals = false;
  PassTimer timer;

  Texture shadow{GL_DEPTH_COMPONENT32F, shadow_size, shadow_size, GL_LINEAR};
  Target to_shadow{{}, &shadow};
  std::unique_ptr<Pictures> to = std::make_unique<Pictures>(scene.width, scene.height);
  std::unique_ptr<Pictures> before;  // of the size before, to which a window may go back
  Program backdrop{"screen.vert.glsl", "backdrop.frag.glsl"};
  Program fluid{"screen.vert.glsl", "fluid.frag.glsl"};
  Program tone{"screen.vert.glsl", "tone.frag.glsl"};
  Program view_normals{"screen.vert.glsl", "view_normals.frag.glsl"};
  Program smooth{"screen.vert.glsl", "smooth.frag.glsl"};
};

Renderer::Renderer(const io::PreviewScene& scene, const Moment& first, const RenderSettings& settings)
    : parts_(std::make_unique<Parts>(scene, first, settings)) {}

Renderer::~Renderer() = default;

Aabb Renderer::box() const {
  const Bounds& b = parts_->bounds;
  return b.empty() ? Aabb{{-1, -1, -1}, {1, 1, 1}} : Aabb{b.lower, b.upper};
}

const SceneCamera& Renderer::camera() const {
  return parts_->stage.camera;
}

void Renderer::set_camera(const SceneCamera& camera) {
  parts_->stage.camera = camera;
  parts_->look();
}

void Renderer::set_size(int width, int height, float share) {
  check_size(width, height);
  parts_->share = share;
  if (width == parts_->to->width && height == parts_->to->height) return;
  std::swap(parts_->to, parts_->before);
  if (!parts_->to || parts_->to->width != width || parts_->to->height != height)
    parts_->to = std::make_unique<Pictures>(width, height);
  parts_->look();
}

void Renderer::load(const Moment& moment) {
  parts_->load(moment);
}

void Renderer::paint() {
  parts_->bind();
  parts_->timer.start();
  if (!parts_->to->has_shadows) parts_->draw_shadows();
  parts_->draw_scene();
  parts_->draw_fluid();
  parts_->draw_picture();
}

io::Image Renderer::image() const {
  return parts_->read();
}

void Renderer::show(int width, int height) const {
  const Pictures& from = *parts_->to;
  glBlitNamedFramebuffer(from.to_picture.name(), 0, 0, 0, from.width, from.height, 0, 0, width, height,
                         GL_COLOR_BUFFER_BIT, GL_LINEAR);
  parts_->check_success();
}

void Renderer::time_passes(bool on) {
  parts_->timer.switch_on(on);
}

std::vector<PassTime> Renderer::pass_times() const {
  return parts_->timer.times();
}

io::Image Renderer::draw(const Moment& moment) {
  load(moment);
  paint();
  return image();
}

std::vector<std::array<float, 4>> Renderer::fluid_normals() {
  const Texture normals(GL_RGBA32F, parts_->to->width, parts_->to->height);
  const Target target({&normals}, nullptr);
  const Program program("screen.vert.glsl", "normal.frag.glsl");
  parts_->bind();
  target.use();
  parts_->to->surface.depth().bind(unit::fluid_depth);
  program.use();
  parts_->screen.draw();
  std::vector<std::array<float, 4>> pixels(std::size_t{1} * normals.width() * normals.height());
  glGetTextureImage(normals.name(), 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(pixels.size() * sizeof pixels[0]), pixels.data());
  turn_over(pixels, normals.width(), normals.height());
  return pixels;
}

std::vector<float> Renderer::fluid_thickness() {
  const Texture& map = parts_->to->thickness.camera();
  std::vector<std::array<float, 4>> pixels(std::size_t{1} * map.width() * map.height());
  glGetTextureImage(map.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof pixels[0]),
                    pixels.data());
  turn_over(pixels, map.width(), map.height());
  std::vector<float> metres;
  for (const auto& p : pixels) metres.push_back(p[3]);
  return metres;
}

}  // namespace meniscus::render
