// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pressure of films against a dense solve in double precision, and what films bear.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "collision/film/film_loads.h"
#include "collision/film/film_solve.h"
#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

using namespace film_kernels;

/// The foot of a box, with a film under it of two thicknesses, and different pressures around it.
struct Foot {
  FilmSurfaces all;
  std::vector<BodyProxy> proxies{1};
  std::vector<Gap> gaps;
  std::vector<RimPoint> rims;
  std::vector<uint32_t> has_film{1};
  std::vector<ParticleLoad> particles{1};
  std::vector<Balance> balance{1};
  std::vector<float> pressure, wet_part, residual, direction, applied, diagonal;
  Lengths lengths{0.1f, 0.05f, 0.2f};
  std::vector<UpwardImpulse> passed_on{1};
  Vec3 gravity{0, -9.81f, 0};
  static constexpr float dt = 0.004f;
  static constexpr double displaced = 0.16 * 9810;  // N

  template <class Thickness, class Pressure>
  Foot(const Thickness& thickness, const Pressure& around) {
    const FilmPart parts[] = {
        {0, 0, {}, std::make_shared<TriangleMesh>(film_mesh(box_surface_mesh({0.5f, 0.1f, 0.4f}), 0.15f))}};
    all = join_film_parts(parts, 1);
    proxies[0] = {};
    proxies[0].pose.rotation = {0, 0, 0, 1};
    for (const FilmTriangle& t : all.triangles) {
      const bool is_below = t.area.y < -0.5f * length(t.area);
      gaps.push_back({is_below ? 1.0f : 0.0f,
                      is_below ? 0.0f : 1.0f,
                      lengths.conductance(thickness(t.centre)),
                      0,
                      {0, 1, 0},
                      0,
                      is_below ? 0.0f : 1.0f});
    }
    for (uint32_t v = 0; v < all.vertices.size(); ++v) {
      float film = 0, open = 0, conductance = 0;
      for (uint32_t k = all.first_corner[v]; k < all.first_corner[v + 1]; ++k) {
        const Gap& gap = gaps[all.corners[k].triangle];
        film += gap.film;
        open += gap.exposure;
        conductance = std::max(conductance, gap.film * gap.conductance);
      }
      rims.push_back(film > 0 ? RimPoint{open > 0 ? film_tuning::rim * conductance : 0,
                                         open > 0 ? around(all.vertices[v]) : 0, 1000, 1}
                              : RimPoint{-1, 0, 0, 0});
    }
    for (auto* values : {&pressure, &wet_part, &residual, &direction, &applied, &diagonal})
      values->resize(all.vertices.size());
  }

  template <class T>
  static pbd::View<T> view(std::vector<T>& values) {
    return {values.data(), static_cast<uint32_t>(values.size())};
  }
  /// Particles exert this much upwards (N), this far from the middle along x, m.
  void exert(float upward, float x) {
    particles[0] = {};
    particles[0].up.add(LevelAxes(gravity), upward * dt, {x, 0, 0});
  }
  /// What the film exerts upwards, N, and its moment about z, N·m.
  std::pair<double, double> exerted() {
    double sum = 0, moment = 0;
    for (size_t n = 0; n < gaps.size(); ++n) {
      const FilmTriangle& t = all.triangles[n];
      const Vec3 impulse = film_impulse(t, gaps[n], proxies[0].pose, view(pressure), dt);
      const double force = double{balance[0].upright_at(LevelAxes(gravity), t.centre) * impulse.y / dt};
      sum += force;
      moment += force * double{t.centre.x};
    }
    return {sum, moment};
  }
  void solve() {
    const Surfaces surfaces{view(all.vertices), view(all.triangles), view(all.first_corner),
                            view(all.corners),  view(all.bodies),    view(proxies)};
    pbd::CpuDevice device;
    device.parallel_for_groups("films/solve", 1,
                               SolveFilms{surfaces,
                                          view(gaps),
                                          view(rims),
                                          view(has_film),
                                          view(particles),
                                          lengths,
                                          {gravity},
                                          dt,
                                          {view(pressure), view(wet_part), view(residual), view(direction),
                                           view(applied), view(diagonal)},
                                          view(balance)});
    device.parallel_for("films/balance", 1, BalanceFilms{view(passed_on), dt, view(balance)});
  }

  /// By vertex, from the triangles' own geometry and by Gaussian elimination: the slow reference.
  std::vector<double> reference() const {
    const size_t n = all.vertices.size();
    std::vector<std::vector<double>> a(n, std::vector<double>(n + 1, 0));
    const auto column = [&](size_t v) { return 1000.0 * double{dot(gravity, all.vertices[v])}; };
    for (size_t t = 0; t < all.triangles.size(); ++t) {
      const auto& c = all.triangles[t].corner;
      const double flow = double{gaps[t].film} * double{gaps[t].conductance};
      if (flow == 0) continue;
      // ∫ ∇u·∇v of linear elements is e_u·e_v/(4 A), with the edges opposite of the corners.
      Vec3 e[3];
      for (size_t k = 0; k < 3; ++k) e[k] = all.vertices[c[(k + 2) % 3]] - all.vertices[c[(k + 1) % 3]];
      const double four_areas = 4 * double{length(all.triangles[t].area)};
      for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) a[c[i]][c[j]] += flow * double{dot(e[i], e[j])} / four_areas;
    }
    for (size_t v = 0; v < n; ++v) {
      const double exchange = rims[v].exchange < 0 ? 1 : double{rims[v].exchange};
      a[v][v] += exchange;
      a[v][n] = rims[v].exchange < 0 ? column(v) : exchange * (double{rims[v].pressure} - column(v));
    }
    for (size_t k = 0; k < n; ++k)
      for (size_t row = k + 1; row < n; ++row) {
        const double times = a[row][k] / a[k][k];
        if (times == 0) continue;
        for (size_t j = k; j <= n; ++j) a[row][j] -= times * a[k][j];
      }
    std::vector<double> x(n);
    for (size_t k = n; k-- > 0;) {
      x[k] = a[k][n];
      for (size_t j = k + 1; j < n; ++j) x[k] -= a[k][j] * x[j];
      x[k] /= a[k][k];
    }
    for (size_t v = 0; v < n; ++v) x[v] += column(v);
    return x;
  }
};

TEST(FilmSolve, IsThatOfTheDenseSystem) {
  Foot foot([](Vec3 x) { return x.x > 0 ? 0.02f : 0.05f; },
            [](Vec3 x) { return 4000 + 3000 * x.x + 1000 * x.z * x.z; });
  foot.proxies[0].pose.rotation = rotation_by({0.3f, 0, 0.2f});  // so that its weight counts
  foot.solve();
  const Quat back = conjugate(foot.proxies[0].pose.rotation);
  foot.gravity = rotate(back, foot.gravity);
  const std::vector<double> expected = foot.reference();
  double load = 0;
  for (size_t v = 0; v < expected.size(); ++v) {
    if (foot.rims[v].exchange >= 0) EXPECT_NEAR(foot.pressure[v], expected[v], 8) << v;  // 0.2 %
    load += expected[v];
  }
  EXPECT_GT(load, 0);
}

TEST(FilmSolve, TheRimHasThePressureOfTheFluid) {
  Foot foot([](Vec3) { return 0.0f; }, [](Vec3) { return 4000.0f; });
  foot.solve();
  for (size_t v = 0; v < foot.pressure.size(); ++v)
    if (foot.rims[v].exchange >= 0) EXPECT_NEAR(foot.pressure[v], 4000, 4);
}

// Whatever particles exert, and though the pressure that is read at the rim is off.
TEST(FilmSolve, BearsWhatParticlesDoNot) {
  for (const float rim : {3900.0f, 4000.0f, 4100.0f}) {
    Foot foot([](Vec3) { return 0.0f; }, [&](Vec3) { return rim; });
    for (const float by_particles : {-1600.0f, -1500.0f, 0.0f, 1000.0f}) {
      foot.exert(by_particles, 0.01f);
      foot.solve();
      const auto [force, moment] = foot.exerted();
      EXPECT_NEAR(force + double{by_particles}, Foot::displaced, 1) << rim;
      EXPECT_NEAR(moment + double{by_particles} * 0.01, 0, 0.6) << rim;  // of 16
    }
  }
}

TEST(FilmSolve, NeitherPullsNorBearsAJet) {
  Foot foot([](Vec3) { return 0.0f; }, [](Vec3) { return 4000.0f; });
  foot.exert(2000, 0);  // particles that are wedged in
  foot.solve();
  EXPECT_EQ(foot.exerted().first, 0);
  foot.exert(-3000, 0.1f);
  foot.solve();
  EXPECT_NEAR(foot.exerted().first, double{film_tuning::most_load} * 4000 * 0.8, 4);
  const auto [force, moment] = foot.exerted();
  EXPECT_NEAR(moment, double{film_tuning::most_tilt} * force / std::sqrt(12.0), 0.1 * moment);
}

// A plug whose hole is wider than a triangle: half of the foot has the pressure of air.
TEST(FilmSolve, TheFluidAroundIsThatOfWetRims) {
  Foot foot([](Vec3) { return 0.0f; }, [](Vec3 x) { return x.x < 0 ? 0.0f : 4000.0f; });
  for (size_t v = 0; v < foot.rims.size(); ++v)
    if (foot.all.vertices[v].x < 0) foot.rims[v].wetness = foot.rims[v].density = 0;
  const double on_top = -0.8 * (4000 - 0.2 * 9810);
  foot.exert(static_cast<float>(on_top), 0);
  foot.solve();
  EXPECT_NEAR(foot.balance[0].lacking.sum, 0, 10);
  EXPECT_NEAR(foot.balance[0].upright, 1, 0.01);
  EXPECT_LT(foot.balance[0].load, 0.6f * 4000 * 0.8f);
}

TEST(FilmLoads, AreOppositeOnBothFaces) {
  Foot foot([](Vec3) { return 0.0f; }, [](Vec3 x) { return 4000 + 3000 * x.x; });
  foot.solve();
  foot.proxies.push_back(foot.proxies[0]);
  foot.proxies[1].pose.position = {0.2f, -1, 0.1f};
  std::vector<Shape> shapes(1);
  shapes[0].body = 1;
  std::vector<WholeImpulse> sums(2, WholeImpulse{});
  const Surfaces surfaces{Foot::view(foot.all.vertices), Foot::view(foot.all.triangles), {}, {}, {},
                          Foot::view(foot.proxies)};
  const AddLoads add{surfaces,
                     {Foot::view(shapes), 0, {}, {}, {}},
                     Foot::view(foot.gaps),
                     Foot::view(foot.pressure),
                     Foot::view(foot.balance),
                     {},
                     {LevelAxes(foot.gravity)},
                     Foot::dt,
                     Foot::view(sums),
                     {}};
  for (uint32_t n = 0; n < foot.gaps.size(); ++n) add(n);
  EXPECT_NEAR(sums[0].at(1), 0.004 * Foot::displaced, 0.01);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(sums[0].part[k], -sums[1].part[k]);
  // Torques about one point: that of the second, moved by its centre, is the opposite of the first.
  const Vec3 force{sums[1].at(0), sums[1].at(1), sums[1].at(2)},
      torque{sums[1].at(3), sums[1].at(4), sums[1].at(5)};
  const Vec3 both = torque + cross(foot.proxies[1].pose.position, force) +
                    Vec3{sums[0].at(3), sums[0].at(4), sums[0].at(5)};
  EXPECT_LT(length(both), 1e-5f);
}

TEST(FilmSolve, IsUniformBelowTheRoughness) {
  const Lengths lengths{0.1f, 0.05f, 0.2f};
  const float rough = film_tuning::roughness * lengths.contact_radius;
  EXPECT_EQ(lengths.conductance(-0.001f), lengths.conductance(rough));
  EXPECT_NEAR(lengths.conductance(4 * rough), 64 * lengths.conductance(rough), 1e-6f);
  EXPECT_EQ(lengths.conductance(lengths.widest()), 1);
}

}  // namespace
}  // namespace meniscus::collision
