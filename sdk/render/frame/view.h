// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// View and projection matrices.
#pragma once

#include <Eigen/Core>

#include <meniscus/scene.h>
#include "pbd/math/vec.h"

namespace meniscus::render {

using Matrix4 = Eigen::Matrix4f;

/// A camera as OpenGL uses it. View space has x to the right and y up, and looks along −z.
struct View {
  Matrix4 view, projection;
  float tan_x = 1, tan_y = 1;           ///< of half the opening angles
  float near_plane = 0, far_plane = 0;  ///< m
};

/// The view matrix from `position` towards `target`; `up` need not be orthogonal to that.
Matrix4 look_at(Vec3 position, Vec3 target, Vec3 up);

/// Everything within `radius` of `centre` lies between the planes. The near plane is as far away as that
/// allows.
View camera_view(const SceneCamera& camera, Vec3 up, float aspect, Vec3 centre, float radius);

/// The view of parallel light: the ball just fits into it.
View sun_view(Vec3 to_sun, Vec3 centre, float radius);

/// The matrix of a placement.
Matrix4 matrix_of(const Pose& pose);

}  // namespace meniscus::render
