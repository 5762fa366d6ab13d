// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the ranks of a shared world say to each other. A rank is one process with one device.
#pragma once

#include <meniscus/error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace meniscus::pbd {

/// Bytes for another rank.
struct Sent {
  int to;
  const void* data;
  size_t bytes;
};
/// Room for the bytes of another rank, exactly as many as it sends.
struct Received {
  int from;
  void* data;
  size_t bytes;
};

/// Bytes on the host, and their place in a file.
struct FilePart {
  uint64_t offset;
  const void* data;
  size_t bytes;
};

/// Joins the ranks of one world. Each call returns when its own messages are done. Ranks make the same calls
/// in the same order, except that exchange() only concerns ranks with messages. Messages without bytes are
/// left out. A call throws Error(lost) if another rank has failed.
class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int rank() const = 0;
  virtual int count() const = 0;
  /// In memory of the host. Between two ranks, messages arrive in the order in which they were sent.
  virtual void exchange(std::span<const Sent> sent, std::span<const Received> received) = 0;
  /// The same in memory of a GPU, after use_gpu(). The messages follow what is on `stream`, a cudaStream_t,
  /// and later work there follows them. The host does not wait.
  virtual void exchange_on_gpu(std::span<const Sent> /*sent*/, std::span<const Received> /*received*/,
                               void* /*stream*/) {
    refuse_gpus();
  }
  /// Readies the ranks for exchange_on_gpu(). All call it together, each with the CUDA ordinal of its GPU.
  /// Throws Error(device) if these ranks exchange no memory of GPUs.
  virtual void use_gpu(int /*ordinal*/) { refuse_gpus(); }
  /// `all` gets the bytes of each rank, in the order of the ranks.
  virtual void gather_everywhere(std::span<const std::byte> own, std::span<std::byte> all) = 0;
  /// Element r of `out` goes to rank r. Element r of `in` is from rank r.
  virtual void transpose(std::span<const uint32_t> out, std::span<uint32_t> in) = 0;
  /// Element by element, over all ranks.
  virtual void add_up(std::span<uint64_t> values) = 0;
  /// All ranks write their parts into a file that is there. Returns whether this rank could.
  virtual bool write_to_file(const char* path, std::span<const FilePart> parts) = 0;
  /// Ends the calls of all ranks, because this one cannot go on. Over MPI it ends all processes. It takes no
  /// memory until then.
  virtual void fail(const char* why) = 0;

 private:
  [[noreturn]] static void refuse_gpus() {
    throw Error(ErrorCode::device, "these ranks exchange no memory of GPUs");
  }
};

/// The values of all ranks, in their order.
template <class T>
std::vector<T> values_of_all(Ranks& ranks, const T& own) {
  std::vector<T> all(static_cast<size_t>(ranks.count()));
  ranks.gather_everywhere(std::as_bytes(std::span(&own, 1)), std::as_writable_bytes(std::span(all)));
  return all;
}

/// The lists of all ranks, one after the other in the order of the ranks.
template <class T>
std::vector<T> lists_of_all(Ranks& ranks, std::span<const T> own) {
  const std::vector<uint64_t> counts = values_of_all(ranks, uint64_t{own.size()});
  std::vector<T> all(std::accumulate(counts.begin(), counts.end(), uint64_t{0}));
  std::vector<Sent> sent;
  std::vector<Received> received;
  T* place = all.data();
  for (int r = 0; r < ranks.count(); ++r) {
    const uint64_t count = counts[static_cast<size_t>(r)];
    if (r == ranks.rank()) {
      std::copy(own.begin(), own.end(), place);
    } else {
      sent.push_back({r, own.data(), own.size_bytes()});
      received.push_back({r, place, count * sizeof(T)});
    }
    place += count;
  }
  ranks.exchange(sent, received);
  return all;
}

/// The same on rank 0 alone. The others get nothing.
template <class T>
std::vector<T> lists_on_first(Ranks& ranks, std::span<const T> own) {
  const std::vector<uint64_t> counts = values_of_all(ranks, uint64_t{own.size()});
  if (ranks.rank() != 0) {
    const Sent sent{0, own.data(), own.size_bytes()};
    ranks.exchange({&sent, 1}, {});
    return {};
  }
  std::vector<T> all(std::accumulate(counts.begin(), counts.end(), uint64_t{0}));
  std::copy(own.begin(), own.end(), all.begin());
  std::vector<Received> received;
  T* place = all.data() + own.size();
  for (size_t r = 1; r < counts.size(); ++r) {
    received.push_back({static_cast<int>(r), place, counts[r] * sizeof(T)});
    place += counts[r];
  }
  ranks.exchange({}, received);
  return all;
}

/// Gives all ranks the values of rank 0. The others have room for as many.
template <class T>
void copy_from_first(Ranks& ranks, std::span<T> values) {
  std::vector<Sent> sent;
  for (int r = 1; r < ranks.count() && ranks.rank() == 0; ++r)
    sent.push_back({r, values.data(), values.size_bytes()});
  const Received received{0, values.data(), values.size_bytes()};
  ranks.exchange(sent, {&received, ranks.rank() == 0 ? size_t{0} : size_t{1}});
}

/// The list of rank 0, on all ranks.
template <class T>
std::vector<T> list_of_first(Ranks& ranks, std::vector<T> list) {
  uint64_t size = list.size();
  copy_from_first(ranks, std::span(&size, 1));
  list.resize(size);
  copy_from_first(ranks, std::span(list));
  return list;
}

/// Whether it is so on any rank.
inline bool is_on_any(Ranks& ranks, bool own) {
  uint64_t count = own;
  ranks.add_up({&count, 1});
  return count > 0;
}

}  // namespace meniscus::pbd
