// The search of a path over the graph that free atoms make (paper IV-A).
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "atom_mapping/map/hash_center.h"
#include "atom_mapping/planning/clearance.h"

namespace atom_map {

// What a path should be like; lengths in metres.
struct PathPreference {
  float robot_radius = 0.3F;
  float surface_distance = 1.0F;  // q
  float surface_weight = 0.0F;    // mu, 1/m; 0: the shortest path
};

// A point of a path, in the map's local frame.
struct Waypoint {
  Eigen::Vector3f position;
  float surface_distance;  // as far as the search looked
};

// The point, and how far from surfaces it lies if that is asked for up to `reach` (m) > 0.
Waypoint makeWaypoint(const Eigen::Vector3f& point, float reach, Clearance& clearance);

// How far (m) the cost looks for surfaces.
// Choice: from 16 radii beyond q on all distances cost the same, or a look around in an open space would see all of it.
float surfaceReach(const PathPreference& preference, float radius);

// Of a straight way.
// Choice: Eq. (12)'s surface term is integrated along the way, taken as linear between its ends: |a - b| (1 + mu mean).
// So a path's cost does not depend on how densely atoms lie, A* finds the path of least cost, and a greater mu never
// gives a greater mean of | |sdf| - q |.
double wayCost(const Waypoint& a, const Waypoint& b, const PathPreference& preference);

// A* over free atoms whose centers lie less than four radii apart and between which the robot is safe. Start and goal are
// joined to the graph as atoms are, where the way to them is known. Without a surface term the path is the shortest.
//
// The search may be interrupted and the map change meanwhile: it keeps positions and no references. A path that it finds
// was safe when its parts were looked at.
class PathSearch {
 public:
  enum class State { kSearching, kFound, kExhausted };

  // Start and goal as in the rules, and safe. `radius` of the atoms. A path that costs more than max_cost is none.
  PathSearch(const Waypoint& start, const Waypoint& goal, float radius, const PathPreference& preference,
             const SafetyRules& rules, double max_cost = std::numeric_limits<double>::infinity());

  // Searches until it is done or, up to a millisecond late, until the deadline.
  State advance(const AtomMap& map, std::chrono::steady_clock::time_point deadline);

  std::vector<Waypoint> path() const;                 // from start to goal, once found
  double cost() const { return nodes_[kGoal].cost; }  // of it
  std::uint32_t expanded() const { return expanded_; }
  // Of what was reached, the nearest to the goal.
  const Eigen::Vector3f& nearest() const { return nodes_[nearest_].at.position; }

 private:
  using Node = std::uint32_t;
  static constexpr Node kStart = 0;
  static constexpr Node kGoal = 1;
  struct Record {
    Waypoint at;
    bool is_safe;  // whether the robot may be here; looked up once
    bool is_closed = false;
    Node parent = kStart;  // and the cost from the start, once closed
    double cost = 0.0;
  };
  // A way to a node. Whether it is safe is looked at when nothing better is left: far fewer are than there are ways.
  struct Way {
    double estimate;  // of a path by it to the goal
    double cost;
    Node node;
    Node parent;

    bool operator>(const Way& other) const { return estimate > other.estimate; }
  };

  bool accept(const Way& way, Clearance& clearance);
  void expand(Node node, const AtomMap& map, Clearance& clearance);
  Node find(ConstAtomRef atom, Clearance& clearance);
  void propose(Node from, Node to);
  bool isSafeWay(Node from, Node to, Clearance& clearance) const;

  float radius_;
  PathPreference preference_;
  SafetyRules rules_;
  float reach_;
  double max_cost_;
  std::vector<Record> nodes_;
  std::unordered_map<Eigen::Vector3f, Node, HashCenter> atoms_;
  std::vector<Way> open_;  // a heap, the least estimate on top
  std::uint32_t expanded_ = 0;
  Node nearest_ = kStart;
};

}  // namespace atom_map
