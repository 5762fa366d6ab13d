// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A disk that is full at any write, a run that is killed at any write, and a folder that only others may
// write to. Nothing is half written under its name, and errors say why.
#include <dlfcn.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/uio.h>

#include <atomic>
#include <cerrno>

#include "tests/faults/program_runs.h"

namespace meniscus::tests {
namespace {

/// What happens to the writes of streams to files, from one of them on.
struct DiskFault {
  int first = 0;  ///< the first write that it happens to, from 1 on; 0: none
  bool kills = false;
};
DiskFault fault;
std::atomic<int> writes = 0;  // files are written by two threads

/// Whether a write is to fail now.
bool fails(int file) {
  struct stat what {};
  if (fault.first == 0 || file <= STDERR_FILENO || fstat(file, &what) != 0 || !S_ISREG(what.st_mode))
    return false;
  if (++writes < fault.first) return false;
  if (fault.kills) raise(SIGKILL);
  errno = ENOSPC;
  return true;
}

}  // namespace
}  // namespace meniscus::tests

// Streams of the standard library write by these.
extern "C" ssize_t write(int file, const void* data, size_t bytes) {
  static const auto real = reinterpret_cast<ssize_t (*)(int, const void*, size_t)>(dlsym(RTLD_NEXT, "write"));
  return meniscus::tests::fails(file) ? -1 : real(file, data, bytes);
}
extern "C" ssize_t writev(int file, const iovec* parts, int count) {
  static const auto real = reinterpret_cast<ssize_t (*)(int, const iovec*, int)>(dlsym(RTLD_NEXT, "writev"));
  return meniscus::tests::fails(file) ? -1 : real(file, parts, count);
}

namespace meniscus::tests {
namespace {

class DiskFaults : public ProgramRuns {
 protected:
  /// Calls look(exit code) for a run with a fault at each write; returns the number of runs.
  template <class Look>
  int fault_at_each_write(bool kills, const Look& look) {
    constexpr int without_fault = 77;
    for (int first = 1;; ++first) {
      SCOPED_TRACE("write " + std::to_string(first));
      fs::remove_all(out());
      const int end = end_of_run(
          [&] {
            fault = {first, kills};
          },
          [&](int code) { return writes < first ? without_fault : code; });
      if (end == without_fault || HasFailure()) return first - 1;
      look(end);
    }
  }
};

TEST_F(DiskFaults, AFullDiskIsAnErrorAtAnyWrite) {
  ASSERT_EQ(end_of_good_run(), 0);
  const auto good = files();
  const int runs = fault_at_each_write(false, [&](int end) {
    EXPECT_TRUE(end == cli::run_failed || end == cli::bad_input) << end;
    EXPECT_NE(said().find("No space left on device"), std::string::npos) << said();
    expect_no_half_file(good, false);
  });
  std::printf("%d writes\n", runs);
  EXPECT_GT(runs, 20);
}

TEST_F(DiskFaults, AKilledRunLeavesNoHalfFile) {
  ASSERT_EQ(end_of_good_run(), 0);
  const auto good = files();
  const int runs = fault_at_each_write(true, [&](int end) {
    EXPECT_EQ(end, -SIGKILL);
    expect_no_half_file(good, true);
  });
  std::printf("%d writes\n", runs);
  EXPECT_GT(runs, 20);
  EXPECT_EQ(end_of_good_run(), 0);
  expect_no_half_file(good, false);
}

TEST_F(DiskFaults, AFolderOfAnotherUserIsRefusedUnchanged) {
  fs::create_directories(out());
  std::ofstream(out() / "frames.csv") << "mine";
  fs::permissions(folder_, fs::perms(0755));
  std::ofstream(folder_ / "said.txt").flush();
  fs::permissions(folder_ / "said.txt", fs::perms(0666));
  fs::permissions(out(), fs::perms(0555));
  const auto before = files();
  const int end = end_of_run(
      [] {
        if (geteuid() == 0 && setuid(65534) != 0) std::_Exit(99);
      },
      [](int code) { return code; });
  EXPECT_EQ(end, cli::bad_input);
  EXPECT_NE(said().find("Permission denied"), std::string::npos) << said();
  EXPECT_EQ(files(), before);
  fs::permissions(out(), fs::perms(0755));
}

}  // namespace
}  // namespace meniscus::tests
