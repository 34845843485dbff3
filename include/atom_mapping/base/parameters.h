// Every parameter of the package, one struct a group, as they lie under a node's `~`. These defaults are the only ones;
// config/atom_mapping.yaml repeats them for the reader and a test holds the two equal. describe_parameters.h gives each
// its permitted range and unit.
#pragma once

#include <cstdint>
#include <string>

namespace atom_map {

enum class Mode { kOccupancy, kSignedDistance };

// scan/: which returns are used, and what is known of the sensor.
struct ScanParameters {
  double min_range = 0.5;              // m, nearer returns are dropped (the robot itself)
  double max_range = 25.0;             // m, farther returns are discarded (paper V-B)
  double thinning = 0.5;               // atomic radii, one return is kept a cubic cell of this side; 0 keeps all
  double horizontal_resolution = 0.2;  // deg between firings (VLP-16 at 10 Hz)
  double vertical_resolution = 2.0;    // deg between rings (VLP-16)
  double range_noise = 0.02;           // m, standard deviation of one range
  double normal_support = 0.15;        // m, half the least width of the neighbourhood that a normal is fitted to
  double shared_normals = 2.0;    // atomic radii, side of cells whose returns share a normal if on one plane; 0: none
  double thin_width = 0.5;        // m, things up to this width that stand free are kept as thin
  bool clear_no_returns = false;  // rays without an echo free the space up to max_range
};

// rays/: candidates (paper III-C) and stochastic angular interleaving (paper III-D).
struct RayParameters {
  // Choice: less than the paper's 1, which thins less: holes are found and filled when candidates are merged.
  double lambda = 0.25;          // cost of a hole in Eq. (2)
  double max_incidence = 84.0;   // deg, bound of the angle between ray and normal in step B
  double normal_distance = 2.0;  // m, how far step C reaches along the normal
  double candidate_cell = 1.0;   // atomic diameters, side of the candidate filter's cells; 0 keeps all
};

// occupancy/: the update of Eq. (3).
struct OccupancyParameters {
  // Equal weights and clamps on both sides: unequal ones shift the interpolated surface to the weaker side.
  double hit_probability = 0.7;   // occupancy that a return tells of
  double miss_probability = 0.3;  // occupancy that a ray passing by tells of
  double thin_weight = 2.0;       // of the log-odds of a thing narrower than scan/thin_width
  double hold_reach = 1.5;        // radii from its atom within which a return keeps others from being lowered
  double max_log_odds = 1.5;      // clamp, on both sides
};

// signed_distance/: the fusion of Eq. (9) to (11).
struct SignedDistanceParameters {
  double xi = 0.5;  // numerical stability in Eq. (9)
};

// gaussian_process/: regression over the nearest atoms (Eq. 6 to 8). Lengths in radii, so that one setting fits any.
struct GaussianProcessParameters {
  bool answers_occupancy = true;      // occupancy queries ask it; false: they ask Eq. (5)
  std::uint32_t neighbors = 20;       // N, nearest atoms that a query is trained on
  double alpha = 0.12;                // of the log-odds' kernel exp(-alpha d^2), d in radii
  double noise_variance = 0.05;       // sigma_n^2 of the log-odds, in units of the kernel's variance, which is 1
  double distance_alpha = 0.01;       // the same of signed distances, which are smoother
  double distance_noise = 0.005;      // sigma_n^2 of signed distances, in squared radii
  double atom_variance_share = 0.03;  // of an atom's own variance, added to sigma_n^2 of its signed distance
};

// surface/: extraction of the implicit surface.
struct SurfaceParameters {
  double occupancy_deviation = 0.5;   // radii, standard deviation of the surface's place beyond which it is left out
  double distance_deviation = 0.068;  // the same in signed distance mode
};

// planning/: paths through free space (paper IV-A). The first three are those of goals that come without their own.
struct PlanningParameters {
  double robot_radius = 0.3;      // m, of a sphere that holds the robot
  double surface_distance = 1.0;  // q, m: distance to surfaces that a path prefers to keep
  double surface_weight = 0.0;    // mu, 1/m: cost of a metre's deviation from it, for each metre of path
  double timeout = 5.0;           // s of wall time that planning may take
  bool shortcut = true;           // whether paths leave the atoms where a straight way is safe and costs less
};

enum class LimitPolicy { kRefuse, kForgetFarthest };

// limits/: how much of the world the map keeps.
struct LimitParameters {
  std::uint32_t max_atoms = 0;  // 0: as many as there are
  double max_megabytes = 0.0;   // 10^6 bytes of atoms and index, AtomTree::bytes(); 0: as many as they take
  LimitPolicy policy = LimitPolicy::kRefuse;  // of a map that is full: no new atoms, or none of the farthest
  double window = 0.0;                        // m, about the sensor; what lies farther is forgotten; 0: nothing
};

// OctoMap beside the atom map, fed with the same scans.
struct OctomapParameters {
  double resolution = 0.0;  // m, side of a voxel; 0: that of a voxel with the volume of an atom
  bool prune = false;       // whether equal voxels are joined as the map grows (the paper's comparison does not)
};

struct MappingParameters {
  std::string map_frame = "map";
  Mode mode = Mode::kOccupancy;
  double radius = 0.25;    // m, of every atom
  std::uint32_t seed = 1;  // of every random draw: same scans, parameters and seed give the same map
  ScanParameters scan;
  RayParameters rays;
  OccupancyParameters occupancy;
  SignedDistanceParameters signed_distance;
  GaussianProcessParameters gaussian_process;
  SurfaceParameters surface;
  PlanningParameters planning;
  LimitParameters limits;
};

}  // namespace atom_map
