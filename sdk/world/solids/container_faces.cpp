// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cuts the faces of a container around its openings.
#include "sdk/world/solids/container_faces.h"

#include <algorithm>

#include "pbd/math/vec.h"

namespace meniscus {

namespace {

float Vec3::*const axes[] = {&Vec3::x, &Vec3::y, &Vec3::z};

/// The coordinates at which a face is cut along one of its axes: at its borders and at those of its openings.
std::vector<float> cuts(const std::vector<Aabb>& holes, float half, float Vec3::*axis) {
  std::vector<float> at{-half, half};
  for (const Aabb& hole : holes) {
    for (const float x : {hole.lower.*axis, hole.upper.*axis}) {
      if (x > -half && x < half) at.push_back(x);
    }
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  return at;
}

void add_pieces(std::vector<FacePiece>& pieces, Face face, Vec3 half, float beyond,
                const std::vector<Aabb>& holes) {
  const int number = static_cast<int>(face);
  float Vec3::*const normal = axes[number / 2];
  float Vec3::*const u = axes[(number / 2 + 1) % 3];
  float Vec3::*const v = axes[(number / 2 + 2) % 3];
  const std::vector<float> us = cuts(holes, half.*u + beyond, u), vs = cuts(holes, half.*v + beyond, v);
  for (size_t i = 0; i + 1 < us.size(); ++i) {
    for (size_t j = 0; j + 1 < vs.size(); ++j) {
      const float middle_u = 0.5f * (us[i] + us[i + 1]), middle_v = 0.5f * (vs[j] + vs[j + 1]);
      const bool open = std::any_of(holes.begin(), holes.end(), [&](const Aabb& hole) {
        return middle_u > hole.lower.*u && middle_u < hole.upper.*u && middle_v > hole.lower.*v &&
               middle_v < hole.upper.*v;
      });
      if (open) continue;
      FacePiece piece{face, {0, 0, 0}, {0, 0, 0}};
      piece.lower.*normal = piece.upper.*normal = number % 2 ? half.*normal : -(half.*normal);
      piece.lower.*u = us[i], piece.upper.*u = us[i + 1];
      piece.lower.*v = vs[j], piece.upper.*v = vs[j + 1];
      pieces.push_back(piece);
    }
  }
}

}  // namespace

std::vector<FacePiece> container_faces(const ContainerGeometry& container, float beyond) {
  std::vector<FacePiece> pieces;
  for (int number = 0; number < 6; ++number) {
    const Face face = static_cast<Face>(number);
    std::vector<Aabb> holes;
    bool missing = false;
    for (const Opening& opening : container.openings) {
      if (opening.face != face) continue;
      if (opening.region)
        holes.push_back(*opening.region);
      else
        missing = true;
    }
    if (!missing) add_pieces(pieces, face, container.half_extents, beyond, holes);
  }
  return pieces;
}

}  // namespace meniscus
