// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/io/vtp.h"

#include <spdlog/fmt/fmt.h>

#include <bit>
#include <numeric>
#include <vector>

#include "sdk/io/output_file.h"

namespace meniscus::io {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the arrays below are written as they lie in memory");

/// One array of the file: its name in the XML, and the block that the XML points to.
struct Block {
  const char* type;
  const char* name;
  int components;
  std::span<const std::byte> bytes;
};

template <class T>
Block block(const char* type, const char* name, int components, std::span<const T> values) {
  return {type, name, components, std::as_bytes(values)};
}

/// The XML and the appended data grow together, since an array's offset is the length of those before it.
class VtpWriter {
 public:
  explicit VtpWriter(const ParticleFrame& frame) : frame_(frame), first_(frame.size()), past_(frame.size()) {
    std::iota(first_.begin(), first_.end(), int64_t{0});
    std::iota(past_.begin(), past_.end(), int64_t{1});
  }

  void write(OutputFile& file) {
    file.write(document());
    for (const Block& b : blocks_) {
      const uint64_t length = b.bytes.size();
      file.write(std::span<const uint64_t>(&length, 1));
      file.write(b.bytes);
    }
    file.write("\n</AppendedData>\n</VTKFile>\n");
  }

 private:
  std::string data_array(Block b) {
    const std::string xml = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        b.type, b.name, b.components, offset_);
    offset_ += sizeof(uint64_t) + b.bytes.size();
    blocks_.push_back(b);
    return xml;
  }

  std::string point_data() {
    return data_array(block("Float32", "velocity", 3, frame_.velocities)) +
           data_array(block("UInt32", "fluid", 1, frame_.fluids)) +
           data_array(block("UInt64", "id", 1, frame_.ids)) +
           data_array(block("Float32", "density_error", 1, frame_.density_errors)) +
           data_array(block("Float32", "pressure", 1, frame_.pressures));
  }

  std::string vertex_cells() {
    return data_array(block("Int64", "connectivity", 1, std::span<const int64_t>(first_))) +
           data_array(block("Int64", "offsets", 1, std::span<const int64_t>(past_)));
  }

  std::string document() {
    std::string xml =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>\n";
    xml += fmt::format(
        "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
        "format=\"ascii\">{:.7g}"
        "</DataArray>\n</FieldData>\n",
        frame_.time);
    xml += fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\">\n", frame_.size());
    xml += "<PointData Vectors=\"velocity\">\n" + point_data() + "</PointData>\n";
    xml += "<Points>\n" + data_array(block("Float32", "Points", 3, frame_.positions)) + "</Points>\n";
    xml += "<Verts>\n" + vertex_cells() + "</Verts>\n";
    return xml + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  }

  const ParticleFrame& frame_;
  std::vector<int64_t> first_, past_;
  std::vector<Block> blocks_;
  uint64_t offset_ = 0;
};

constexpr const char* pvd_end = "</Collection>\n</VTKFile>\n";

}  // namespace

void write_vtp(const std::filesystem::path& path, const ParticleFrame& frame) {
  check_lengths(frame);
  OutputFile file(path);
  VtpWriter(frame).write(file);
  file.commit();
}

PvdFile::PvdFile(std::filesystem::path path) : path_(std::move(path)) {
  errno = 0;
  stream_.open(path_, std::ios::binary | std::ios::trunc);
  if (!stream_) throw_io_error("write", path_);
  write_and_close(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n");
}

void PvdFile::add(double time, const std::filesystem::path& file) {
  write_and_close(fmt::format("<DataSet timestep=\"{:.7g}\" part=\"0\" file=\"{}\"/>\n", time,
                              xml_escaped(file.generic_string())));
}

void PvdFile::write_and_close(const std::string& text) {
  // The closing tags go out with the entry in one write, and the next entry starts on top of them.
  const auto start = stream_.tellp();
  errno = 0;
  stream_ << text + pvd_end << std::flush;
  if (!stream_) throw_io_error("write", path_);
  stream_.seekp(start + static_cast<std::streamoff>(text.size()));
}

}  // namespace meniscus::io
