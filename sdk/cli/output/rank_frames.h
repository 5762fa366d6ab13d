// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Files of a shared world, of which each rank writes its own part.
#pragma once

#include <filesystem>
#include <string>

#include "sdk/world/shared/shared_world.h"

namespace meniscus::cli {

/// frame_00001_of_rank_2.vtp, in the folder of the frames. `kind`: "frame" or "diffuse".
std::string piece_name(const char* kind, int frame, int rank);

/// On rank 0: all ranks write the particles of a frame, and what it has of spray, foam and bubbles.
/// FOLDER/frames must be there. Throws Error(io).
void write_pieces(SharedWorld& shared, pbd::Ranks& ranks, const std::filesystem::path& folder, int frame,
                  double time);

/// On all other ranks: follows, and writes pieces when rank 0 asks for it, until it has ended.
void follow_and_write(SharedWorld& shared, pbd::Ranks& ranks, const std::filesystem::path& folder);

}  // namespace meniscus::cli
