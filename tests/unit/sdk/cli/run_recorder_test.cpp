// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the tables and the summary that a run writes.
#include "sdk/cli/record/run_recorder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "sdk/cli/record/run_summary.h"

namespace meniscus::cli {
namespace {

namespace fs = std::filesystem;

class RunRecorderTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("meniscus_recorder_" + std::to_string(getpid()) + "_" +
                                           testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
    scene_.name = "pool";
    scene_.frame_time = 0.01f;
    scene_.world.gravity = {0, -10, 0};
    ShapeDef tank;
    tank.geometry = ContainerGeometry{{1, 1, 1}, {{Face::y_high, std::nullopt}}};
    tank.pose.position = {0, 3, 0};  // its floor is at y = 2
    scene_.shapes = {tank};
    scene_.fluids.resize(1);
    scene_.probes.resize(2);
    scene_.probes[0].def.name = "wall, left";
    scene_.probes[1].def = {.name = "push", .kind = ProbeKind::wall_force};
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Two particles of 1 kg at the same height.
  FrameSample sample(int frame, double height, double kinetic, float worst) {
    errors_ = {worst, -0.5f};
    positions_ = {{0, static_cast<float>(height), 0}, {1, static_cast<float>(height), 0}};
    FrameSample s;
    s.frame = frame;
    s.step.ms = 10 * frame;
    s.step.substeps = 4;
    s.step.iterations = 3;
    s.step.density_iterations = 1 + 0.5 * frame;
    s.step.removed = 1;
    s.step.emitted = 5;
    s.step.overflows = {.cloth_layers = 2, .emitter_hold = 1};
    s.step.stage_ms[static_cast<std::size_t>(Stage::solve)] = 5 * frame;
    s.diagnostics = {.particles = 2,
                     .density_error_mean = worst / 2,
                     .density_error_max = worst,
                     .density_error_interior = 0.02,
                     .kinetic_energy = kinetic,
                     .potential_energy = 2 * 10 * height,
                     .max_speed = 1.5f,
                     .contacts = 7,
                     .non_finite = 0,
                     .outside = frame == 2 ? 3u : 0u,
                     .wall_overflows = frame == 2 ? 4u : 0u};
    s.mass = 2;
    s.particles.time = 0.01 * frame;
    s.particles.positions = positions_;
    s.particles.density_errors = errors_;
    s.probes = {100.0 + frame, 3};
    s.probe_vectors = {std::nullopt, Vec3{1, 2, -2}};
    return s;
  }

  std::vector<std::string> csv(const char* name = "frames.csv") const {
    std::ifstream stream(folder_ / name);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  nlohmann::ordered_json written() const {
    return nlohmann::ordered_json::parse(std::ifstream(folder_ / "summary.json"));
  }

  fs::path folder_;
  Scene scene_;
  std::vector<float> errors_;
  std::vector<Vec3> positions_;
};

TEST_F(RunRecorderTest, ARowIsOnDiskAsSoonAsItIsKnown) {
  RunRecorder recorder(folder_, scene_);
  ASSERT_EQ(csv().size(), 1u);
  EXPECT_EQ(
      csv()[0],
      "frame,time_s,ms_predict,ms_neighbours,ms_contacts,ms_solve,ms_velocity,ms_exchange,ms_finish,ms_step,"
      "particles,"
      "density_error_mean_percent,density_error_max_percent,kinetic_j,potential_j,contacts,max_speed,non_"
      "finite,"
      "outside,substeps,removed,emitted,spray,foam,bubbles,\"wall, left\",push,push_x,push_y,push_z");
  recorder.start({"cpu", "test", true, "", 0}, sample(0, 3, 0, 0));
  recorder.add(sample(1, 3, 1.5, 0.04f));
  ASSERT_EQ(csv().size(), 2u);
  EXPECT_EQ(
      csv()[1],
      "1,0.01,0.0000,0.0000,0.0000,5.0000,0.0000,0.0000,0.0000,10.0000,2,2,4,1.5,60,7,1.5,0,0,4,1,5,0,0,0,"
      "101,3,1,2,-2");
}

TEST_F(RunRecorderTest, TheSummaryIsOfTheWholeRun) {
  RunRecorder recorder(folder_, scene_);
  recorder.start({"cpu", "test", true, "no GPU", 0}, sample(0, 3, 0, 0));
  recorder.add(sample(1, 3, 4, 0.04f));
  recorder.add(sample(2, 2.5, 4, 0.08f));
  recorder.add(sample(3, 2, 4, 0));
  const nlohmann::ordered_json figures =
      recorder.finish({.interrupted = false, .error = "", .state_hash = 0xabc, .device_bytes = 1024});
  EXPECT_EQ(written(), figures);
  EXPECT_EQ(figures["scene"], "pool");
  EXPECT_EQ(figures["device"]["reason"], "no GPU");
  EXPECT_EQ(figures["frames"], 3);
  EXPECT_EQ(figures["substeps"], 12);
  EXPECT_EQ(figures["iterations"], 3);
  EXPECT_EQ(figures["density_iterations"], 2) << "the mean over all substeps";
  EXPECT_EQ(figures["ms_per_step"]["median"], 20);
  EXPECT_EQ(figures["ms_per_step"]["p90"], 30);
  EXPECT_EQ(figures["ms_per_step"]["stages"]["solve"], 10);
  EXPECT_EQ(figures["outside"], 3) << "the most of any frame";
  EXPECT_EQ(figures["overflows"]["walls"], 4) << "the most of any frame";
  EXPECT_EQ(figures["overflows"]["cloth_layers"], 6);
  EXPECT_EQ(figures["overflows"]["cloth_failsafe"], 0);
  EXPECT_EQ(figures["overflows"]["emitter_hold"], 3);
  EXPECT_EQ(figures["removed"], 3);
  EXPECT_EQ(figures["emitted"], 15);
  EXPECT_EQ(figures["probes"]["wall, left"], 103);
  EXPECT_EQ(figures["state_hash"], "0000000000000abc");
  EXPECT_EQ(figures["interrupted"], false);
  EXPECT_TRUE(figures["error"].is_null());
  EXPECT_TRUE(fs::exists(folder_ / "density.svg"));
}

TEST_F(RunRecorderTest, DiffuseParticlesAreCountedByTheirKind) {
  scene_.world.diffuse.emplace();
  RunRecorder recorder(folder_, scene_);
  std::vector<DiffuseParticle> diffuse(6, {{}, {}, 1, DiffuseKind::foam});
  diffuse[0].kind = DiffuseKind::spray;
  diffuse[1].kind = diffuse[2].kind = DiffuseKind::bubble;
  FrameSample s = sample(1, 3, 0, 0);
  s.step.diffuse_refused = 7;
  s.diffuse.particles = diffuse;
  recorder.add(s);
  s.diffuse.particles = s.diffuse.particles.first(2);
  recorder.add(s);
  EXPECT_NE(csv()[1].find(",1,3,2,101,"), std::string::npos) << csv()[1];
  EXPECT_NE(csv()[2].find(",1,0,1,101,"), std::string::npos) << csv()[2];
  const nlohmann::ordered_json figures = recorder.finish({});
  EXPECT_EQ(
      figures["diffuse"],
      nlohmann::ordered_json({{"spray", 1}, {"foam", 0}, {"bubbles", 1}, {"most", 6}, {"refused", 14}}));
  EXPECT_NE(run_summary(figures, "out/pool", {})
                .find("1 of spray, 0 of foam, 1 bubbles at the end; 6 at most; 14 found no room"),
            std::string::npos);
}

TEST_F(RunRecorderTest, WithoutAFluidThereIsNoDensityError) {
  scene_.fluids.clear();
  RunRecorder recorder(folder_, scene_);
  recorder.add(sample(1, 3, 0, 0.5f));
  const nlohmann::ordered_json figures = recorder.finish({});
  EXPECT_TRUE(figures["density_error"].is_null());
  EXPECT_TRUE(figures["diffuse"].is_null());
  EXPECT_FALSE(fs::exists(folder_ / "density.svg"));
  const std::string text = run_summary(figures, "out/pool", {});
  EXPECT_EQ(text.find("density error"), std::string::npos);
  EXPECT_EQ(text.find("density.svg"), std::string::npos);
}

TEST_F(RunRecorderTest, DensityErrorIsOverAllParticlesAndFrames) {
  RunRecorder recorder(folder_, scene_);
  recorder.start({}, sample(0, 3, 0, 0.9f));  // before the first step: does not count
  recorder.add(sample(1, 3, 0, 0.04f));
  recorder.add(sample(2, 3, 0, 0.08f));
  const nlohmann::ordered_json error = recorder.finish({})["density_error"];
  EXPECT_NEAR(error["mean"], 100 * (0.04 + 0.08) / 4, 1e-6) << "deficits count as none";
  EXPECT_NEAR(error["max"], 8, 1e-6);
  EXPECT_NEAR(error["p99"], 8, 2e-3);
  EXPECT_NEAR(error["interior_mean"], 2, 1e-9);
}

TEST_F(RunRecorderTest, EnergyIsMeasuredFromTheFloor) {
  RunRecorder recorder(folder_, scene_);
  recorder.start({}, sample(0, 3, 0, 0));  // 2 kg, 1 m above the floor: 20 J
  recorder.add(sample(1, 2.5, 12, 0));     // 10 J and 12 J
  recorder.add(sample(2, 2, 5, 0));        // on the floor
  const nlohmann::ordered_json energy = recorder.finish({})["energy"];
  EXPECT_NEAR(energy["start_j"], 20, 1e-6);
  EXPECT_NEAR(energy["max_j"], 22, 1e-6);
  EXPECT_NEAR(energy["end_ratio"], 0.25, 1e-9);
  EXPECT_NEAR(energy["max_ratio"], 1.1, 1e-9);
  EXPECT_EQ(energy["zero_level_is"], "floor");
}

TEST_F(RunRecorderTest, WithoutAFloorEnergyIsMeasuredFromTheLowestParticle) {
  std::get<ContainerGeometry>(scene_.shapes[0].geometry).openings = {{Face::y_low, std::nullopt}};
  RunRecorder recorder(folder_, scene_);
  recorder.start({}, sample(0, 3, 0, 0));
  recorder.add(sample(1, -1, 60, 0));
  const nlohmann::ordered_json energy = recorder.finish({})["energy"];
  EXPECT_NEAR(energy["zero_level_m"], -1, 1e-6);
  EXPECT_NEAR(energy["start_j"], 2 * 10 * 4, 1e-6);
  EXPECT_NEAR(energy["end_ratio"], 60.0 / 80, 1e-9);
}

TEST_F(RunRecorderTest, ARunWithoutAStepHasASummaryToo) {
  RunRecorder recorder(folder_, scene_);
  recorder.start({"cpu", "test", true, "", 0}, sample(0, 2, 0, 0));
  const nlohmann::ordered_json figures = recorder.finish({.interrupted = true, .error = "the step met NaN"});
  EXPECT_EQ(figures["frames"], 0);
  EXPECT_EQ(figures["error"], "the step met NaN");
  EXPECT_TRUE(figures["energy"]["max_ratio"].is_null()) << "there was no energy to compare with";
  const std::string text = run_summary(figures, "out/pool", {"vtp"});
  EXPECT_NE(text.find("INTERRUPTED"), std::string::npos);
  EXPECT_NE(text.find("particles.pvd"), std::string::npos);
}

/// Two bodies; the second, once they move, has numbers that tell its members apart.
std::vector<BodyState> body_states(float x) {
  std::vector<BodyState> states(2);
  states[1] = {.pose = {{x, 2, 3}, {0.5f, -0.5f, 0.5f, 0.5f}},
               .centre_of_mass = {9, 9, 9},
               .velocity = {4, 5, 6},
               .angular_velocity = {7, 8, 9},
               .fluid_force = {10, 11, 12},
               .fluid_torque = {13, 14, 15.25f},
               .awake = false};
  return states;
}

TEST_F(RunRecorderTest, EveryBodyHasARowAFrame) {
  scene_.bodies.resize(2);
  scene_.bodies[0].def.name = "lid";
  scene_.bodies[1].def.name = "crate, red";
  RunRecorder recorder(folder_, scene_);
  FrameSample s = sample(1, 3, 0, 0);
  s.bodies = body_states(1.5f);
  recorder.add(s);
  s.frame = 2;
  recorder.add(s);
  const std::vector<std::string> lines = csv("bodies.csv");
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0],
            "frame,time_s,name,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,fluid_fx,fluid_fy,fluid_fz,fluid_tx,"
            "fluid_ty,fluid_tz");
  EXPECT_EQ(lines[1], "1,0.01,lid,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0");
  EXPECT_EQ(lines[2], "1,0.01,\"crate, red\",1.5,2,3,0.5,-0.5,0.5,0.5,4,5,6,7,8,9,10,11,12,13,14,15.25");
  EXPECT_EQ(lines[3].substr(0, 2), "2,");
}

TEST_F(RunRecorderTest, TheSummaryHasTheBodiesLastStates) {
  scene_.bodies.resize(2);
  scene_.bodies[1].def.name = "crate";
  RunRecorder recorder(folder_, scene_);
  FrameSample s = sample(0, 3, 0, 0);
  s.bodies = body_states(0);
  std::vector<BodyMass> masses(2);
  masses[1].mass = 80;
  masses[1].volume = 0.16f;
  recorder.start({"cpu", "test", true, "", 0}, s, masses);
  s.bodies = body_states(1.5f);
  s.bodies[0].awake = true;
  recorder.add(s);
  const nlohmann::ordered_json figures = recorder.finish({});
  ASSERT_EQ(figures["bodies"].size(), 2u);
  const nlohmann::ordered_json& crate = figures["bodies"][1];
  EXPECT_EQ(crate["name"], "crate");
  EXPECT_EQ(crate["mass_kg"], 80);
  EXPECT_EQ(crate["volume_m3"].get<float>(), 0.16f);
  EXPECT_EQ(crate["position_m"], nlohmann::ordered_json({1.5, 2, 3}));
  EXPECT_EQ(crate["rotation"], nlohmann::ordered_json({0.5, -0.5, 0.5, 0.5}));
  EXPECT_EQ(crate["velocity_m_s"], nlohmann::ordered_json({4, 5, 6}));
  EXPECT_EQ(crate["angular_velocity_rad_s"], nlohmann::ordered_json({7, 8, 9}));
  EXPECT_EQ(crate["fluid_force_n"], nlohmann::ordered_json({10, 11, 12}));
  EXPECT_EQ(crate["fluid_torque_n_m"], nlohmann::ordered_json({13, 14, 15.25}));
  EXPECT_EQ(crate["awake"], false);
  const std::string text = run_summary(figures, "out/pool", {"vtp"});
  EXPECT_NE(text.find("2, of which 1 awake at the end"), std::string::npos) << text;
  EXPECT_NE(text.find("bodies.csv"), std::string::npos);
  EXPECT_NE(text.find("bodies.pvd"), std::string::npos);
}

TEST_F(RunRecorderTest, WithoutBodiesThereIsNoTableOfThem) {
  RunRecorder recorder(folder_, scene_);
  recorder.add(sample(1, 3, 0, 0));
  const nlohmann::ordered_json figures = recorder.finish({});
  EXPECT_TRUE(figures["bodies"].empty());
  EXPECT_FALSE(fs::exists(folder_ / "bodies.csv"));
  EXPECT_EQ(run_summary(figures, "out/pool", {"vtp"}).find("bodies"), std::string::npos);
}

TEST_F(RunRecorderTest, ThePictureIsNamedLast) {
  RunRecorder recorder(folder_, scene_);
  recorder.start({"cpu", "test", true, "", 0}, sample(0, 3, 0, 0));
  recorder.add(sample(1, 3, 0, 0.01f));
  const std::string text = run_summary(recorder.finish({}), "out/pool", {});
  const std::string last = "The picture to open: out/pool/preview.png\n";
  ASSERT_GT(text.size(), last.size());
  EXPECT_EQ(text.substr(text.size() - last.size()), last);
}

TEST_F(RunRecorderTest, AFolderThatIsNotThereIsAnError) {
  try {
    RunRecorder recorder(folder_ / "missing", scene_);
    FAIL() << "frames.csv appeared in a folder that is not there";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    EXPECT_NE(std::string(error.what()).find("frames.csv"), std::string::npos);
  }
}

TEST(FloorLevel, IsTheLowestOfLevelPlanesAndClosedContainers) {
  Scene scene;
  EXPECT_FALSE(floor_level(scene));
  scene.shapes.resize(3);
  scene.shapes[0].geometry = PlaneGeometry{{0, 2, 0}, 3};   // y = 1.5
  scene.shapes[1].geometry = PlaneGeometry{{1, 0, 0}, -9};  // a wall
  scene.shapes[2].geometry = ContainerGeometry{{1, 1, 1}, {}};
  scene.shapes[2].pose.position = {0, 4, 0};
  EXPECT_NEAR(floor_level(scene).value(), 1.5, 1e-6);
  scene.shapes[2].pose.position = {0, 1, 0};
  EXPECT_NEAR(floor_level(scene).value(), 0, 1e-6);
  scene.world.gravity = {0, 0, 0};
  EXPECT_FALSE(floor_level(scene)) << "without gravity there is no height";
}

TEST(Percentile, IsByNearestRank) {
  EXPECT_EQ(percentile({}, 0.5), 0);
  EXPECT_EQ(percentile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0.5), 2);
  EXPECT_EQ(percentile({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 0.9), 9);
}

TEST(HistogramTest, FindsPercentilesToABin) {
  Histogram histogram(0.01, 100);
  for (int i = 1; i <= 1000; ++i) histogram.add(0.0005 * i);
  EXPECT_EQ(histogram.total(), 1000u);
  EXPECT_NEAR(histogram.percentile(0.99), 0.495, 0.0101);
  EXPECT_NEAR(histogram.percentile(0.5), 0.25, 0.0101);
  histogram.add(7);  // beyond the last bin
  EXPECT_EQ(histogram.percentile(1), 7);
  EXPECT_EQ(histogram.largest(), 7);
}

}  // namespace
}  // namespace meniscus::cli
