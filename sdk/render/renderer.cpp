// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/renderer.h"

#include <algorithm>

#include "sdk/render/moment_parts.h"
#include "sdk/render/passes/balls.h"
#include "sdk/render/passes/foam.h"
#include "sdk/render/passes/grains.h"
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

}  // namespace

/// All that is made once, and the passes of a frame in their order.
struct Renderer::Parts {
  Parts(const io::PreviewScene& s, const Moment& first, const RenderSettings& set)
      : scene(checked(s)),
        settings(set),
        solids(s),
        bounds(bounds_of(solids.bounds(), with_spans(first))),
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
    const ViewData none, &view = moment.view ? *moment.view : none;
    const bool shows_fluid = view.choice.particles == ParticleView::surface;
    if (moment.world && shows_fluid && settings.anisotropic) {
      particles.set(*moment.world);
      foam.set(moment.world->diffuse());
      balls.clear();
    } else {
      load_particles(with_spans(moment), view, shows_fluid);
    }
    if (solids.place(moment.bodies, moment.cloth, moment.ropes, strain_colors(moment.cloth, view)) || grains)
      has_solid_shadows = false;
    load_view(view);
    to->has_fluid_shadows = false;
    if (before) before->has_fluid_shadows = false;
  }

  void load_particles(const Moment& moment, const ViewData& view, bool shows_fluid) {
    check_count("fluids", moment.fluids.size(), moment.ellipsoids.size());
    if (!settings.anisotropic) check_count("positions", moment.positions.size(), moment.ellipsoids.size());
    if (!shows_fluid)
      particles.set({}, {});  // but balls in their place
    else if (settings.anisotropic)
      particles.set(moment.ellipsoids, moment.fluids);
    else
      particles.set(balls_at(moment, scene), moment.fluids);
    foam.set(shows_fluid ? moment.diffuse : std::span<const DiffuseParticle>());
    balls.set(moment.ellipsoids, view);
  }

  void load_view(const ViewData& view) {
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

  void draw_solid_shadows() {
    to_shadow.use();
    to_shadow.clear_depth();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 4);
    solids.draw_shadows();
    if (grains) grains->draw_shadows(particles);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_TEST);
    has_solid_shadows = true;
    timer.mark("shadow map");
  }

  void draw_fluid_shadows() {
    sun_lists.build(particles, FluidThickness::sun_size, FluidThickness::sun_size,
                    FluidThickness::disc_radius(stage.spacing));
    timer.mark("lists for the sun");
    to->thickness.draw_for_sun(sun_lists, frame);
    to->has_fluid_shadows = true;
    timer.mark("thickness for the sun");
  }

  void draw_scene() {
    to->to_surfaces.use();
    to->to_surfaces.clear_depth();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    solids.draw_opaque();
    if (grains) grains->draw(particles);
    balls.draw(0.5f * stage.spacing);
    glDisable(GL_DEPTH_TEST);
    timer.mark("solids");
    to->albedo.bind(unit::color);
    to->scene_depth.bind(unit::depth);
    to->normal.bind(unit::normals);
    to->scene_distance.bind_image(1);
    light.use();
    light.run_over(to->scene_color);
    timer.mark("light");
    to->to_scene.use();
    glEnable(GL_DEPTH_TEST);
    solids.draw_glass();
    glDisable(GL_DEPTH_TEST);
    timer.mark("glass");
  }

  void draw_fluid() {
    const float reach = settings.filter_reach * stage.spacing;
    const float away = std::max(length(stage.centre - stage.camera.position), stage.spacing);
    camera_lists.build(particles, to->width, to->height, FluidThickness::disc_radius(stage.spacing));
    timer.mark("lists");
    to->surface.draw(camera_lists, to->scene_distance);
    timer.mark("ellipsoids");
    to->surface.filter(settings.filter, reach, settings.filter_threshold * stage.spacing,
                       reach * frame.viewport[1] / (2 * frame.lens[1] * away));
    timer.mark("filter");
    to->thickness.draw_for_camera(camera_lists, frame, to->scene_distance);
    timer.mark("thickness");
    foam.gather(frame, to->scene_distance, to->surface.depth(), stage.spacing, to->to_foam);
    timer.mark("foam");
    to->scene_color.bind(unit::color);
    to->scene_distance.bind(unit::depth);
    to->surface.depth().bind(unit::fluid_depth);
    to->thickness.camera().bind(unit::thickness);
    fluid.use();
    fluid.run_over(to->lit);
    timer.mark("fluid");
  }

  /// What is to be seen however the fluid mirrors.
  void draw_over() {
    to->to_lit.use();
    foam.lay_over(screen, to->foam);
    to->over_lit.use();
    glEnable(GL_DEPTH_TEST);
    solids.draw_edges();
    needles.draw(1.2f);
    slice.draw();
    glDisable(GL_DEPTH_TEST);
    timer.mark("over");
  }

  void draw_picture() {
    to->lit.bind(unit::color);
    to->surface.depth().bind(unit::fluid_depth);
    if (shows_normals) {
      to->scene_distance.bind(unit::depth);
      to->scene_depth.bind(unit::normals);
      to->to_toned.use();
      view_normals.use();
      screen.draw();
    } else {
      tone.use();
      tone.run_over(to->toned);
    }
    timer.mark("tone");
    to->toned.bind(unit::color);
    smooth.use();
    smooth.run_over(to->picture);
    timer.mark("edges");
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
  TileLists camera_lists{"list_for_camera.comp.glsl", 32};
  TileLists sun_lists{"list_for_sun.comp.glsl", 16};
  Foam foam;
  std::optional<Grains> grains;  // where the scene has any
  Balls balls{scene.fluid_colors};
  Needles needles;
  Slice slice;
  bool shows_normals = false;
  bool has_solid_shadows = false;  // of what was loaded last
  PassTimer timer;

  Texture shadow{GL_DEPTH_COMPONENT32F, shadow_size, shadow_size, GL_LINEAR};
  Target to_shadow{{}, &shadow};
  std::unique_ptr<Pictures> to = std::make_unique<Pictures>(scene.width, scene.height);
  std::unique_ptr<Pictures> before;  // of the size before, to which a window may go back
  Program light{"light.comp.glsl"};
  Program fluid{"fluid.comp.glsl"};
  Program tone{"tone.comp.glsl"};
  Program view_normals{"screen.vert.glsl", "view_normals.frag.glsl"};
  Program smooth{"smooth.comp.glsl"};
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
  if (!parts_->has_solid_shadows) parts_->draw_solid_shadows();
  if (!parts_->to->has_fluid_shadows) parts_->draw_fluid_shadows();
  parts_->draw_scene();
  parts_->draw_fluid();
  parts_->draw_over();
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
