// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Messages over NCCL. They are enqueued on the world's stream, and the host does not wait for them.
#include "sdk/ranks/nccl_messages.h"

#include <cuda_runtime_api.h>
#include <meniscus/error.h>
#include <nccl.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <string>

namespace meniscus {

namespace {

void check(cudaError_t status, const char* what) {
  if (status == cudaSuccess) return;
  throw Error(ErrorCode::device, std::string(what) + ": " + cudaGetErrorString(status));
}

void check(ncclResult_t status, const char* what, ErrorCode code = ErrorCode::device) {
  if (status == ncclSuccess || status == ncclInProgress) return;
  throw Error(code, std::string(what) + " over NCCL: " + ncclGetErrorString(status));
}

/// Which GPU of which host.
struct GpuName {
  std::array<char, 64> host{};
  std::array<char, 32> bus{};

  bool operator==(const GpuName&) const = default;
};

GpuName name_of(int ordinal) {
  GpuName name;
  gethostname(name.host.data(), name.host.size() - 1);
  check(cudaDeviceGetPCIBusId(name.bus.data(), static_cast<int>(name.bus.size()), ordinal),
        "asking for a GPU's place");
  return name;
}

/// NCCL needs a GPU for each rank. All ranks find the same.
void expect_own_gpus(pbd::Ranks& ranks, int ordinal) {
  const std::vector<GpuName> names = pbd::values_of_all(ranks, name_of(ordinal));
  for (size_t b = 0; b < names.size(); ++b) {
    for (size_t a = 0; a < b; ++a) {
      if (names[a] != names[b]) continue;
      throw Error(ErrorCode::device, "ranks " + std::to_string(a) + " and " + std::to_string(b) +
                                         " have the same GPU, " + names[a].bus.data() + " of " +
                                         names[a].host.data() + ", but each rank needs one of its own");
    }
  }
}

class Messages final : public NcclMessages {
 public:
  Messages(pbd::Ranks& ranks, int ordinal) : exceptions_(std::uncaught_exceptions()) {
    expect_own_gpus(ranks, ordinal);
    check(cudaSetDevice(ordinal), "selecting a GPU");
    ncclUniqueId id{};
    if (ranks.rank() == 0) check(ncclGetUniqueId(&id), "starting");
    id = pbd::values_of_all(ranks, id)[0];
    check(ncclCommInitRank(&comm_, ranks.count(), id, ranks.rank()), "joining the ranks");
    try {
      meet(ranks);
    } catch (...) {
      ncclCommAbort(comm_);
      throw;
    }
  }
  ~Messages() override {
    // A message of a failed rank never arrives, and destroying would wait for it.
    std::uncaught_exceptions() > exceptions_ ? ncclCommAbort(comm_) : ncclCommDestroy(comm_);
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  void exchange(std::span<const pbd::Sent> sent, std::span<const pbd::Received> received,
                void* stream) override {
    const auto on = static_cast<cudaStream_t>(stream);
    check(ncclGroupStart(), "a message", ErrorCode::lost);
    for (const pbd::Received& r : received) {
      if (r.bytes)
        check(ncclRecv(r.data, r.bytes, ncclInt8, r.from, comm_, on), "a message", ErrorCode::lost);
    }
    for (const pbd::Sent& s : sent) {
      if (s.bytes) check(ncclSend(s.data, s.bytes, ncclInt8, s.to, comm_, on), "a message", ErrorCode::lost);
    }
    check(ncclGroupEnd(), "a message", ErrorCode::lost);
  }

 private:
  /// The first message between two ranks opens their connection, which takes long. So it is sent now.
  void meet(pbd::Ranks& ranks) {
    int* word = nullptr;
    check(cudaMalloc(&word, 2 * sizeof(int)), "allocating a message");
    const std::unique_ptr<int, cudaError_t (*)(void*)> owner(word, cudaFree);
    std::vector<pbd::Sent> sent;
    std::vector<pbd::Received> received;
    for (int r = 0; r < ranks.count(); ++r) {
      if (r == ranks.rank()) continue;
      sent.push_back({r, word, sizeof(int)});
      received.push_back({r, word + 1, sizeof(int)});
    }
    exchange(sent, received, cudaStreamPerThread);
    check(cudaStreamSynchronize(cudaStreamPerThread), "the first messages");
  }

  int exceptions_;
  ncclComm_t comm_ = nullptr;
};

}  // namespace

std::unique_ptr<NcclMessages> join_nccl(pbd::Ranks& ranks, int ordinal) {
  return std::make_unique<Messages>(ranks, ordinal);
}

}  // namespace meniscus
