// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes ParaView collections.
#include "sdk/io/pvd.h"

#include <spdlog/fmt/fmt.h>

#include <cerrno>

#include "sdk/files/output_file.h"
#include "sdk/io/plain_text.h"

namespace meniscus::io {
namespace {

constexpr const char* pvd_end = "</Collection>\n</VTKFile>\n";

}  // namespace

PvdFile::PvdFile(std::filesystem::path path) : path_(std::move(path)), stream_(open_afresh(path_)) {
  write_and_close(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n");
}

void PvdFile::add(double time, const std::filesystem::path& file) {
  write_and_close(fmt::format("<DataSet timestep=\"{:.7g}\" part=\"0\" file=\"{}\"/>\n", time,
                              xml_escaped(file.generic_string())));
}

void PvdFile::write_and_close(const std::string& text) {
  // The closing tags are written with the entry in one write, and the next entry overwrites them.
  const auto start = stream_.tellp();
  errno = 0;
  stream_ << text + pvd_end << std::flush;
  if (!stream_) throw_io_error("write", path_);
  stream_.seekp(start + static_cast<std::streamoff>(text.size()));
}

}  // namespace meniscus::io
