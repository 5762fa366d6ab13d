// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Counts spray, foam and bubbles.
#include "sdk/cli/record/diffuse_record.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace meniscus::cli {

DiffuseCounts counts_of(const io::DiffuseFrame& diffuse) {
  DiffuseCounts counts;
  for (const DiffuseParticle& particle : diffuse.particles) {
    switch (particle.kind) {
      case DiffuseKind::spray:
        ++counts.spray;
        break;
      case DiffuseKind::foam:
        ++counts.foam;
        break;
      case DiffuseKind::bubble:
        ++counts.bubbles;
        break;
    }
  }
  return counts;
}

void DiffuseRecord::add(const FrameSample& sample) {
  last_ = counts_of(sample.diffuse);
  most_ = std::max(most_, last_.all());
  refused_ += sample.step.diffuse_refused;
}

nlohmann::ordered_json DiffuseRecord::summary() const {
  if (!any_) return nullptr;
  return {{"spray", last_.spray},
          {"foam", last_.foam},
          {"bubbles", last_.bubbles},
          {"most", most_},
          {"refused", refused_}};
}

}  // namespace meniscus::cli
