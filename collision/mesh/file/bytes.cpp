// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads whole files, up to a bound.
#include "collision/mesh/file/bytes.h"

#include <fcntl.h>
#include <meniscus/error.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "collision/mesh/file/defect.h"

namespace meniscus::collision {

namespace {

/// A file that is open for reading.
class Descriptor {
 public:
  // O_NONBLOCK: a pipe without a writer would be waited for.
  explicit Descriptor(const std::string& path)
      : number_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

void spend(const std::string& path, uint64_t size, uint64_t& left) {
  if (size > left) {
    throw FileDefect("takes more than the " + std::to_string(left) + " bytes that are left for it: '" + path +
                     "' has " + std::to_string(size));
  }
  left -= size;
}

std::string read_bytes(const std::string& path, uint64_t& left) {
  const auto refuse = [&path](const std::string& why) {
    throw Error(ErrorCode::io, "mesh file '" + path + "' " + why);
  };
  const Descriptor file(path);
  struct stat status {};
  if (file.number() < 0 || fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode))
    refuse("is not there, is not a file, or may not be read");
  uint64_t size = static_cast<uint64_t>(status.st_size);
  spend(path, size, left);
  std::string bytes(size, '\0');
  for (size_t done = 0; done < size;) {
    const ssize_t got = read(file.number(), bytes.data() + done, size - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) bytes.resize(size = done);  // it has become shorter
    done += static_cast<size_t>(got);
  }
  return bytes;
}

}  // namespace

bool FileSource::has(const std::string& name) const {
  std::error_code ignored;
  if (!reader_) return std::filesystem::is_regular_file(name, ignored);
  if (found_ && found_name_ == name) return true;
  found_ = reader_(name);
  found_name_ = name;
  return found_.has_value();
}

std::string FileSource::read(const std::string& name, uint64_t& left) const {
  if (!reader_) return read_bytes(name, left);
  if (!has(name)) throw Error(ErrorCode::io, "mesh file '" + name + "' is not there");
  spend(name, found_->size(), left);
  return *std::exchange(found_, std::nullopt);
}

}  // namespace meniscus::collision
