// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Imports a mesh file of any format that is read.
#include "collision/mesh/file/import.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <meniscus/error.h>

#include <new>
#include <set>
#include <utility>

#include "collision/mesh/file/bytes.h"
#include "collision/mesh/file/chunks.h"
#include "collision/mesh/file/dae.h"
#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/format.h"
#include "collision/mesh/file/gltf.h"
#include "collision/mesh/file/obj.h"
#include "collision/mesh/file/ply.h"
#include "collision/mesh/file/scene_check.h"
#include "collision/mesh/file/stl.h"
#include "collision/mesh/file/tuning.h"

namespace meniscus::collision {

namespace {

/// Hands polygons that are read already to assimp, which triangulates them.
class PolygonReader : public Assimp::BaseImporter {
 public:
  explicit PolygonReader(Polygons polygons) : polygons_(std::move(polygons)) {
    if (polygons_.ends.empty()) throw FileDefect("has no triangle");
  }

  bool CanRead(const std::string&, Assimp::IOSystem*, bool) const override { return true; }
  const aiImporterDesc* GetInfo() const override {
    static constexpr aiImporterDesc description{"polygons", "", "", "", 0, 0, 0, 0, 0, "ply stl"};
    return &description;
  }

 protected:
  void InternReadFile(const std::string&, aiScene* scene, Assimp::IOSystem*) override {
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene->mNumMaterials = 1;
    scene->mMeshes = new aiMesh* [1] { new aiMesh };
    scene->mNumMeshes = 1;
    fill(*scene->mMeshes[0]);
    scene->mRootNode = new aiNode("root");
    scene->mRootNode->mMeshes = new unsigned[1]{0};
    scene->mRootNode->mNumMeshes = 1;
  }

 private:
  void fill(aiMesh& mesh) const {
    mesh.mVertices = new aiVector3D[polygons_.vertices.size()];
    for (const Vec3& v : polygons_.vertices) mesh.mVertices[mesh.mNumVertices++] = {v.x, v.y, v.z};
    mesh.mFaces = new aiFace[polygons_.ends.size()];
    mesh.mNumFaces = static_cast<unsigned>(polygons_.ends.size());
    uint32_t begin = 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      aiFace& face = mesh.mFaces[f];
      face.mIndices = new unsigned[polygons_.ends[f] - begin];
      for (; begin < polygons_.ends[f]; ++begin) face.mIndices[face.mNumIndices++] = polygons_.corners[begin];
    }
  }

  Polygons polygons_;
};

/// Takes every reader away that does not know the extension; all of them if it is empty. Otherwise assimp
/// would try what a file of that content might be instead.
void keep_readers(Assimp::Importer& importer, const std::string& extension) {
  for (size_t i = importer.GetImporterCount(); i-- > 0;) {
    Assimp::BaseImporter* reader = importer.GetImporter(i);
    std::set<std::string> known;
    reader->GetExtensionList(known);
    if (!extension.empty() && known.count(extension)) continue;
    importer.UnregisterLoader(reader);
    delete reader;
  }
}

void check_bytes(MeshFormat format, std::string_view bytes) {
  if (format == MeshFormat::obj) check_obj(bytes);
  if (format == MeshFormat::gltf) check_gltf(bytes);
  if (format == MeshFormat::fbx) check_fbx(bytes);
  if (format == MeshFormat::dae) check_dae(bytes);
  if (format == MeshFormat::three_ds) check_three_ds(bytes);
}

}  // namespace

MeshImport::MeshImport(const std::string& path, const FileReader& read_file)
    : budget_{mesh_file_tuning::most_file_bytes, 0}, files_(read_file) {
  if (!files_.has(path))
    throw Error(ErrorCode::io, "mesh file '" + path + "' is not there, or is not a file");
  const MeshFormat format = format_of(path);  // before a byte of it is read
  bytes_ = files_.read(path, budget_.file_bytes);
  budget_.reads = mesh_file_tuning::most_reads + mesh_file_tuning::most_reads_of_a_byte * bytes_.size();
  if (bytes_.empty()) throw FileDefect("is empty");
  choose_reader(path);
  check_bytes(format, bytes_);
  importer_.SetIOHandler(new BoundedFiles(path, bytes_, files_, budget_));
  importer_.SetProgressHandler(new BudgetProgress(budget_));
  import(path);
}

const aiScene& MeshImport::scene() const {
  return *importer_.GetScene();
}

void MeshImport::choose_reader(const std::string& path) {
  const MeshFormat format = format_of(path);
  const bool is_ours = format == MeshFormat::ply || format == MeshFormat::stl;
  keep_readers(importer_, is_ours ? "" : extension_of(path));
  if (!is_ours) return;
  Polygons polygons = format == MeshFormat::ply ? read_ply(bytes_) : read_stl(bytes_);
  importer_.RegisterLoader(new PolygonReader(std::move(polygons)));
}

// The scene is checked before assimp works on it, as its own steps take for granted what we look for.
void MeshImport::import(const std::string& path) {
  const aiScene* scene = importer_.ReadFile(path, 0);
  if (!scene) fail();
  check_scene(*scene);
  if (!importer_.ApplyPostProcessing(aiProcess_ValidateDataStructure)) fail();
  if (!importer_.ApplyPostProcessing(aiProcess_Triangulate)) fail();
}

void MeshImport::fail() const {
  if (const std::exception_ptr cause = importer_.GetException()) {
    try {
      std::rethrow_exception(cause);
    } catch (const std::bad_alloc&) {
      throw Error(ErrorCode::out_of_memory, "no memory for the contents of a mesh file");
    } catch (const FileDefect&) {
      throw;
    } catch (...) {
      // The importer's text says the same, and more.
    }
  }
  const std::string text = importer_.GetErrorString();
  throw FileDefect("is not valid: " + (text.empty() ? "its reader gives no reason" : text));
}

}  // namespace meniscus::collision
