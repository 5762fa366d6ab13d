// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One run at a time writes to a folder.
#pragma once

#include <filesystem>

namespace meniscus::cli {

/// Holds a folder until it is destroyed or the process ends, whatever ends it. It leaves no file. On file
/// systems without locks it does nothing.
class FolderLock {
 public:
  /// Throws Error(io) if another run holds the folder.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_;
};

}  // namespace meniscus::cli
