// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Files of a shared world, of which each rank writes its own part.
#include "sdk/cli/output/rank_frames.h"

#include <meniscus/error.h>
#include <spdlog/fmt/fmt.h>

#include <vector>

#include "sdk/io/vtp.h"

namespace meniscus::cli {

namespace {

/// What rank 0 asks for when the others do not follow.
struct Order {
  int32_t frame;
  double time;  ///< s
};

void send(pbd::Ranks& ranks, const Order& order) {
  std::vector<pbd::Sent> sent;
  for (int r = 1; r < ranks.count(); ++r) sent.push_back({r, &order, sizeof order});
  ranks.exchange(sent, {});
}

Order receive(pbd::Ranks& ranks) {
  Order order{};
  const pbd::Received received{0, &order, sizeof order};
  ranks.exchange({}, {&received, 1});
  return order;
}

/// Whether all ranks could write.
bool write_piece(SharedWorld& shared, pbd::Ranks& ranks, const std::filesystem::path& folder,
                 const Order& order) {
  const ParticlesOfRank own = shared.read_own_particles();
  bool is_written = true;
  const auto path = [&](const char* kind) {
    return folder / "frames" / piece_name(kind, order.frame, ranks.rank());
  };
  try {
    io::write_vtp(path("frame"), {.time = order.time,
                                  .positions = own.positions,
                                  .velocities = own.velocities,
                                  .ids = own.ids,
                                  .fluids = own.fluids,
                                  .density_errors = own.density_errors,
                                  .pressures = own.pressures});
    if (shared.has_diffuse()) io::write_vtp(path("diffuse"), io::DiffuseFrame{order.time, own.diffuse});
  } catch (const Error&) {
    is_written = false;
  }
  return !pbd::is_on_any(ranks, !is_written);
}

}  // namespace

std::string piece_name(const char* kind, int frame, int rank) {
  return fmt::format("{}_{:05}_of_rank_{}.vtp", kind, frame, rank);
}

void write_pieces(SharedWorld& shared, pbd::Ranks& ranks, const std::filesystem::path& folder, int frame,
                  double time) {
  shared.pause();
  const Order order{frame, time};
  send(ranks, order);
  if (!write_piece(shared, ranks, folder, order))
    throw Error(ErrorCode::io,
                fmt::format("cannot write the particles of frame {}: a rank could not write to {}", frame,
                            (folder / "frames").string()));
}

void follow_and_write(SharedWorld& shared, pbd::Ranks& ranks, const std::filesystem::path& folder) {
  while (shared.follow()) write_piece(shared, ranks, folder, receive(ranks));
}

}  // namespace meniscus::cli
