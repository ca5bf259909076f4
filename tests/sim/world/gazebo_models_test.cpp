#include <filesystem>

#include <gtest/gtest.h>

#include "sim/world/world.h"

namespace citrine::sim {
namespace {

/// Sizes of public Gazebo models beside the project, as their own README states them, before their own yaw.
struct GazeboModel {
  std::string name, path;
  Eigen::Vector3d size_m;
  std::size_t triangles;
};
void PrintTo(const GazeboModel& model, std::ostream* out) { *out << model.name; }

std::vector<GazeboModel> ModelsAtHand() {
  const std::filesystem::path folder =
      std::filesystem::path(CITRINE_SOURCE_DIR).parent_path() / "shared/worlds/gazebo/models";
  std::vector<GazeboModel> models;
  // hatchback and pickup turn by 90 degrees in their model.sdf.
  for (const auto& [name, size_m, triangles] :
       {std::tuple{"house_1", Eigen::Vector3d(16.5, 12.9, 7.7), 1884u},
        {"playground", Eigen::Vector3d(11.5, 6.7, 6.0), 3759u},
        {"hatchback", Eigen::Vector3d(4.0, 2.1, 1.6), 788u},
        {"pickup", Eigen::Vector3d(5.7, 2.5, 1.9), 1084u}})
    if (const auto path = folder / name / "model.sdf"; std::filesystem::exists(path))
      models.push_back({name, path.string(), size_m, triangles});
  return models;
}

class GazeboModels : public testing::TestWithParam<GazeboModel> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(GazeboModels);

// The README rounds to a decimetre, and counts a few triangles that have no area.
TEST_P(GazeboModels, HaveTheSizeThatTheirReadmeStates) {
  const World world = LoadWorld(GetParam().path);
  EXPECT_TRUE(((world.bounds_W.sizes() - GetParam().size_m).array().abs() <= 0.051).all())
      << world.bounds_W.sizes().transpose();
  EXPECT_LE(world.mesh.triangles.size(), GetParam().triangles);
  EXPECT_GE(world.mesh.triangles.size() + 5, GetParam().triangles);
}

INSTANTIATE_TEST_SUITE_P(Public, GazeboModels, testing::ValuesIn(ModelsAtHand()),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace citrine::sim
