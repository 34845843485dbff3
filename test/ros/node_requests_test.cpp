// Requests that cannot be served, of every service, through nodes: refused with what was wrong, and no byte of the map changes.
#include "node_requests.h"

#include <std_srvs/Trigger.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "atom_mapping/CastRay.h"
#include "atom_mapping/CheckCollision.h"
#include "atom_mapping/ClearRegion.h"
#include "atom_mapping/ExtractSurface.h"
#include "atom_mapping/MapFile.h"
#include "atom_mapping/PlanPath.h"
#include "atom_mapping/QueryOccupancy.h"
#include "atom_mapping/QuerySignedDistance.h"

namespace atom_mapping {
namespace {

TEST_P(NodeRequests, EverythingIsAnsweredBeforeTheFirstScan) {
  if (call<MapFile>("save_map", at(path("witness.h5"))).atoms > 0) GTEST_SKIP() << "the other node's test has mapped";
  const bool is_occupancy = std::string(GetParam()) == "atom_mapping";
  QueryOccupancy::Request occupancy;
  occupancy.points.resize(2);
  EXPECT_EQ(call<QueryOccupancy>("query_occupancy", occupancy).state, (std::vector<std::uint8_t>{0, 0}));
  QuerySignedDistance::Request distance;
  distance.points.resize(2);
  const auto distances = call<QuerySignedDistance>("query_signed_distance", distance);
  EXPECT_EQ(distances.success, is_occupancy ? 0 : 1) << distances.message;
  EXPECT_EQ(distances.known.size(), is_occupancy ? 0U : 2U);
  expectRefused<PlanPath>("plan_path", {}, "unknown");
  const auto surface = call<ExtractSurface>("extract_surface", {});
  EXPECT_TRUE(surface.success) << surface.message;
  EXPECT_TRUE(surface.mesh.triangles.empty() && surface.mesh.vertices.empty() && surface.variance.empty());
  EXPECT_EQ(call<ClearRegion>("clear_region", {}).removed, 0U);
  EXPECT_TRUE(call<std_srvs::Trigger>("reset", {}).success);
  for (const char* name : {"empty.h5", "empty.ply", "empty.pcd", "empty.csv", "empty.bt"}) {
    const auto saved = call<MapFile>("save_map", at(path(name)));
    EXPECT_TRUE(saved.success) << saved.message;
    EXPECT_EQ(saved.atoms, 0U);
  }
  const auto loaded = call<MapFile>("load_map", at(path("empty.h5")));
  EXPECT_TRUE(loaded.success) << loaded.message;
}

TEST_P(NodeRequests, EmptyArraysGetEmptyAnswers) {
  const auto occupancy = call<QueryOccupancy>("query_occupancy", {});
  EXPECT_TRUE(occupancy.success && occupancy.state.empty() && occupancy.probability.empty()) << occupancy.message;
  const auto collision = call<CheckCollision>("check_collision", {});
  EXPECT_TRUE(collision.success && collision.collides.empty()) << collision.message;
  const auto rays = call<CastRay>("cast_ray", {});
  EXPECT_TRUE(rays.success && rays.result.empty() && rays.ends.empty()) << rays.message;
  const auto distance = call<QuerySignedDistance>("query_signed_distance", {});
  EXPECT_EQ(distance.success, std::string(GetParam()) == "distances" ? 1 : 0);
  EXPECT_TRUE(distance.known.empty() && distance.distance.empty() && distance.variance.empty() &&
              distance.gradient.empty());
}

TEST_P(NodeRequests, OfQueriesAtPoints) {
  QueryOccupancy::Request occupancy;
  occupancy.points.resize(2);
  expectAllRefused<QueryOccupancy>("query_occupancy", occupancy,
                                   spoiledPoints(&QueryOccupancy::Request::points, "points"));
  QuerySignedDistance::Request distance;
  distance.points.resize(2);
  if (std::string(GetParam()) == "distances") {
    expectAllRefused<QuerySignedDistance>("query_signed_distance", distance,
                                          spoiledPoints(&QuerySignedDistance::Request::points, "points"));
  } else {
    expectRefused<QuerySignedDistance>("query_signed_distance", distance,
                                       "the map is in occupancy mode; start the node with mode: signed_distance");
  }
}

TEST_P(NodeRequests, OfCollisions) {
  CheckCollision::Request good;
  good.centers.resize(2);
  good.radii.resize(2);
  auto spoilers = spoiledPoints(&CheckCollision::Request::centers, "centers");
  spoilers.push_back(
      {"a radius too few", [](auto& r) { r.radii.pop_back(); }, "centers has 2 elements and radii has 1"});
  spoilers.push_back({"no radii", [](auto& r) { r.radii.clear(); }, "centers has 2 elements and radii has 0"});
  for (const float bad : {-0.1F, -1e30F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    spoilers.push_back({"a bad radius", [=](auto& r) { r.radii[1] = bad; }, "; it must be finite and not negative"});
  }
  spoilers.push_back(
      {"a huge radius", [](auto& r) { r.radii[1] = 8.1F; }, "radii[1] is 8.1 m; it must be at most 8 m"});
  spoilers.push_back({"the hugest", [](auto& r) { r.radii[1] = 3e38F; }, "it must be at most 8 m"});
  expectAllRefused<CheckCollision>("check_collision", good, spoilers);
  good.unknown_is_free = 1;
  good.radii[1] = 3e38F;
  EXPECT_EQ(call<CheckCollision>("check_collision", good).collides.back(), 1) << "it holds all the map";
}

TEST_P(NodeRequests, OfRays) {
  CastRay::Request good;
  good.origins.resize(2);
  good.directions.resize(2);
  for (auto& direction : good.directions) direction.x = 1.0;
  good.max_range = 10.0F;
  auto spoilers = spoiledPoints(&CastRay::Request::origins, "origins");
  spoilers.push_back(
      {"too many directions", [](auto& r) { r.directions.resize(3); }, "origins has 2 elements and directions has 3"});
  spoilers.push_back(
      {"no direction", [](auto& r) { r.directions[1].x = 0.0; }, "directions[1] is (0 0 0); it must be a finite"});
  for (const double bad : {kNan, kInf, -kInf}) {
    spoilers.push_back({"a bad direction", [=](auto& r) { r.directions[1].y = bad; }, "directions[1] is ("});
  }
  for (const float bad : {-1.0F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    spoilers.push_back({"a bad range", [=](auto& r) { r.max_range = bad; }, "max_range is "});
  }
  expectAllRefused<CastRay>("cast_ray", good, spoilers);
  good.max_range = 3e38F;
  EXPECT_TRUE(call<CastRay>("cast_ray", good).success) << "it ends where the map does";
}

TEST_P(NodeRequests, OfPaths) {
  using Request = PlanPath::Request;
  std::vector<Spoiler<Request>> spoilers;
  for (geometry_msgs::PoseStamped Request::*end : {&Request::start, &Request::goal}) {
    for (const double bad : {kNan, kInf, 1e300}) {
      spoilers.push_back({"a bad place", [=](auto& r) { (r.*end).pose.position.y = bad; }, ".pose.position is ("});
    }
    spoilers.push_back({"an unknown frame", [=](auto& r) { (r.*end).header.frame_id = "nowhere"; }, "nowhere"});
  }
  for (float Request::*length :
       {&Request::robot_radius, &Request::surface_distance, &Request::surface_weight, &Request::timeout}) {
    for (const float bad : {-1.0F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
      spoilers.push_back({"a bad number", [=](auto& r) { r.*length = bad; }, "; it must be finite and not negative"});
    }
    spoilers.push_back({"a huge number", [=](auto& r) { r.*length = 1e30F; }, "; it must be at most "});
  }
  spoilers.push_back({"nowhere", [](auto& r) { r.goal.pose.position.x = 1e7; }, "unknown"});
  expectAllRefused<PlanPath>("plan_path", {}, spoilers);
}

TEST_P(NodeRequests, OfSurfaces) {
  using Request = ExtractSurface::Request;
  Request good;
  good.min = pointAt(-1.0, -1.0, -1.0);
  good.max = pointAt(1.0, 1.0, 1.0);
  std::vector<Spoiler<Request>> spoilers{
      {"an inverted box", [](auto& r) { std::swap(r.min, r.max); }, "min must be the lower corner"},
      {"a box inverted in z", [](auto& r) { r.max.z = -2.0; }, "min must be the lower corner"},
      {"another ending", [](auto& r) { r.file = path("mesh.obj"); }, "name a file that ends in .ply"},
      {"no ending", [](auto& r) { r.file = "mesh"; }, "name a file that ends in .ply"},
      {"no such folder", [](auto& r) { r.file = path("none/mesh.ply"); }, "No such file or directory"},
      {"a folder", [](auto& r) { r.file = path("folder.ply"); }, "Is a directory"},
      {"a name too long", [](auto& r) { r.file = path(std::string(300, 'a') + ".ply"); }, "File name too long"},
      {"a zero byte", [](auto& r) { r.file = std::string("/tmp/a\0.ply", 11); }, "file holds a zero byte"},
      {"where nobody writes", [](auto& r) { r.file = "/proc/mesh.ply"; }, "cannot write /proc/mesh.ply: "}};
  for (const double bad : {kNan, kInf, 1e300}) {
    spoilers.push_back({"a bad corner", [=](auto& r) { r.min.x = bad; }, "min is ("});
    spoilers.push_back({"a bad corner", [=](auto& r) { r.max.z = bad; }, "max is ("});
  }
  for (const float bad : {-1.0F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    spoilers.push_back({"a bad resolution", [=](auto& r) { r.resolution = bad; }, "resolution is "});
  }
  const auto whole = [](Request& r) { r.min = r.max = geometry_msgs::Point(); };
  for (const float fine : {1e-4F, 1e-9F, 1e-38F, 1e-45F}) {
    spoilers.push_back(
        {"too fine", [=](auto& r) { whole(r), r.resolution = fine; }, "it must be positive and at least 0.00025 m"});
  }
  spoilers.push_back({"too many cells", [=](auto& r) { whole(r), r.resolution = 0.001F; },
                      "the surface passes more than 1000 cells; ask for a smaller box"});
  expectAllRefused<ExtractSurface>("extract_surface", good, spoilers);
  for (const float coarse : {1e3F, 1e30F, 3e38F}) {
    good.resolution = coarse;
    const auto surface = call<ExtractSurface>("extract_surface", good);
    EXPECT_TRUE(surface.success) << surface.message;
    EXPECT_EQ(surface.variance.size(), surface.mesh.vertices.size());
  }
}

TEST_P(NodeRequests, OfFiles) {
  const std::string endings = "name a file that ends in .h5 for the map, in .ply";
  using Spoilers = std::vector<Spoiler<MapFile::Request>>;
  Spoilers save{
      {"no name", [](auto& r) { r.file = ""; }, "file is empty; name one, such as /tmp/map.h5"},
      {"no ending", [](auto& r) { r.file = path("map"); }, endings},
      {"a root", [](auto& r) { r.file = "/"; }, endings},
      {"another ending", [](auto& r) { r.file = path("map.obj"); }, endings},
      {"a zero byte", [](auto& r) { r.file = path(std::string("a.obj\0.h5", 9)); }, "file holds a zero byte"}};
  for (const char* name : {".h5", ".ply", ".pcd", ".csv", ".bt"}) {
    const std::string ending = name;
    save.push_back(
        {"no such folder", [=](auto& r) { r.file = path("none/map" + ending); }, "No such file or directory"});
    save.push_back(
        {"a name too long", [=](auto& r) { r.file = path(std::string(300, 'a') + ending); }, "File name too long"});
    save.push_back(
        {"where nobody writes", [=](auto& r) { r.file = "/proc/map" + ending; }, "cannot write /proc/map" + ending});
    save.push_back({"a file for a folder", [=](auto& r) { r.file = path("text.h5/map" + ending); }, "Not a directory"});
  }
  save.push_back({"a folder", [](auto& r) { r.file = path("folder.h5"); }, "Is a directory"});
  save.push_back({"a folder", [](auto& r) { r.file = path("folder.ply"); }, "Is a directory"});
  expectAllRefused<MapFile>("save_map", {}, save);

  Spoilers load{{"no name", [](auto& r) { r.file = ""; }, "file is empty"},
                {"no file", [](auto& r) { r.file = path("none.h5"); }, "No such file or directory"},
                {"a relative name", [](auto& r) { r.file = "none.h5"; }, "/none.h5: No such file or directory"},
                {"a folder", [](auto& r) { r.file = path("folder.h5"); }, "it is no regular file"},
                {"a device", [](auto& r) { r.file = "/dev/zero"; }, "it is no regular file"},
                {"a text", [](auto& r) { r.file = path("text.h5"); }, "it is no map file"},
                {"a name too long", [](auto& r) { r.file = path(std::string(5000, 'a')); }, "File name too long"},
                {"a zero byte", [](auto& r) { r.file = path(std::string("a\0b", 3)); }, "file holds a zero byte"}};
  expectAllRefused<MapFile>("load_map", {}, load);
  if (std::string(GetParam()) == "atom_mapping") {
    const auto saved = NodeClient::call<MapFile>("save_map", at(path("other.h5")), "distances");
    if (saved.atoms > 0) expectRefused<MapFile>("load_map", at(path("other.h5")), "its mode is signed_distance");
  }
}

TEST_P(NodeRequests, OfRegions) {
  using Request = ClearRegion::Request;
  Request good;
  good.min = pointAt(-100.0, -100.0, -100.0);
  good.max = pointAt(100.0, 100.0, 100.0);
  std::vector<Spoiler<Request>> spoilers;
  for (const double bad : {kNan, kInf, -kInf, 1e300}) {
    spoilers.push_back({"a bad corner", [=](auto& r) { r.min.y = bad; }, "min is ("});
    spoilers.push_back({"a bad corner", [=](auto& r) { r.max.x = bad; }, "max is ("});
  }
  for (double geometry_msgs::Point::*axis :
       {&geometry_msgs::Point::x, &geometry_msgs::Point::y, &geometry_msgs::Point::z}) {
    spoilers.push_back(
        {"an inverted box", [=](auto& r) { r.min.*axis = 101.0; }, "min must be the lower corner of the box"});
  }
  expectAllRefused<ClearRegion>("clear_region", good, spoilers);
}

INSTANTIATE_TEST_SUITE_P(Nodes, NodeRequests, testing::Values("atom_mapping", "distances"));

}  // namespace
}  // namespace atom_mapping
