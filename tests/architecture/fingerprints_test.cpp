#include <cstdint>

#include <gtest/gtest.h>

#include "modules/channels.h"

namespace citrine {
namespace {

template <class Message>
std::uint64_t Fingerprint() {
  return static_cast<std::uint64_t>(Message::getHash());
}

// A published type is frozen, or recordings become unreadable. A change is a new name; the old type moves to
// lcmtypes/archive/.
TEST(Fingerprints, AreThoseOfTheRecordings) {
  EXPECT_EQ(Fingerprint<citrine_lcm::clock_t>(), 0x4e24bbb896c8155eu);
  EXPECT_EQ(Fingerprint<citrine_lcm::fleet_assignment_t>(), 0x048debf55f0939d6u);
  EXPECT_EQ(Fingerprint<citrine_lcm::fleet_status_t>(), 0x409c68b14577b344u);
  EXPECT_EQ(Fingerprint<citrine_lcm::flight_status_t>(), 0x23eccf1551a5a453u);
  EXPECT_EQ(Fingerprint<citrine_lcm::lidar_scan_t>(), 0x708689bc3f7aedf7u);
  EXPECT_EQ(Fingerprint<citrine_lcm::map_blocks_t>(), 0x4dcaed643f9e5c1du);
  EXPECT_EQ(Fingerprint<citrine_lcm::map_summary_t>(), 0x58c519fb09fb44aeu);
  EXPECT_EQ(Fingerprint<citrine_lcm::mission_config_t>(), 0x7e746c59264000c8u);
  EXPECT_EQ(Fingerprint<citrine_lcm::mission_progress_t>(), 0xda3d89fa32f15a7cu);
  EXPECT_EQ(Fingerprint<citrine_lcm::module_health_t>(), 0xfe0b50339fd399eau);
  EXPECT_EQ(Fingerprint<citrine_lcm::octree_t>(), 0x38f6cfba39f3a2deu);
  EXPECT_EQ(Fingerprint<citrine_lcm::path_t>(), 0xd6452cc6fd1690b5u);
  EXPECT_EQ(Fingerprint<citrine_lcm::point_cloud_t>(), 0xdd89c7ecd84ac5e9u);
  EXPECT_EQ(Fingerprint<citrine_lcm::step_done_t>(), 0x98ebe3824f30011cu);
  EXPECT_EQ(Fingerprint<citrine_lcm::strategy_message_t>(), 0xbe9bd9c07f821499u);
  EXPECT_EQ(Fingerprint<citrine_lcm::trajectory_t>(), 0x0a99d60792470d07u);
  EXPECT_EQ(Fingerprint<citrine_lcm::uav_state_t>(), 0x04755a67361987b4u);
}

}  // namespace
}  // namespace citrine
