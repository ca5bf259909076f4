#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/fleet/fleet_status.h"
#include "core/geometry/pose.h"
#include "core/quality/mission_progress.h"
#include "core/time.h"
#include "core/vehicle/uav_state.h"
#include "logs/mcap/mcap_writer.h"
#include "viz/image.h"

/// Nouns as protobuf messages of Foxglove's schemas (foxglove.proto) and our own numbers (citrine.proto). All
/// is said in one frame, the world's, which is called "map".
namespace citrine::foxglove_words {

/// The kinds of message, each of one schema.
enum class Kind { kPose, kTransforms, kCloud, kScene, kProgress, kFlight };

/// A topic of a kind, with its schema and all that the schema needs.
logs::McapWriter::Topic TopicOf(const std::string& name, Kind kind);

std::string Said(Utime time, const Pose& X_WB);
/// Where the frames of the UAVs are, by their names.
std::string Said(Utime time, const std::map<std::string, Pose>& X_WB_by_frame);

/// Points with a number each: x, y, z and `value_name` as float32, red, green, blue, alpha as uint8.
struct Cloud {
  struct Point {
    Eigen::Vector3f p_W;
    float value = 0;
    viz::Colour colour;
  };
  std::string value_name;
  std::vector<Point> points;
};
std::string Said(Utime time, const Cloud& cloud);

/// Lines and spheres under names; one said again under its name replaces the one before, an empty one takes
/// it away.
struct Drawing {
  std::string name;
  viz::Colour colour;
  std::vector<Eigen::Vector3d> line_W;  ///< from point to point
  double line_width_m = 0.08;
  std::vector<Eigen::Vector3d> spheres_W;
  double sphere_diameter_m = 0.5;
};
std::string Said(Utime time, const std::vector<Drawing>& drawings);

std::string Said(Utime time, const MissionProgress& progress);
/// @param status null before it has said one
std::string Said(Utime time, const UavState& state, double flown_m, const FleetStatus* status);

}  // namespace citrine::foxglove_words
