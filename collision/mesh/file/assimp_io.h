// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How assimp reaches files: through bounded copies in memory.
#pragma once

#include <assimp/IOSystem.hpp>
#include <assimp/ProgressHandler.hpp>
#include <cstdint>
#include <string>

#include "collision/mesh/file/bytes.h"

namespace meniscus::collision {

/// What one import may still do. Shared by its streams and its progress handler.
struct ImportBudget {
  uint64_t file_bytes;  ///< of files that are opened
  uint64_t reads;       ///< bytes that streams deliver, and one for each call
  bool spent() const { return reads == 0; }
};

/// Gives assimp the bytes of the mesh file, and of the files that it refers to. A stream throws
/// FileDefect once the budget is spent, so that a reader that circles at the end of a file comes to an end.
class BoundedFiles : public Assimp::IOSystem {
 public:
  BoundedFiles(std::string path, const std::string& bytes, const FileSource& files, ImportBudget& budget)
      : path_(std::move(path)), bytes_(bytes), files_(files), budget_(budget) {}
  BoundedFiles(std::string, std::string&&, const FileSource&,
               ImportBudget&) = delete;  // bytes are not copied

  bool Exists(const char* file) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  std::string path_;
  const std::string& bytes_;
  const FileSource& files_;
  ImportBudget& budget_;
};

/// Stops an import whose budget is spent.
class BudgetProgress : public Assimp::ProgressHandler {
 public:
  explicit BudgetProgress(const ImportBudget& budget) : budget_(budget) {}
  bool Update(float) override { return !budget_.spent(); }

 private:
  const ImportBudget& budget_;
};

}  // namespace meniscus::collision
