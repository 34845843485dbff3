#include "atom_mapping/sim/make_scene.h"

#include <stdexcept>

namespace atom_map {
namespace {

using Eigen::Vector3d;

Scene makeCube(const std::string& name, const Eigen::AngleAxisd& turn) {
  const Eigen::Isometry3d pose(turn);
  const Eigen::AlignedBox3d bounds = Eigen::AlignedBox3d(-Vector3d::Ones(), Vector3d::Ones()).transformed(pose);
  return Scene(name, {{makeBox(pose, Vector3d::Constant(2.0)), SurfaceKind::kWall, true}}, bounds);
}

Scene makeSphere() {
  const Sphere sphere{Vector3d::Zero(), 1.0};
  return Scene("sphere", {{sphere, SurfaceKind::kWall, true}}, {-Vector3d::Ones(), Vector3d::Ones()});
}

std::string unknownScene(const std::string& name) {
  std::string message = "no scene is called '" + name + "'; there are";
  for (const std::string& known : sceneNames()) message += " " + known;
  return message;
}

}  // namespace

std::vector<std::string> sceneNames() {
  return {"cube", "cube_rotated", "sphere", "hall", "campus"};
}

Scene makeScene(const std::string& name) {
  if (name == "cube") return makeCube(name, Eigen::AngleAxisd::Identity());
  if (name == "cube_rotated") return makeCube(name, Eigen::AngleAxisd(0.6, Vector3d(1.0, 2.0, 3.0).normalized()));
  if (name == "sphere") return makeSphere();
  if (name == "hall") return makeHall();
  if (name == "campus") return makeCampus();
  throw std::invalid_argument(unknownScene(name));
}

}  // namespace atom_map
