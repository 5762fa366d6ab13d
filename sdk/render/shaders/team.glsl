// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Threads of a group take one particle of a list each; or, where there are few, several share one, and each goes over
// some of its pixels.
const uint group_size = 256u;

struct Team {
  uint size;    // threads
  ivec2 steps;  // of pixels, from one of a thread's to the next
};

Team team_for(uint particles) {
  uint bits = 0u;
  while (bits < 5u && (particles << (bits + 1u)) <= 2048u) ++bits;
  return Team(1u << bits, ivec2(1 << ((bits + 1u) / 2u), 1 << (bits / 2u)));
}

ivec2 offset_in(Team team, uint thread) {
  int lane = int(thread % team.size);
  return ivec2(lane % team.steps.x, lane / team.steps.x);
}
