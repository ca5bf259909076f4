#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/config/config.h"
#include "core/quality/quality_goal.h"
#include "core/sensor/lidar_model.h"
#include "core/vehicle/vehicle_limits.h"

namespace citrine {

// One struct a section of a mission file. `Visit` names every field once: reading, checking, printing and
// documenting all come from it. A field is a bool, int, double, string, Vector3d, vector<Vector3d> or an
// optional of one.

/// [mission]
struct MissionSection {
  std::string name = "mission";
  std::string world;
  std::optional<Eigen::Vector3d> volume_min_m, volume_max_m;
  std::vector<Eigen::Vector3d> spawns_m;
  int uavs = 3;
  int seed = 1;
  double time_limit_s = 900;

  template <class V>
  void Visit(V& v) {
    v("name", name, Key{"short name; the result folder begins with it"});
    v("world", world, Key{"SDFormat or mesh file, relative to the mission file or the project"});
    v("volume_min_m", volume_min_m,
      Key{"lower corner of the mission volume in the world frame; default: the world's bounds less 3 m",
          "m"});
    v("volume_max_m", volume_max_m,
      Key{"upper corner of the mission volume; default: the world's bounds plus 3 m", "m"});
    v("spawns_m", spawns_m, Key{"start positions, one a UAV, z >= 2.25; default: placed by itself", "m"});
    v("uavs", uavs, Key{"UAVs in the fleet, N (paper, V-A)", "", 1, 15});
    v("seed", seed, Key{"sensor noise, spawn jitter and first centroids", "", 0, 1e9});
    v("time_limit_s", time_limit_s,
      Key{"the mission ends then at the latest (paper, V-A: 15 min)", "s", 1, 86400});
  }
};

/// [uav]
struct UavSection {
  VehicleLimits limits;
  double spawn_jitter_m = 0.5;
  double wind_gust_mps = 0;
  double localisation_noise_m = 0;

  template <class V>
  void Visit(V& v) {
    v("radius_m", limits.radius_m,
      Key{"clearance that the centre keeps from obstacles (paper, table I)", "m", 0.1, 10});
    v("speed_max_mps", limits.speed_max_mps, Key{"(paper, table I)", "m/s", 0.1, 30});
    v("acceleration_max_mps2", limits.acceleration_max_mps2, Key{"(paper, table I)", "m/s^2", 0.1, 30});
    v("spawn_jitter_m", spawn_jitter_m,
      Key{"start positions are moved by up to this much by the seed", "m", 0, 5});
    v("wind_gust_mps", wind_gust_mps, Key{"peak speed of seeded gusts; 0: none", "m/s", 0, 20});
    v("localisation_noise_m", localisation_noise_m,
      Key{"standard deviation of the position that is said; 0: none (paper: perfect)", "m", 0, 1});
  }
};

/// [lidar]
struct LidarSection {
  LidarModel model;
  double rate_hz = 10;
  double noise_m_per_m2 = 1.5e-4;

  template <class V>
  void Visit(V& v) {
    v("rows", model.rows, Key{"rings", "", 1, 256});
    v("cols", model.cols, Key{"beams a ring", "", 8, 8192});
    v("elevation_min_rad", model.elevation_min_rad,
      Key{"lowest ring (paper, table I: -35 degrees)", "rad", -1.57, 1.57});
    v("elevation_max_rad", model.elevation_max_rad,
      Key{"highest ring (paper, table I: 30 degrees)", "rad", -1.57, 1.57});
    v("range_min_m", model.range_min_m, Key{"r_min (paper, table I)", "m", 0.01, 100});
    v("range_max_m", model.range_max_m, Key{"r_max (paper, table I)", "m", 0.1, 15});
    v("rate_hz", rate_hz, Key{"scans a second of each UAV", "Hz", 0.1, 50});
    v("noise_m_per_m2", noise_m_per_m2,
      Key{"sigma(r) = this * r^2 (paper, V-A: 1.5 cm at 10 m)", "1/m", 0, 0.1});
  }
};

/// [map]
struct MapSection {
  double voxel_m = 0.25;
  double truncation_m = 0.5;
  std::string weight_policy = "best_view";
  double publish_hz = 2;
  double rotation_s = 10;
  double octree_hz = 0.5;
  std::string start;

  template <class V>
  void Visit(V& v) {
    v("voxel_m", voxel_m, Key{"edge of a voxel, d_s (paper, table I)", "m", 0.02, 2});
    v("truncation_m", truncation_m,
      Key{"band of the signed distance on either side of a surface; more than a voxel", "m", 0.02, 10});
    v("weight_policy", weight_policy,
      Key{"what counts as confidence: the best single observation, the sum over scans, the sum over points",
          "",
          0,
          0,
          {"best_view", "per_scan", "per_point"}});
    v("publish_hz", publish_hz, Key{"how often changed blocks are said", "Hz", 0.1, 50});
    v("rotation_s", rotation_s, Key{"time in which the rest of the map is said once", "s", 1, 600});
    v("octree_hz", octree_hz, Key{"how often the octree is said; 0: never", "Hz", 0, 10});
    v("start", start,
      Key{"map.tsdf of an earlier mission over the same grid, to go on from; default: nothing is known"});
  }
};

/// [quality]
struct QualitySection {
  double d_star_m = 4.5;
  double eta_m = 0.5;

  template <class V>
  void Visit(V& v) {
    v("d_star_m", d_star_m,
      Key{"d*: every surface is to be seen from within it; w* = 1/d*^2 (paper, V-A)", "m", 0.5, 100});
    v("eta_m", eta_m,
      Key{"half the width of the interval of viewing distances (not published; 0.5)", "m", 0.05, 5});
  }
};

/// One [[quality.region]] (paper, IV-D)
struct QualityRegionSection {
  Eigen::Vector3d min_m = Eigen::Vector3d::Zero(), max_m = Eigen::Vector3d::Zero();
  double d_star_m = 4.5;

  template <class V>
  void Visit(V& v) {
    v("min_m", min_m, Key{"lower corner", "m"});
    v("max_m", max_m, Key{"upper corner", "m"});
    v("d_star_m", d_star_m, Key{"d* inside", "m", 0.5, 100});
  }
};

/// [planner]
struct PlannerSection {
  std::string strategy = "quality_adaptive";
  bool balance = true;
  std::string views = "per_cell";
  double alpha = 1, beta = 1, gamma = 2;
  int corrected_selections = 2;
  double correction_expiry_s = 20;
  double correction_starved = 0;
  std::string clusters = "hard";
  double clusters_lambda_m2 = 20;
  double decision_latency_s = 0.1;
  double lookahead_s = 1.4;
  double path_margin_m = 0.1;
  std::string candidates = "patch";
  double hop_min_m = 2.5;
  double strays_m = 4;

  template <class V>
  void Visit(V& v) {
    v("strategy", strategy, Key{"who decides", "", 0, 0, {"quality_adaptive", "nearest_frontier"}});
    v("balance", balance, Key{"correct an unbalanced fleet (paper, IV-C); false is the paper's ablation"});
    v("views", views,
      Key{"one view a cell of like elements, or the paper's letter", "", 0, 0, {"per_cell", "per_element"}});
    v("alpha", alpha, Key{"weight of J_I (paper, V-A)", "", 0, 100});
    v("beta", beta, Key{"weight of J_N (paper, V-A)", "", 0, 100});
    v("gamma", gamma, Key{"weight of J_C (paper, V-A)", "", 0, 100});
    v("corrected_selections", corrected_selections, Key{"k (paper, V-A)", "", 1, 100});
    v("correction_expiry_s", correction_expiry_s,
      Key{"a correction is over then at the latest", "s", 1, 600});
    v("correction_starved", correction_starved,
      Key{"correct only where some UAV has less than this part of |ASE| / (N + 1); 0 is the paper's letter",
          "", 0, 1});
    v("clusters", clusters,
      Key{"regularised k-means (paper, IV-C): sizes differ by one element at most, or cost what lambda says",
          "",
          0,
          0,
          {"hard", "soft"}});
    v("clusters_lambda_m2", clusters_lambda_m2,
      Key{"of the soft form: half of what an element more costs a cluster of mean size", "m^2", 0, 1e6});
    v("decision_latency_s", decision_latency_s,
      Key{"mission time from a trigger to the goal, whatever the host's speed", "s", 0, 10});
    v("lookahead_s", lookahead_s,
      Key{"the next view is chosen this long before the UAV would come to rest", "s", 0, 10});
    v("path_margin_m", path_margin_m, Key{"clearance that paths keep beyond the robot's radius", "m", 0, 5});
    v("candidates", candidates,
      Key{"views that J chooses among: those that settle most of the patch that is next on the UAV's tour, "
          "or "
          "all, the paper's letter; nearest_frontier chooses among all",
          "",
          0,
          0,
          {"patch", "all"}});
    v("hop_min_m", hop_min_m,
      Key{"of all: views nearer than this are not chosen where others are within twice as far: J_N would "
          "have "
          "the UAV nibble at the edge of what it sees; 0 is the paper's letter",
          "m", 0, 20});
    v("strays_m", strays_m,
      Key{"a row of voxels as long as this is too few to fly to: low-quality elements that stand in no "
          "larger "
          "company within three metres are seen in passing only (under best_view); 0 is the paper's letter",
          "m", 0, 20});
  }
};

/// [smoother]
struct SmootherSection {
  double replan_ahead_s = 0.12;
  double weight_time = 2400;
  double weight_clearance = 40000;
  double weight_limits = 200000;
  int evaluations_max = 200;
  double guard_hz = 20;

  template <class V>
  void Visit(V& v) {
    v("replan_ahead_s", replan_ahead_s,
      Key{"a new trajectory begins this long after now, on the committed one", "s", 0.02, 2});
    v("weight_time", weight_time, Key{"cost of a second of flight", "", 0, 1e6});
    v("weight_clearance", weight_clearance, Key{"cost of missing clearance", "", 0, 1e9});
    v("weight_limits", weight_limits, Key{"cost of exceeding speed or acceleration", "", 0, 1e9});
    v("evaluations_max", evaluations_max, Key{"evaluations of the objective a solve", "", 10, 10000});
    v("guard_hz", guard_hz, Key{"collision guard (paper, IV-E)", "Hz", 1, 50});
  }
};

/// [dynamics]
struct DynamicsSection {
  double step_s = 0.02;
  int substeps = 10;

  template <class V>
  void Visit(V& v) {
    v("step_s", step_s, Key{"mission time between two CLOCK messages", "s", 0.005, 0.1});
    v("substeps", substeps, Key{"ODE steps in it", "", 1, 200});
  }
};

/// [viz]
struct VizSection {
  double pixels_per_m = 0;
  double frame_hz = 10;
  double ceiling_m = 1e3;

  template <class V>
  void Visit(V& v) {
    v("pixels_per_m", pixels_per_m,
      Key{"scale of topdown.png; 0: as large as 1920 by 1080 pixels allow", "1/m", 0, 200});
    v("frame_hz", frame_hz, Key{"frames a second of mission time of the video", "Hz", 0.1, 60});
    v("ceiling_m", ceiling_m, Key{"surfaces above this height are not drawn", "m", -1e3, 1e3});
  }
};

/// [launch]
struct LaunchSection {
  double pace = 1;
  bool in_process = false;
  std::string out;
  bool view = false;
  bool video = false;
  std::string on_death = "end";
  double log_split_mb = 0;
  int log_keep = 0;

  template <class V>
  void Visit(V& v) {
    v("pace", pace,
      Key{"mission seconds a second of the wall; 0: as fast as it goes, in lockstep", "", 0, 1000});
    v("in_process", in_process, Key{"all modules in one process"});
    v("out", out, Key{"result folder; default: results/<mission>-<strategy>-<seed>"});
    v("view", view, Key{"show the top-down picture in a window"});
    v("video", video, Key{"write topdown.mp4"});
    v("on_death", on_death, Key{"what follows the death of a module", "", 0, 0, {"end"}});
    v("log_split_mb", log_split_mb,
      Key{"the log goes on in a new part, mission.lcmlog.000, .001 ..., after so much; 0: one file", "MB", 0,
          1e6});
    v("log_keep", log_keep, Key{"parts of the log that are kept, the newest; 0: all", "", 0, 10000});
  }
};

/// One mission file: one experiment. Every module holds a copy and reads its sections.
struct MissionConfig {
  MissionSection mission;
  UavSection uav;
  LidarSection lidar;
  MapSection map;
  QualitySection quality;
  std::vector<QualityRegionSection> quality_regions;
  PlannerSection planner;
  SmootherSection smoother;
  DynamicsSection dynamics;
  VizSection viz;
  LaunchSection launch;

  /// Names the sections; `quality_regions` are the rows of [[quality.region]] and visited by the reader
  /// itself.
  template <class V>
  void Visit(V& v) {
    v("mission", mission);
    v("uav", uav);
    v("lidar", lidar);
    v("map", map);
    v("quality", quality);
    v("planner", planner);
    v("smoother", smoother);
    v("dynamics", dynamics);
    v("viz", viz);
    v("launch", launch);
  }

  bool lockstep() const { return launch.pace == 0 || launch.in_process; }
  QualityGoals quality_goals() const;
  /// [m] the mission volume. @throws ConfigError if it has not been set
  Eigen::AlignedBox3d volume_W() const;
};

}  // namespace citrine
