// The program evaluate_map, started as a user would.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../test_folder.h"
#include "atom_mapping/evaluation/surface_quality.h"
#include "atom_mapping/sim/make_scene.h"
#include "program_runner.h"

namespace atom_mapping {
namespace {

using nlohmann::json;

class EvaluateMap : public FolderTest {
 protected:
  json evaluate(const std::string& arguments) const {
    const std::string file = path("figures.json");
    const auto result = runProgram("evaluate_map", "--json " + file + " " + arguments, folder_);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(contents(file));
  }
};

TEST_F(EvaluateMap, AClosedSceneHasQualityAtEveryDistance) {
  const json figures = evaluate("--scene cube_rotated --radius 0.2 --scans 20 --noise 0");
  EXPECT_EQ(figures.at("scene"), "cube_rotated");
  EXPECT_EQ(figures.at("radius"), 0.2);
  const std::size_t distances = figures.at("epsilon").size();
  EXPECT_EQ(distances, 10U);
  ASSERT_EQ(figures.at("maps").size(), 3U);
  for (const json& map : figures.at("maps")) {
    SCOPED_TRACE(map.at("name").get<std::string>());
    for (const char* key : {"Q", "F", "Q_error", "F_error"}) ASSERT_EQ(map.at(key).size(), distances) << key;
    EXPECT_GT(map.at("Q").back(), map.at("Q").front());
    EXPECT_LE(map.at("F").back(), map.at("F").front());
    EXPECT_LT(map.at("Q_error").back(), 0.003);
    EXPECT_GT(map.at("units"), 50);
    EXPECT_GT(map.at("bytes"), map.at("units"));
  }
  const json& atoms = figures.at("maps")[0];
  const json& voxels = figures.at("maps")[2];
  EXPECT_EQ(voxels.at("name"), "octomap");
  for (std::size_t i = 0; i < distances; ++i) EXPECT_GT(atoms.at("Q")[i], voxels.at("Q")[i]);
}

TEST_F(EvaluateMap, AnOpenSceneHasCoverageOnly) {
  const json figures = evaluate("--scene hall --radius 1.0 2.0 --scans 2");
  ASSERT_EQ(figures.size(), 2U);
  for (const json& map : figures[1].at("maps")) {
    EXPECT_EQ(map.count("Q"), 0U);
    EXPECT_NEAR(map.at("free").get<double>() + map.at("false_occupied").get<double>() + map.at("unknown").get<double>(),
                1.0, 1e-9);
    EXPECT_GT(map.at("surface"), 0.5);
    EXPECT_GT(map.at("thin"), 0.3);
    EXPECT_EQ(map.at("near_free").size(), figures[1].at("epsilon").size());
    EXPECT_GT(map.at("ms_per_scan").at("mean"), 0.01);
  }
}

TEST_F(EvaluateMap, AtomsKeepObliqueGround) {
  const json figures = evaluate("--slope 0 10 --radius 0.25 --scans 10");
  ASSERT_EQ(figures.size(), 2U);
  for (const json& slope : figures) {
    const double atoms = slope.at("maps")[0].at("ground_kept");
    EXPECT_GE(atoms, 0.97) << slope.at("slope");
    EXPECT_GT(atoms, slope.at("maps")[2].at("ground_kept"));
  }
}

TEST_F(EvaluateMap, PicturesHoldEveryUnitAndWhatThePlaneSays) {
  const json figures = evaluate("--scene sphere --radius 0.2 --scans 10 --picture --pruned");
  ASSERT_EQ(figures.at("maps").size(), 4U);
  for (const json& map : figures.at("maps")) {
    SCOPED_TRACE(map.at("name").get<std::string>());
    EXPECT_EQ(map.at("unit_list").size(), map.at("units"));
    const json& rows = map.at("slice").at("rows");
    ASSERT_EQ(rows.size(), 160U) << "2 m and 6 radii in steps of a tenth of a radius";
    EXPECT_LT(rows[80][80], 0.0) << "the middle is free";
    EXPECT_FALSE(rows[15][80].is_number() && rows[15][80] < 0.0) << "behind the wall it is not";
  }
  EXPECT_NEAR(figures.at("maps")[0].at("unit_list")[0][3].get<double>(), 0.4, 1e-6) << "an atom's diameter";
}

TEST_F(EvaluateMap, SaysWhatIsWrong) {
  const auto result = runProgram("evaluate_map", "--scene moon", folder_);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(contains(result.err, "evaluate_map: no scene is called 'moon'")) << result.err;
  for (const std::string arguments :
       {"--noise nan", "--noise -1", "--noise 2", "--slope nan", "--slope 200", "--slope -90"}) {
    const auto refused = runProgram("evaluate_map", arguments, folder_);
    EXPECT_EQ(refused.exit_code, 2) << arguments;
    EXPECT_TRUE(contains(refused.err, arguments.substr(0, 7))) << refused.err;
    EXPECT_EQ(refused.out, "") << arguments;
  }
}

// Only chance would draw a point that near.
TEST(SurfaceQuality, EndsWhereHardlyAnyPointIsNearASurface) {
  const atom_map::Scene scene = atom_map::makeScene("cube");
  const Eigen::Vector3d sensor = Eigen::Vector3d::Zero();
  const std::vector<atom_map::ObservedRay> rays{{sensor, sensor, Eigen::Vector3d::UnitZ(), false}};
  const auto ask = [](const Eigen::Vector3d&) { return atom_map::Occupancy::kFree; };
  const auto quality = atom_map::measureQualityAtReturns(scene, rays, {0.1}, ask, 1);
  EXPECT_EQ(quality.q.at(0).whole, 0U);
  EXPECT_EQ(quality.f.at(0).whole, 0U);
}

}  // namespace
}  // namespace atom_mapping
