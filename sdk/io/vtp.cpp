// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes VTK PolyData files.
#include "sdk/io/vtp.h"

#include <spdlog/fmt/fmt.h>

#include <bit>
#include <optional>
#include <vector>

#include "sdk/files/output_file.h"
#include "sdk/io/plain_text.h"
#include "sdk/io/point_sets.h"

namespace meniscus::io {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the arrays below are written as they lie in memory");

/// The XML and the appended data grow together, since an array's offset is the length of those before it.
class AppendedArrays {
 public:
  template <class T>
  std::string add(const char* type, const char* name, int components, std::span<const T> values) {
    const std::string xml = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        type, name, components, offset_);
    offset_ += sizeof(uint64_t) + values.size_bytes();
    blocks_.push_back(std::as_bytes(values));
    return xml;
  }

  void write(OutputFile& file) const {
    for (const std::span<const std::byte> block : blocks_) {
      const uint64_t length = block.size();
      file.write(std::span<const uint64_t>(&length, 1));
      file.write(block);
    }
  }

 private:
  std::vector<std::span<const std::byte>> blocks_;  // the arrays must outlive this
  uint64_t offset_ = 0;
};

std::vector<int64_t> counting(std::size_t count, int64_t first, int64_t step) {
  std::vector<int64_t> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = first + step * static_cast<int64_t>(i);
  return values;
}

/// Writes a PolyData file of one piece, whose XML refers to the arrays.
void write_polydata(const std::filesystem::path& path, double time, const std::string& piece,
                    const AppendedArrays& arrays) {
  OutputFile file(path);
  file.write(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n");
  file.write(
      fmt::format("<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                  "format=\"ascii\">{:.7g}</DataArray>\n</FieldData>\n",
                  time));
  file.write(piece);
  file.write("</PolyData>\n<AppendedData encoding=\"raw\">\n_");
  arrays.write(file);
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

std::string points(AppendedArrays& arrays, std::span<const Vec3> positions) {
  return "<Points>\n" + arrays.add("Float32", "Points", 3, positions) + "</Points>\n";
}

/// `offsets`: the end of each cell in `corners`.
std::string cells(AppendedArrays& arrays, std::span<const int64_t> corners,
                  std::span<const int64_t> offsets) {
  return arrays.add("Int64", "connectivity", 1, corners) + arrays.add("Int64", "offsets", 1, offsets);
}

std::vector<int64_t> corners_of(const std::vector<std::array<uint32_t, 3>>& triangles) {
  std::vector<int64_t> corners;
  for (const auto& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

/// One a vertex, where the corners at each vertex agree; else none, since the texture has a seam.
std::vector<TexturePoint> texture_by_vertex(const ClothFrame& frame) {
  if (frame.texture.empty()) return {};
  std::vector<std::optional<TexturePoint>> at(frame.vertices.size());
  for (std::size_t k = 0; k < frame.texture.size(); ++k) {
    std::optional<TexturePoint>& here = at[frame.triangles[k / 3][k % 3]];
    const TexturePoint p = frame.texture[k];
    if (here && (here->u != p.u || here->v != p.v)) return {};
    here = p;
  }
  std::vector<TexturePoint> points;
  for (const std::optional<TexturePoint>& p : at) points.push_back(p.value_or(TexturePoint{0, 0}));
  return points;
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const ParticleFrame& frame) {
  check_lengths(frame);
  const std::vector<int64_t> corners = counting(frame.size(), 0, 1), ends = counting(frame.size(), 1, 1);
  AppendedArrays arrays;
  std::string piece = fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\">\n", frame.size());
  piece += "<PointData Vectors=\"velocity\">\n";
  piece += arrays.add("Float32", "velocity", 3, frame.velocities);
  piece += arrays.add("UInt32", "fluid", 1, frame.fluids);
  piece += arrays.add("UInt64", "id", 1, frame.ids);
  piece += arrays.add("Float32", "density_error", 1, frame.density_errors);
  piece += arrays.add("Float32", "pressure", 1, frame.pressures);
  piece += "</PointData>\n" + points(arrays, frame.positions);
  piece += "<Verts>\n" + cells(arrays, corners, ends) + "</Verts>\n</Piece>\n";
  write_polydata(path, frame.time, piece, arrays);
}

namespace {

/// The arrays that all pieces of a set of points have.
template <class Frame>
constexpr const char* point_arrays = "";
template <>
constexpr const char* point_arrays<ParticleFrame> =
    "<PPointData Vectors=\"velocity\">\n"
    "<PDataArray type=\"Float32\" Name=\"velocity\" NumberOfComponents=\"3\"/>\n"
    "<PDataArray type=\"UInt32\" Name=\"fluid\"/>\n"
    "<PDataArray type=\"UInt64\" Name=\"id\"/>\n"
    "<PDataArray type=\"Float32\" Name=\"density_error\"/>\n"
    "<PDataArray type=\"Float32\" Name=\"pressure\"/>\n"
    "</PPointData>\n";
template <>
constexpr const char* point_arrays<DiffuseFrame> =
    "<PPointData Scalars=\"kind\" Vectors=\"velocity\">\n"
    "<PDataArray type=\"Float32\" Name=\"velocity\" NumberOfComponents=\"3\"/>\n"
    "<PDataArray type=\"Float32\" Name=\"life\"/>\n"
    "<PDataArray type=\"UInt32\" Name=\"kind\"/>\n"
    "</PPointData>\n";

}  // namespace

template <class Frame>
void write_pvtp(const std::filesystem::path& path, std::span<const std::string> pieces) {
  OutputFile file(path);
  file.write(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PPolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PPolyData GhostLevel=\"0\">\n");
  file.write(point_arrays<Frame>);
  file.write(
      "<PPoints>\n"
      "<PDataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
      "</PPoints>\n");
  for (const std::string& piece : pieces)
    file.write(fmt::format("<Piece Source=\"{}\"/>\n", xml_escaped(piece)));
  file.write("</PPolyData>\n</VTKFile>\n");
  file.commit();
}
template void write_pvtp<ParticleFrame>(const std::filesystem::path& path,
                                        std::span<const std::string> pieces);
template void write_pvtp<DiffuseFrame>(const std::filesystem::path& path,
                                       std::span<const std::string> pieces);

void write_vtp(const std::filesystem::path& path, const DiffuseFrame& frame) {
  const std::size_t count = frame.particles.size();
  const DiffusePoints diffuse = diffuse_points(frame.particles);
  const std::vector<int64_t> corners = counting(count, 0, 1), ends = counting(count, 1, 1);
  AppendedArrays arrays;
  std::string piece = fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\">\n", count);
  piece += "<PointData Scalars=\"kind\" Vectors=\"velocity\">\n";
  piece += arrays.add("Float32", "velocity", 3, std::span<const Vec3>(diffuse.velocities));
  piece += arrays.add("Float32", "life", 1, std::span<const float>(diffuse.lives));
  piece += arrays.add("UInt32", "kind", 1, std::span<const uint32_t>(diffuse.kinds));
  piece += "</PointData>\n" + points(arrays, diffuse.positions);
  piece += "<Verts>\n" + cells(arrays, corners, ends) + "</Verts>\n</Piece>\n";
  write_polydata(path, frame.time, piece, arrays);
}

void write_vtp(const std::filesystem::path& path, const SurfaceFrame& frame) {
  const std::vector<int64_t> corners = corners_of(frame.triangles);
  const std::vector<int64_t> ends = counting(frame.triangles.size(), 3, 3);
  AppendedArrays arrays;
  std::string piece = fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n",
                                  frame.vertices.size(), frame.triangles.size());
  piece += "<PointData Vectors=\"velocity\">\n" +
           arrays.add("Float32", "velocity", 3, std::span<const Vec3>(frame.velocities)) + "</PointData>\n";
  piece += fmt::format("<CellData Scalars=\"{}\">\n", frame.kind) +
           arrays.add("UInt32", frame.kind, 1, std::span<const uint32_t>(frame.bodies)) + "</CellData>\n";
  piece += points(arrays, frame.vertices);
  piece += "<Polys>\n" + cells(arrays, corners, ends) + "</Polys>\n</Piece>\n";
  write_polydata(path, frame.time, piece, arrays);
}

void write_vtp(const std::filesystem::path& path, const ClothFrame& frame) {
  const std::vector<TexturePoint> by_vertex = texture_by_vertex(frame);
  const std::vector<int64_t> corners = corners_of(frame.triangles);
  const std::vector<int64_t> ends = counting(frame.triangles.size(), 3, 3);
  AppendedArrays arrays;
  std::string piece = fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n",
                                  frame.vertices.size(), frame.triangles.size());
  piece += fmt::format("<PointData Vectors=\"velocity\" Normals=\"Normals\"{}>\n",
                       by_vertex.empty() ? "" : " TCoords=\"TCoords\"");
  piece += arrays.add("Float32", "velocity", 3, std::span<const Vec3>(frame.velocities));
  piece += arrays.add("Float32", "Normals", 3, std::span<const Vec3>(frame.normals));
  if (!by_vertex.empty())
    piece += arrays.add("Float32", "TCoords", 2, std::span<const TexturePoint>(by_vertex));
  piece += "</PointData>\n<CellData Scalars=\"strain\">\n";
  if (!frame.texture.empty())
    piece += arrays.add("Float32", "texture", 6, std::span<const TexturePoint>(frame.texture));
  piece += arrays.add("UInt32", "cloth", 1, std::span<const uint32_t>(frame.pieces));
  piece += arrays.add("Float32", "strain", 1, std::span<const float>(frame.strains));
  piece += "</CellData>\n" + points(arrays, frame.vertices);
  piece += "<Polys>\n" + cells(arrays, corners, ends) + "</Polys>\n</Piece>\n";
  write_polydata(path, frame.time, piece, arrays);
}

void write_vtp(const std::filesystem::path& path, const LiquidFrame& frame) {
  const std::vector<int64_t> corners = corners_of(frame.triangles);
  const std::vector<int64_t> ends = counting(frame.triangles.size(), 3, 3);
  AppendedArrays arrays;
  std::string piece = fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n",
                                  frame.vertices.size(), frame.triangles.size());
  piece += "<PointData Vectors=\"velocity\" Normals=\"Normals\">\n" +
           arrays.add("Float32", "velocity", 3, std::span<const Vec3>(frame.velocities)) +
           arrays.add("Float32", "Normals", 3, std::span<const Vec3>(frame.normals)) + "</PointData>\n";
  piece += "<CellData Scalars=\"fluid\">\n" +
           arrays.add("UInt32", "fluid", 1, std::span<const uint32_t>(frame.fluids)) + "</CellData>\n";
  piece += points(arrays, frame.vertices);
  piece += "<Polys>\n" + cells(arrays, corners, ends) + "</Polys>\n</Piece>\n";
  write_polydata(path, frame.time, piece, arrays);
}

void write_vtp(const std::filesystem::path& path, const RopeFrame& frame) {
  std::vector<int64_t> corners, ends;
  std::vector<uint32_t> ropes;
  std::vector<float> radii(frame.vertices.size());
  for (std::size_t i = 0; i < frame.lines.size(); ++i) {
    for (const uint32_t v : frame.lines[i]) radii[v] = frame.radii[i];
    corners.insert(corners.end(), frame.lines[i].begin(), frame.lines[i].end());
    ends.push_back(static_cast<int64_t>(corners.size()));
    ropes.push_back(static_cast<uint32_t>(i));
  }
  AppendedArrays arrays;
  std::string piece = fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfLines=\"{}\">\n",
                                  frame.vertices.size(), frame.lines.size());
  piece += "<PointData Scalars=\"radius\" Vectors=\"velocity\">\n";
  piece += arrays.add("Float32", "velocity", 3, std::span<const Vec3>(frame.velocities));
  piece += arrays.add("Float32", "radius", 1, std::span<const float>(radii));
  piece += "</PointData>\n<CellData Scalars=\"rope\">\n" +
           arrays.add("UInt32", "rope", 1, std::span<const uint32_t>(ropes)) + "</CellData>\n";
  piece += points(arrays, frame.vertices);
  piece += "<Lines>\n" + cells(arrays, std::span<const int64_t>(corners), std::span<const int64_t>(ends)) +
           "</Lines>\n</Piece>\n";
  write_polydata(path, frame.time, piece, arrays);
}

}  // namespace meniscus::io
