// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One run at a time writes to a folder.
#include "sdk/cli/output/folder_lock.h"

#include <fcntl.h>
#include <meniscus/error.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace meniscus::cli {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0 || flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(folder_);
  throw Error(ErrorCode::io,
              "another run writes to the folder " + folder.string() + "; choose another by --out");
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

}  // namespace meniscus::cli
