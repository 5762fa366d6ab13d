// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Messages over MPI.
#include <meniscus/error.h>
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>

#include "sdk/ranks/launcher.h"
#include "sdk/ranks/mpi_ranks.h"
#include "sdk/ranks/nccl_messages.h"
#include "sdk/ranks/watchdog.h"

namespace meniscus {

namespace {

/// Bytes of one message at most: MPI counts with an int.
constexpr size_t most_bytes = size_t{1} << 30;

/// Calls visit(offset, bytes) for each part of a message.
template <class Visit>
void for_each_part(size_t bytes, const Visit& visit) {
  for (size_t at = 0; at < bytes; at += most_bytes)
    visit(at, static_cast<int>(std::min(most_bytes, bytes - at)));
}

class MpiRanks final : public pbd::Ranks {
 public:
  MpiRanks() : exceptions_(std::uncaught_exceptions()) {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    watchdog_.emplace(provided == MPI_THREAD_MULTIPLE ? limit() : 0);
  }
  ~MpiRanks() override {
    if (std::uncaught_exceptions() > exceptions_) fail("it ended early");
    between_gpus_.reset();
    watchdog_.reset();
    MPI_Finalize();
  }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  void exchange(std::span<const pbd::Sent> sent, std::span<const pbd::Received> received) override {
    requests_.clear();
    for (const pbd::Received& r : received) {
      for_each_part(r.bytes, [&](size_t at, int bytes) {
        requests_.emplace_back();
        MPI_Irecv(static_cast<std::byte*>(r.data) + at, bytes, MPI_BYTE, r.from, 0, MPI_COMM_WORLD,
                  &requests_.back());
      });
    }
    for (const pbd::Sent& s : sent) {
      for_each_part(s.bytes, [&](size_t at, int bytes) {
        requests_.emplace_back();
        MPI_Isend(static_cast<const std::byte*>(s.data) + at, bytes, MPI_BYTE, s.to, 0, MPI_COMM_WORLD,
                  &requests_.back());
      });
    }
    finish();
  }
  void exchange_on_gpu(std::span<const pbd::Sent> sent, std::span<const pbd::Received> received,
                       void* stream) override {
    between_gpus_->exchange(sent, received, stream);
  }
  void use_gpu(int ordinal) override { between_gpus_ = join_nccl(*this, ordinal); }
  void gather_everywhere(std::span<const std::byte> own, std::span<std::byte> all) override {
    const auto bytes = static_cast<int>(own.size());
    MPI_Iallgather(own.data(), bytes, MPI_BYTE, all.data(), bytes, MPI_BYTE, MPI_COMM_WORLD, &only_request());
    finish();
  }
  void transpose(std::span<const uint32_t> out, std::span<uint32_t> in) override {
    MPI_Ialltoall(out.data(), 1, MPI_UINT32_T, in.data(), 1, MPI_UINT32_T, MPI_COMM_WORLD, &only_request());
    finish();
  }
  void add_up(std::span<uint64_t> values) override {
    MPI_Iallreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_UINT64_T, MPI_SUM,
                   MPI_COMM_WORLD, &only_request());
    finish();
  }
  bool write_to_file(const char* path, std::span<const pbd::FilePart> parts) override {
    MPI_File file = MPI_FILE_NULL;
    if (MPI_File_open(MPI_COMM_WORLD, path, MPI_MODE_WRONLY, MPI_INFO_NULL, &file) != MPI_SUCCESS)
      return false;
    bool is_written = true;
    for (const pbd::FilePart& part : parts) {
      for_each_part(part.bytes, [&](size_t at, int bytes) {
        MPI_Status status{};
        int written = 0;
        const int result =
            MPI_File_write_at(file, static_cast<MPI_Offset>(part.offset + at),
                              static_cast<const std::byte*>(part.data) + at, bytes, MPI_BYTE, &status);
        MPI_Get_count(&status, MPI_BYTE, &written);
        is_written &= result == MPI_SUCCESS && written == bytes;
      });
    }
    return MPI_File_close(&file) == MPI_SUCCESS && is_written;
  }
  void fail(const char* why) override {
    std::fprintf(stderr, "meniscus: rank %d of %d failed: %s; all ranks end\n", rank_, count_, why);
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }

 private:
  MPI_Request& only_request() {
    requests_.resize(1);
    return requests_.front();
  }
  /// Waits for all requests, or ends all processes if a rank does not arrive.
  void finish() {
    watchdog_->wait_for(requests_, [&](const char* why) { fail(why); });
  }
  /// s, see join_mpi().
  static double limit() {
    const char* const set = std::getenv("MENISCUS_RANK_LIMIT");
    return set ? std::strtod(set, nullptr) : 20;
  }

  int exceptions_;
  int rank_ = 0, count_ = 1;
  std::vector<MPI_Request> requests_;
  std::unique_ptr<NcclMessages> between_gpus_;
  std::optional<Watchdog> watchdog_;
};

}  // namespace

std::unique_ptr<pbd::Ranks> join_mpi() {
  if (launched_processes() <= 1) return nullptr;
  return std::make_unique<MpiRanks>();
}

}  // namespace meniscus
