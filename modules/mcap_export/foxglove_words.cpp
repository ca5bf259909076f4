#include "modules/mcap_export/foxglove_words.h"

#include <cstring>
#include <set>

#include <citrine_protobuf/citrine.pb.h>
#include <citrine_protobuf/foxglove.pb.h>
#include <google/protobuf/descriptor.pb.h>

namespace citrine::foxglove_words {
namespace {

namespace pb = google::protobuf;

constexpr const char* kWorld = "map";

const pb::Descriptor* DescriptorOf(Kind kind) {
  switch (kind) {
    case Kind::kPose:
      return foxglove::PoseInFrame::descriptor();
    case Kind::kTransforms:
      return foxglove::FrameTransforms::descriptor();
    case Kind::kCloud:
      return foxglove::PointCloud::descriptor();
    case Kind::kScene:
      return foxglove::SceneUpdate::descriptor();
    case Kind::kProgress:
      return mcap::Progress::descriptor();
    case Kind::kFlight:
      return mcap::Flight::descriptor();
  }
  throw std::logic_error("no such kind of message");
}

/// A file after those that it needs, each once.
void Collect(const pb::FileDescriptor* file, std::set<std::string>& known, pb::FileDescriptorSet& set) {
  if (!known.insert(file->name()).second) return;
  for (int i = 0; i < file->dependency_count(); ++i) Collect(file->dependency(i), known, set);
  file->CopyTo(set.add_file());
}

template <class Message>
void Stamp(Utime time, Message& message) {
  message.mutable_timestamp()->set_seconds(time / 1'000'000);
  message.mutable_timestamp()->set_nanos(static_cast<int>(time % 1'000'000 * 1000));
}

template <class Vector>
void Put(const Eigen::Vector3d& p, Vector* vector) {
  vector->set_x(p.x());
  vector->set_y(p.y());
  vector->set_z(p.z());
}

void Put(const Eigen::Quaterniond& q, foxglove::Quaternion* rotation) {
  rotation->set_x(q.x());
  rotation->set_y(q.y());
  rotation->set_z(q.z());
  rotation->set_w(q.w());
}

void Put(const Pose& pose, foxglove::Pose* message) {
  Put(pose.p, message->mutable_position());
  Put(pose.q, message->mutable_orientation());
}

void Put(viz::Colour colour, foxglove::Color* message) {
  message->set_r(colour.r / 255.0);
  message->set_g(colour.g / 255.0);
  message->set_b(colour.b / 255.0);
  message->set_a(1);
}

/// A point as it lies in the data of a PointCloud.
struct PackedPoint {
  float x, y, z, value;
  std::uint8_t red, green, blue, alpha;
};
static_assert(sizeof(PackedPoint) == 20);

void AddField(const std::string& name, std::size_t offset, foxglove::PackedElementField::NumericType type,
              foxglove::PointCloud& cloud) {
  foxglove::PackedElementField* field = cloud.add_fields();
  field->set_name(name);
  field->set_offset(static_cast<std::uint32_t>(offset));
  field->set_type(type);
}

void Put(Utime time, const Drawing& drawing, foxglove::SceneEntity* entity) {
  Stamp(time, *entity);
  entity->set_frame_id(kWorld);
  entity->set_id(drawing.name);
  if (drawing.line_W.size() > 1) {
    foxglove::LinePrimitive* line = entity->add_lines();
    Put(Pose(), line->mutable_pose());
    line->set_thickness(drawing.line_width_m);
    Put(drawing.colour, line->mutable_color());
    for (const Eigen::Vector3d& p_W : drawing.line_W) Put(p_W, line->add_points());
  }
  for (const Eigen::Vector3d& p_W : drawing.spheres_W) {
    foxglove::SpherePrimitive* sphere = entity->add_spheres();
    Put(Pose{p_W}, sphere->mutable_pose());
    Put(Eigen::Vector3d::Constant(drawing.sphere_diameter_m), sphere->mutable_size());
    Put(drawing.colour, sphere->mutable_color());
  }
}

const char* NameOf(FleetStatus::Activity activity) {
  switch (activity) {
    case FleetStatus::Activity::kIdle:
      return "idle";
    case FleetStatus::Activity::kDeciding:
      return "deciding";
    case FleetStatus::Activity::kFlying:
      return "flying";
  }
  return "";
}

}  // namespace

logs::McapWriter::Topic TopicOf(const std::string& name, Kind kind) {
  const pb::Descriptor* descriptor = DescriptorOf(kind);
  pb::FileDescriptorSet set;
  std::set<std::string> known;
  Collect(descriptor->file(), known, set);
  return {name, "protobuf", descriptor->full_name(), "protobuf", set.SerializeAsString()};
}

std::string Said(Utime time, const Pose& X_WB) {
  foxglove::PoseInFrame message;
  Stamp(time, message);
  message.set_frame_id(kWorld);
  Put(X_WB, message.mutable_pose());
  return message.SerializeAsString();
}

std::string Said(Utime time, const std::map<std::string, Pose>& X_WB_by_frame) {
  foxglove::FrameTransforms message;
  for (const auto& [frame, X_WB] : X_WB_by_frame) {
    foxglove::FrameTransform* transform = message.add_transforms();
    Stamp(time, *transform);
    transform->set_parent_frame_id(kWorld);
    transform->set_child_frame_id(frame);
    Put(X_WB.p, transform->mutable_translation());
    Put(X_WB.q, transform->mutable_rotation());
  }
  return message.SerializeAsString();
}

std::string Said(Utime time, const Cloud& cloud) {
  using Field = foxglove::PackedElementField;
  foxglove::PointCloud message;
  Stamp(time, message);
  message.set_frame_id(kWorld);
  Put(Pose(), message.mutable_pose());
  message.set_point_stride(sizeof(PackedPoint));
  AddField("x", offsetof(PackedPoint, x), Field::FLOAT32, message);
  AddField("y", offsetof(PackedPoint, y), Field::FLOAT32, message);
  AddField("z", offsetof(PackedPoint, z), Field::FLOAT32, message);
  AddField(cloud.value_name, offsetof(PackedPoint, value), Field::FLOAT32, message);
  AddField("red", offsetof(PackedPoint, red), Field::UINT8, message);
  AddField("green", offsetof(PackedPoint, green), Field::UINT8, message);
  AddField("blue", offsetof(PackedPoint, blue), Field::UINT8, message);
  AddField("alpha", offsetof(PackedPoint, alpha), Field::UINT8, message);
  std::string* data = message.mutable_data();
  data->reserve(cloud.points.size() * sizeof(PackedPoint));
  for (const Cloud::Point& point : cloud.points) {
    const PackedPoint packed{point.p_W.x(),  point.p_W.y(),  point.p_W.z(),  point.value,
                             point.colour.r, point.colour.g, point.colour.b, 255};
    data->append(reinterpret_cast<const char*>(&packed), sizeof packed);
  }
  return message.SerializeAsString();
}

std::string Said(Utime time, const std::vector<Drawing>& drawings) {
  foxglove::SceneUpdate message;
  for (const Drawing& drawing : drawings) {
    if (drawing.line_W.size() > 1 || !drawing.spheres_W.empty()) {
      Put(time, drawing, message.add_entities());
      continue;
    }
    foxglove::SceneEntityDeletion* deletion = message.add_deletions();
    Stamp(time, *deletion);
    deletion->set_type(foxglove::SceneEntityDeletion::MATCHING_ID);
    deletion->set_id(drawing.name);
  }
  return message.SerializeAsString();
}

std::string Said(Utime time, const MissionProgress& progress) {
  mcap::Progress message;
  Stamp(time, message);
  if (progress.surface_voxels > 0)
    message.set_at_goal_pct(100.0 * progress.voxels_at_goal / progress.surface_voxels);
  message.set_known_pct(progress.known_pct);
  message.set_z_sat(progress.z_sat);
  message.set_z_bar_sat(progress.z_bar_sat);
  message.set_z_goal(progress.z_goal);
  message.set_surface_voxels(progress.surface_voxels);
  message.set_voxels_at_goal(progress.voxels_at_goal);
  message.set_elements_incomplete(progress.elements_ise);
  message.set_elements_low_quality(progress.elements_lqse);
  return message.SerializeAsString();
}

std::string Said(Utime time, const UavState& state, double flown_m, const FleetStatus* status) {
  mcap::Flight message;
  Stamp(time, message);
  message.set_speed_mps(state.v_W.norm());
  message.set_height_m(state.X_WB.p.z());
  message.set_flown_m(flown_m);
  message.set_contacts(state.contacts);
  if (status) {
    if (status->has_goal) message.set_goal_distance_m((status->goal_W - state.X_WB.p).norm());
    message.set_decisions(status->decisions);
    message.set_elements_active(status->elements_active);
    message.set_activity(NameOf(status->activity));
  }
  return message.SerializeAsString();
}

}  // namespace citrine::foxglove_words
