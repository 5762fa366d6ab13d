// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Visits records of Bullet field by field, so that files do not hold its structs as they lie in memory.
#pragma once

#include <meniscus/error.h>

#include <array>
#include <type_traits>
#include <vector>

#include "collision/rigid/bullet.h"
#include "pbd/state/state_visitor.h"

namespace meniscus::collision {

// Each field in the form that files have. What has another form than Bullet's is converted without rounding.
template <class T>
T to_plain(const T& x) {
  return x;
}
template <class T>
void from_plain(const T& x, T& to) {
  to = x;
}
inline Vec3 to_plain(const btVector3& x) {
  return {x.x(), x.y(), x.z()};
}
inline void from_plain(const Vec3& x, btVector3& to) {
  to.setValue(x.x, x.y, x.z);
}

using PlainTransform = std::array<float, 12>;  ///< the basis, row by row, then the origin

inline PlainTransform to_plain(const btTransform& x) {
  PlainTransform plain;
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) plain[static_cast<size_t>(3 * row + k)] = x.getBasis()[row][k];
    plain[static_cast<size_t>(9 + row)] = x.getOrigin()[row];
  }
  return plain;
}
inline void from_plain(const PlainTransform& x, btTransform& to) {
  to.getBasis().setValue(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8]);
  to.getOrigin().setValue(x[9], x[10], x[11]);
}

/// Visits one list for each field of the records. `fields(visit, record)` calls visit(name, field) for each.
template <class Record, class Fields>
void visit_columns(pbd::StateVisitor& v, std::vector<Record>& records, const Fields& fields) {
  auto count = static_cast<uint32_t>(records.size());
  v.value("count", count);
  if (v.restores()) records.resize(count);
  Record any{};
  uint32_t column = 0;
  fields(
      [&](const char* name, auto& field) {
        using Field = std::decay_t<decltype(field)>;
        using Plain = decltype(to_plain(field));
        // Calls use(record's field of this column) for each record.
        const auto for_each = [&](const auto& use) {
          for (Record& record : records) {
            uint32_t k = 0;
            fields(
                [&](const char*, auto& other) {
                  if constexpr (std::is_same_v<std::decay_t<decltype(other)>, Field>) {
                    if (k == column) use(other);
                  }
                  ++k;
                },
                record);
          }
        };
        std::vector<Plain> values;
        if (!v.restores()) for_each([&](const Field& x) { values.push_back(to_plain(x)); });
        v.list(name, values);
        if (values.size() != records.size())
          throw Error(ErrorCode::io, std::string("the saved list \"") + name + "\" of solids is too short");
        size_t next = 0;
        if (v.restores()) for_each([&](Field& x) { from_plain(values[next++], x); });
        ++column;
      },
      any);
}

}  // namespace meniscus::collision
