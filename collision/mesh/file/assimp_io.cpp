// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How assimp reaches files: through bounded copies in memory.
#include "collision/mesh/file/assimp_io.h"

#include <meniscus/error.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cstring>
#include <string_view>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/tuning.h"

namespace meniscus::collision {

namespace {

class MemoryStream : public Assimp::IOStream {
 public:
  MemoryStream(std::string_view bytes, std::string owned, ImportBudget& budget)
      : owned_(std::move(owned)), bytes_(owned_.empty() ? bytes : owned_), budget_(budget) {}

  size_t Read(void* to, size_t size, size_t count) override {
    const size_t whole = size ? std::min(count, (bytes_.size() - at_) / size) : 0;
    spend(1 + whole * size);
    if (whole > 0) std::memcpy(to, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    spend(1);
    if (offset > bytes_.size()) return aiReturn_FAILURE;
    size_t to = offset;
    if (origin == aiOrigin_CUR) to = at_ + offset;
    if (origin == aiOrigin_END) to = bytes_.size() - offset;
    if (to > bytes_.size()) return aiReturn_FAILURE;
    at_ = to;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return at_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  void spend(uint64_t bytes) {
    budget_.reads -= std::min(budget_.reads, bytes);
    if (budget_.spent()) throw FileDefect("is read again and again without an end");
  }

  const std::string owned_;
  const std::string_view bytes_;
  size_t at_ = 0;
  ImportBudget& budget_;
};

}  // namespace

bool BoundedFiles::Exists(const char* file) const {
  return file == path_ || files_.has(file);
}

void BoundedFiles::Close(Assimp::IOStream* stream) {
  delete stream;
}

Assimp::IOStream* BoundedFiles::Open(const char* file, const char* mode) {
  if (std::strchr(mode, 'w') || std::strchr(mode, 'a')) return nullptr;
  if (file == path_) return new MemoryStream(bytes_, {}, budget_);
  if (!Exists(file)) return nullptr;
  std::string bytes = files_.read(file, budget_.file_bytes);
  budget_.reads += mesh_file_tuning::most_reads_of_a_byte * bytes.size();
  return new MemoryStream({}, std::move(bytes), budget_);
}

}  // namespace meniscus::collision
