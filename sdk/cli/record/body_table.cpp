// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the rows of bodies.csv.
#include "sdk/cli/record/body_table.h"

#include <spdlog/fmt/fmt.h>

namespace meniscus::cli {
namespace {

std::string fields(Vec3 v) {
  return fmt::format(",{:.7g},{:.7g},{:.7g}", v.x, v.y, v.z);
}

std::string fields(Quat q) {
  return fmt::format(",{:.7g},{:.7g},{:.7g},{:.7g}", q.x, q.y, q.z, q.w);
}

}  // namespace

BodyTable::BodyTable(std::filesystem::path path, std::vector<std::string> names)
    : file_(std::move(path),
            "frame,time_s,name,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,"
            "fluid_fx,fluid_fy,fluid_fz,fluid_tx,fluid_ty,fluid_tz"),
      names_(std::move(names)) {}

void BodyTable::add(const FrameSample& sample) {
  std::string rows;
  for (std::size_t i = 0; i < sample.bodies.size(); ++i) {
    const BodyState& body = sample.bodies[i];
    if (i > 0) rows += '\n';
    rows += fmt::format("{},{:.7g},{}", sample.frame, sample.particles.time, csv_field(names_.at(i)));
    rows += fields(body.pose.position) + fields(body.pose.rotation) + fields(body.velocity) +
            fields(body.angular_velocity) + fields(body.fluid_force) + fields(body.fluid_torque);
  }
  file_.write(rows);
}

}  // namespace meniscus::cli
