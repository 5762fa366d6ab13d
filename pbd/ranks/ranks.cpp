// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calls of all ranks, made of messages between two.
#include "pbd/ranks/ranks.h"

#include <cstring>

namespace meniscus::pbd {

void Ranks::gather_everywhere(std::span<const std::byte> own, std::span<std::byte> all) {
  std::vector<Sent> sent;
  std::vector<Received> received;
  for (int r = 0; r < count(); ++r) {
    std::byte* const place = all.data() + static_cast<size_t>(r) * own.size();
    if (r == rank()) {
      std::memcpy(place, own.data(), own.size());
    } else {
      sent.push_back({r, own.data(), own.size()});
      received.push_back({r, place, own.size()});
    }
  }
  exchange(sent, received);
}

void Ranks::transpose(std::span<const uint32_t> out, std::span<uint32_t> in) {
  std::vector<Sent> sent;
  std::vector<Received> received;
  for (int r = 0; r < count(); ++r) {
    const auto k = static_cast<size_t>(r);
    if (r == rank()) {
      in[k] = out[k];
    } else {
      sent.push_back({r, &out[k], sizeof(uint32_t)});
      received.push_back({r, &in[k], sizeof(uint32_t)});
    }
  }
  exchange(sent, received);
}

void Ranks::add_up(std::span<uint64_t> values) {
  std::vector<uint64_t> all(values.size() * static_cast<size_t>(count()));
  gather_everywhere(std::as_bytes(values), std::as_writable_bytes(std::span(all)));
  for (size_t k = 0; k < values.size(); ++k) {
    values[k] = 0;
    for (size_t r = 0; r < static_cast<size_t>(count()); ++r) values[k] += all[r * values.size() + k];
  }
}

}  // namespace meniscus::pbd
