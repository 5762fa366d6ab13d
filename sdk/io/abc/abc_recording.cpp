// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes Alembic archives.
#include "sdk/io/abc/abc_recording.h"

#include <Alembic/AbcCoreOgawa/All.h>
#include <meniscus/error.h>

#include <cerrno>
#include <map>
#include <optional>
#include <ostream>
#include <streambuf>

#include "sdk/files/output_file.h"
#include "sdk/io/abc/abc_samples.h"
#include "sdk/io/usd/usd_text.h"

namespace meniscus::io {
namespace {

constexpr float diffuse_width = 0.25f;  // spacings, as in USD

/// What Alembic writes to. Its destructors must not throw, and write all the same. So this never fails, and
/// notes the reason of a file that has.
class AbcBuffer final : public std::streambuf {
 public:
  explicit AbcBuffer(std::ostream& file) : file_(file) {}

  /// Throws Error(io) if the file has failed.
  void check(const std::filesystem::path& path) const {
    if (file_) return;
    errno = reason_;
    throw_io_error("write", path);
  }

 private:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    note([&] { file_.write(bytes, count); });
    at_ += count;
    return count;
  }
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    xsputn(&byte, 1);
    return traits_type::not_eof(c);
  }
  pos_type seekpos(pos_type to, std::ios_base::openmode) override {
    if (at_ != to) note([&] { file_.seekp(to); });
    return at_ = to;
  }
  pos_type seekoff(off_type by, std::ios_base::seekdir from, std::ios_base::openmode mode) override {
    if (from == std::ios_base::end) return off_type{-1};  // Alembic does not
    return seekpos(from == std::ios_base::cur ? at_ + by : pos_type(by), mode);
  }

  template <class Call>
  void note(const Call& call) {
    if (!file_) return;
    errno = 0;
    call();
    if (!file_) reason_ = errno;
  }

  std::ostream& file_;
  pos_type at_ = 0;
  int reason_ = 0;
};

/// Alembic's objects of a scene.
class AbcScene {
 public:
  AbcScene(std::ostream& stream, const Scene& scene, const ExportContents& contents,
           const BodySurfaces* bodies, const SceneFrame& first)
      : spacing_(scene.world.particle_spacing) {
    Alembic::AbcCoreAbstract::MetaData about;
    about.set(abc::kApplicationNameKey, "Meniscus");
    about.set(abc::kUserDescriptionKey, "metres, metres a second");
    archive_ = abc::OArchive(Alembic::AbcCoreOgawa::WriteArchive()(&stream, about));
    const double rate = rate_of(scene.frame_time);
    times_ = archive_.addTimeSampling(abc::TimeSampling(1 / rate, first.number / rate));
    root_ = geom::OXform(archive_.getTop(), "scene");
    set_y_up(root_, scene.world.gravity);
    if (contents.particles) {
      add("particles", scene.fluids, "fluid", particles_);
      add("particles", scene.granulars, "fluid", particles_);
    }
    if (contents.diffuse) add_diffuse();
    if (contents.surface) add("surface", scene.fluids, "fluid", surface_);
    if (bodies) add_bodies(scene, *bodies);
    add_shapes(scene);
    add("cloth", scene.cloths, "cloth", cloth_);
    add("ropes", scene.ropes, "rope", ropes_);
  }

  void add(const SceneFrame& frame) {
    const std::vector<FluidPoints> fluids = points_by_fluid(frame, particles_.size());
    for (std::size_t f = 0; f < fluids.size(); ++f)
      set_points(particles_[f], fluids[f].positions, fluids[f].velocities, fluids[f].ids, spacing_);
    if (diffuse_.valid()) set_diffuse(frame);
    for (std::size_t i = 0; i < bodies_.size(); ++i) set_pose(bodies_[i], frame.bodies.at(i).pose);
    set_meshes(surface_, frame.liquid, {});
    set_meshes(cloth_, frame.cloth, frame.cloth.texture);
    for (std::size_t i = 0; i < ropes_.size(); ++i) set_rope(ropes_[i], frame.ropes, i);
  }

 private:
  struct Group {
    geom::OXform object;
    UsdNames names;
  };
  Group& group(const std::string& name) {
    Group& found = groups_[name];
    if (!found.object.valid()) found.object = geom::OXform(root_, name);
    return found;
  }

  template <class Def, class Object>
  void add(const std::string& kind, const std::vector<Def>& defs, const char* unnamed,
           std::vector<Object>& objects) {
    for (const Def& def : defs) {
      Group& parent = group(kind);
      objects.emplace_back(parent.object, parent.names.add(def.name, unnamed), times_);
    }
  }

  void add_diffuse() {
    diffuse_ = geom::OPoints(root_, "diffuse", times_);
    abc::OCompoundProperty more = diffuse_.getSchema().getArbGeomParams();
    lives_ = geom::OFloatGeomParam(more, "life", false, geom::kVertexScope, 1, times_);
    kinds_ = geom::OInt32GeomParam(more, "kind", false, geom::kVertexScope, 1, times_);
  }

  void add_bodies(const Scene& scene, const BodySurfaces& bodies) {
    add("bodies", bodies_of(scene), "body", bodies_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      geom::OPolyMesh mesh(bodies_[i], "mesh");
      set_still(mesh, bodies.meshes()[i]);
    }
  }

  void add_shapes(const Scene& scene) {
    for (const ShapeDef& shape : scene.shapes) {
      const collision::TriangleMesh solid = solid_mesh(shape.geometry);
      if (solid.triangles.empty()) continue;  // a plane, which has no end
      Group& parent = group("shapes");
      geom::OXform place(parent.object, parent.names.add(shape.name, "shape"));
      set_pose(place, shape.pose);
      geom::OPolyMesh mesh(place, "mesh");
      set_still(mesh, solid);
    }
  }

  void set_diffuse(const SceneFrame& frame) {
    const DiffusePoints all = diffuse_points(frame.diffuse);
    std::vector<uint64_t> numbers(all.lives.size());  // they have no ids
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
    const float width = diffuse_width * spacing_;
    set_points(diffuse_, all.positions, all.velocities, numbers, width);
    const auto lives = converted<float>(std::span<const float>(all.lives), [](float life) { return life; });
    const auto kinds = converted<int32_t>(std::span<const uint32_t>(all.kinds),
                                          [](uint32_t kind) { return static_cast<int32_t>(kind); });
    lives_.set({sample_of<abc::FloatArraySample>(lives), geom::kVertexScope});
    kinds_.set({sample_of<abc::Int32ArraySample>(kinds), geom::kVertexScope});
  }

  template <class Frame>
  static void set_meshes(std::vector<geom::OPolyMesh>& objects, const Frame& frame,
                         const std::vector<TexturePoint>& texture) {
    if (objects.empty()) return;
    const std::vector<MeshPart> parts = parts_of(frame);
    for (std::size_t i = 0; i < objects.size(); ++i)
      set_mesh(objects[i], parts[i], frame,
               texture.empty() ? std::span<const TexturePoint>() : parts[i].corners(texture));
  }

  float spacing_;  // m, of particles
  uint32_t times_ = 0;
  abc::OArchive archive_;
  geom::OXform root_;
  std::map<std::string, Group> groups_;
  std::vector<geom::OPoints> particles_;
  geom::OPoints diffuse_;
  geom::OFloatGeomParam lives_;
  geom::OInt32GeomParam kinds_;
  std::vector<geom::OPolyMesh> surface_, cloth_;
  std::vector<geom::OXform> bodies_;
  std::vector<geom::OCurves> ropes_;
};

/// Alembic's own exceptions are of the file.
template <class Call>
void with_errors(const std::filesystem::path& path, const Call& call) {
  try {
    call();
  } catch (const Alembic::Util::Exception& why) {
    throw Error(ErrorCode::io, "cannot write " + path.string() + ": " + why.what());
  }
}

}  // namespace

void require_abc() {}

struct AbcRecording::Archive {
  explicit Archive(const std::filesystem::path& its_path) : path(its_path), file(path) {}

  std::filesystem::path path;
  OutputFile file;
  AbcBuffer buffer{file.stream()};
  std::ostream stream{&buffer};
  std::optional<AbcScene> scene;  // first of all to go, as it writes its end then
};

AbcRecording::AbcRecording(const std::filesystem::path& path, const Scene& scene,
                           const ExportContents& contents, const BodySurfaces* bodies,
                           const SceneFrame& first)
    : archive_(std::make_unique<Archive>(path)) {
  with_errors(path, [&] { archive_->scene.emplace(archive_->stream, scene, contents, bodies, first); });
}
AbcRecording::~AbcRecording() = default;

void AbcRecording::add(const SceneFrame& frame) {
  with_errors(archive_->path, [&] { archive_->scene->add(frame); });
  archive_->buffer.check(archive_->path);
}

void AbcRecording::finish() {
  archive_->scene.reset();
  archive_->buffer.check(archive_->path);
  archive_->file.commit();
}

}  // namespace meniscus::io
