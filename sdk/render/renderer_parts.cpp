// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements the passes of a frame.
#include "sdk/render/renderer_parts.h"

#include <algorithm>

namespace meniscus::render {
namespace {

const io::PreviewScene& checked(const io::PreviewScene& scene) {
  check_size(scene.width, scene.height);
  return scene;
}

void bind_uniforms(GLuint binding, const DataBuffer& buffer) {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.name());
}

}  // namespace

void check_size(int width, int height) {
  const auto check = [](const char* name, int value) {
    if (value >= 1 && value <= 16384) return;
    throw Error(ErrorCode::invalid_argument,
                std::string(name) + " is " + std::to_string(value) + ", but a picture has 1 to 16384 pixels");
  };
  check("width", width);
  check("height", height);
  FluidSurface::check_room(width, height);
}

Renderer::Parts::Parts(const io::PreviewScene& s, const Moment& first, const RenderSettings& set)
    : scene(checked(s)),
      settings(set),
      solids(s),
      vessels(s),
      bounds(bounds_of(solids.bounds(), with_spans(first))),
      stage(stage_of(s, bounds)) {
  shadow.compare_depths();
  if (scene.first_granular < scene.fluid_colors.size()) grains.emplace();
  if (settings.caustics) caustics.emplace();
  const FluidUniforms fluids = fluid_uniforms_of(scene);
  fluid_buffer.write(std::span<const FluidUniforms>(&fluids, 1));
  write_media();
  look();
}

void Renderer::Parts::write_media() {
  const MediaUniforms media = media_uniforms_of(scene, stage);
  extinction_buffer.write(std::span<const Float4>(media.extinctions));
  glow_buffer.write(std::span<const Float4>(media.glows));
}

void Renderer::Parts::look() {
  frame = uniforms_of(stage, to->width, to->height);
  // Three pixels wide: thinner bars would look dotted.
  const float pixel = 2 * frame.lens[1] * length(stage.centre - stage.camera.position) * frame.viewport[3];
  frame.eye[3] = 1.3f * pixel * std::max(share, 0.6f);
  frame.up[3] = settings.caustics ? 1.0f : 0.0f;
  frame_buffer.write(std::span<const FrameUniforms>(&frame, 1));
}

void Renderer::Parts::load(const Moment& moment) {
  const ViewData none, &view = moment.view ? *moment.view : none;
  const bool shows_fluid = view.choice.particles == ParticleView::surface;
  const bool by_spans = !moment.world || !shows_fluid || !settings.anisotropic;
  const Moment shown = by_spans ? with_spans(moment) : moment;
  check_particles(shown);
  const bool moves =
      solids.place(moment.bodies, moment.cloth, moment.ropes, strain_colors(moment.cloth, view)) || grains;
  vessels.place(moment.bodies);
  if (shown.world)
    particles.set(*shown.world);
  else
    load_particles(shown, shows_fluid);
  balls.set(shown.ellipsoids, view);
  foam.set(!shows_fluid  ? std::span<const DiffuseParticle>()
           : shown.world ? shown.world->diffuse()
                         : shown.diffuse);
  load_view(view);
  if (moves) has_solid_shadows = false;
  forget_fluid_shadows();
}

void Renderer::Parts::forget_fluid_shadows() {
  for (Pictures* pictures : {to.get(), before.get()}) {
    if (pictures) pictures->has_fluid_shadows = false;
  }
}

/// Call it before anything has changed.
void Renderer::Parts::check_particles(const Moment& moment) const {
  Particles::check_room(moment.world ? moment.world->particle_count() : moment.ellipsoids.size());
  if (moment.world) return;
  check_count("fluids", moment.fluids.size(), moment.ellipsoids.size());
  if (!moment.velocities.empty())
    check_count("velocities", moment.velocities.size(), moment.ellipsoids.size());
  if (!settings.anisotropic) check_count("positions", moment.positions.size(), moment.ellipsoids.size());
}

void Renderer::Parts::load_particles(const Moment& moment, bool shows_fluid) {
  if (!shows_fluid)
    particles.set({}, {});  // balls replace them
  else if (settings.anisotropic)
    particles.set(moment.ellipsoids, moment.fluids, moment.velocities);
  else
    particles.set(balls_at(moment, scene), moment.fluids);
}

void Renderer::Parts::load_view(const ViewData& view) {
  needles.set(contact_needles(view.contacts, 1.2f * stage.spacing));
  if (view.choice.distances)
    slice.set(view.slice, view.distances);
  else
    slice.clear();
  shows_normals = view.choice.normals;
}

void Renderer::Parts::bind() const {
  bind_uniforms(frame_binding, frame_buffer);
  bind_uniforms(fluids_binding, fluid_buffer);
  bind_uniforms(extinctions_binding, extinction_buffer);
  bind_uniforms(glows_binding, glow_buffer);
  shadow.bind(unit::shadow);
  shadow.bind(unit::shadow_depths);
  glBindSampler(unit::shadow_depths, plain_sampler);
  shadow_spans.bind(unit::shadow_spans);
  to->thickness.sun().bind(unit::fluid_shadow);
  to->thickness.sun_rest().bind(unit::rest_shadow);
  if (caustics) caustics->bind();
  vessels.bind();
}

void Renderer::Parts::draw_solid_shadows() {
  to_shadow.use();
  to_shadow.clear_depth();
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5f, 4);
  solids.draw_shadows();
  if (grains) grains->draw_shadows(particles);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_TEST);
  find_spans.use();
  find_spans.run_over(shadow_spans);
  has_solid_shadows = true;
  timer.mark("shadow map");
}

void Renderer::Parts::draw_solids() {
  if (!has_triangles()) return;
  to->to_surfaces.use();
  to->to_surfaces.clear_depth();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  solids.draw();
  if (grains) grains->draw(particles);
  balls.draw(0.5f * stage.spacing);
  glDisable(GL_DEPTH_TEST);
  timer.mark("solids");
}

void Renderer::Parts::find_distances() {
  to->scene_depth.bind(unit::depth);
  distance.use();
  glUniform1i(0, has_triangles());
  distance.start_over(to->scene_distance);
  timer.mark("distances");
}

void Renderer::Parts::list_particles() {
  const float radius = FluidThickness::disc_radius(stage.spacing);
  camera_lists.set(to->width, to->height, radius);
  sun_lists.set(FluidThickness::sun_size, FluidThickness::sun_size, radius);
  TileLists* const lists[] = {&camera_lists, &sun_lists};
  TileLists::build(std::span(lists).first(to->has_fluid_shadows ? 1 : 2), particles);
  timer.mark("lists");
}

void Renderer::Parts::gather_fluid() {
  // These run concurrently: the longest starts first, and the others fill the capacity that it leaves free
  // towards its end.
  to->surface.draw_front(camera_lists, particles, to->scene_distance);
  timer.mark("ellipsoids");
  const bool draws_sun = !to->has_fluid_shadows;
  if (draws_sun) to->thickness.draw_for_sun(sun_lists, frame);
  to->has_fluid_shadows = true;
  Program::show_writes();
  timer.mark("thickness for the sun");
  to->surface.bind_front();
  to->thickness.draw_for_camera(camera_lists, frame, to->scene_distance);
  Program::show_writes();
  timer.mark("thickness");
  to->thickness.bind_layers();
  to->surface.draw_rest(camera_lists, particles, to->scene_distance);
  Program::show_writes();
  timer.mark("ellipsoids behind");
  if (caustics && draws_sun) caustics->draw(to->thickness.sun());
}

void Renderer::Parts::light_scene() {
  to->albedo.bind(unit::color);
  to->scene_distance.bind(unit::depth);
  to->normal.bind(unit::normals);
  light.use();
  light.start_over(to->scene_color);
  timer.mark("light");
}

void Renderer::Parts::draw_fluid() {
  const float reach = settings.filter_reach * stage.spacing;
  const float away = std::max(length(stage.centre - stage.camera.position), stage.spacing);
  to->surface.filter(settings.filter, reach, settings.filter_threshold * stage.spacing,
                     reach * frame.viewport[1] / (2 * frame.lens[1] * away));
  Program::show_writes();  // makes the light visible, if there is no filter
  timer.mark("filter");
  to->surface.bind_front();
  to->surface.bind_rest_too();
  foam.gather(frame, to->scene_distance, to->foam);
  timer.mark("foam");
  to->surface.bind_rest();
  draw_layer(1, to->scene_color, to->behind_front);
  to->surface.bind_front();
  to->to_behind_front.use();
  foam.lay_over_rest(screen, to->foam);
  draw_layer(0, to->behind_front, to->lit);
  timer.mark("fluid");
}

void Renderer::Parts::draw_layer(int layer, const Texture& behind, const Texture& over) {
  behind.bind(unit::color);
  to->scene_distance.bind(unit::depth);
  fluid.use();
  glUniform1i(0, layer);
  fluid.run_over(over);
}

void Renderer::Parts::draw_over() {
  to->to_lit.use();
  foam.lay_over_front(screen, to->foam);
  if (!needles.empty() || !slice.empty()) {
    to->to_over.use();
    to->to_over.clear_depth();  // they compare distances by themselves
    glEnable(GL_DEPTH_TEST);
    needles.draw(1.2f);
    slice.draw();
    glDisable(GL_DEPTH_TEST);
  }
  timer.mark("over");
}

void Renderer::Parts::paint_light() {
  bind();
  timer.start();
  if (!has_solid_shadows) draw_solid_shadows();
  draw_solids();
  find_distances();
  list_particles();
  gather_fluid();
  light_scene();
  draw_fluid();
  draw_over();
}

void Renderer::Parts::add_picture(int sample, int count) {
  if (!sums || sums->width() != to->width || sums->height() != to->height)
    sums.emplace(GL_RGBA32F, to->width, to->height);
  to->lit.bind(unit::color);
  to->scene_distance.bind(unit::depth);
  sums->bind_image(1, GL_READ_WRITE);
  add.use();
  glUniform1i(0, sample);
  glUniform1f(1, 1 / static_cast<float>(count));
  add.run_over(to->toned);
  timer.mark("tone");
  if (sample + 1 == count) smooth_edges();
}

void Renderer::Parts::draw_picture() {
  to->lit.bind(unit::color);
  to->scene_distance.bind(unit::depth);
  if (shows_normals) {
    to->to_toned.use();
    view_normals.use();
    screen.draw();
  } else {
    tone.use();
    tone.run_over(to->toned);
  }
  timer.mark("tone");
  smooth_edges();
}

void Renderer::Parts::smooth_edges() {
  to->toned.bind(unit::color);
  smooth.use();
  smooth.run_over(to->picture);
  timer.mark("smooth edges");
}

void Renderer::Parts::check_success() const {
  if (const GLenum failure = glGetError()) {
    throw Error(ErrorCode::device, "OpenGL failed to draw " + std::to_string(to->width) + " x " +
                                       std::to_string(to->height) + " pixels (error " +
                                       std::to_string(failure) + ")");
  }
}

}  // namespace meniscus::render
