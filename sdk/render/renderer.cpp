// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements the calls of Renderer.
#include "sdk/render/renderer.h"

#include <algorithm>

#include "pbd/math/vec.h"
#include "sdk/render/renderer_parts.h"

namespace meniscus::render {
namespace {

/// Reverses the order of rows: OpenGL has them from the bottom.
template <class T>
void turn_over(std::vector<T>& pixels, int row, int rows) {
  for (int y = 0; y < rows / 2; ++y) {
    const auto top = pixels.begin() + std::ptrdiff_t{y} * row;
    std::swap_ranges(top, top + row, pixels.begin() + std::ptrdiff_t{rows - 1 - y} * row);
  }
}

}  // namespace

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

Vec3 Renderer::up() const {
  return parts_->stage.up;
}

void Renderer::set_camera(const SceneCamera& camera) {
  const SceneCamera& now = parts_->stage.camera;
  if (camera.position == now.position && camera.target == now.target &&
      camera.field_of_view == now.field_of_view)
    return;
  parts_->stage.camera = camera;
  parts_->look();
}

void Renderer::set_media(std::vector<std::optional<io::Medium>> media) {
  parts_->scene.media = std::move(media);
  parts_->write_media();
  parts_->forget_fluid_shadows();
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
  parts_->paint_light();
  parts_->draw_picture();
}

void Renderer::add_sample(int sample, int count) {
  parts_->paint_light();
  parts_->add_picture(sample, count);
}

io::Image Renderer::image() const {
  const Pictures& to = *parts_->to;
  io::Image image{to.width, to.height, std::vector<uint8_t>(std::size_t{3} * to.width * to.height)};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(to.picture.name(), 0, GL_RGB, GL_UNSIGNED_BYTE, static_cast<GLsizei>(image.rgb.size()),
                    image.rgb.data());
  parts_->check_success();
  turn_over(image.rgb, 3 * to.width, to.height);
  return image;
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
  const Program program("screen/screen.vert.glsl", "fluid/normal.frag.glsl");
  parts_->bind();
  target.use();
  parts_->to->surface.bind_front();
  program.use();
  parts_->screen.draw();
  std::vector<std::array<float, 4>> pixels(std::size_t{1} * normals.width() * normals.height());
  glGetTextureImage(normals.name(), 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(pixels.size() * sizeof pixels[0]), pixels.data());
  turn_over(pixels, normals.width(), normals.height());
  return pixels;
}

std::vector<float> Renderer::fluid_thickness() {
  std::vector<float> metres;
  for (const Texture* map : {&parts_->to->thickness.front(), &parts_->to->thickness.rest()}) {
    std::vector<std::array<float, 4>> pixels(std::size_t{1} * map->width() * map->height());
    glGetTextureImage(map->name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(pixels.size() * sizeof pixels[0]), pixels.data());
    turn_over(pixels, map->width(), map->height());
    metres.resize(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) metres[i] += pixels[i][3];
  }
  return metres;
}

}  // namespace meniscus::render
