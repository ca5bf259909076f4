#include <gtest/gtest.h>

#include "modules/channels.h"
#include "modules/codec/step_done.h"
#include "modules/runtime/step_barrier.h"

namespace citrine {
namespace {

class StepBarrierTest : public testing::Test {
 protected:
  void SayDone(const std::string& module, int uav, std::int64_t step,
               std::map<std::string, std::int64_t> last_seq) {
    others_.Publish(channels::kStepDone, Encode(StepDone{step, module, uav, std::move(last_seq)}));
    hearer_.Handle(100);
  }

  std::shared_ptr<Transport> transport_ = std::make_shared<Transport>("memq://");
  Bus hearer_{transport_}, others_{transport_};
  std::shared_ptr<Inbox<citrine_lcm::path_t>> paths_ = hearer_.HearAll(channels::kPath);
  StepBarrier barrier_{hearer_, {{"map_fusion", 0}, {"view_planner", 2}}};
};

TEST_F(StepBarrierTest, NamesThoseWhoKeepTheOthersWaiting) {
  SayDone("map_fusion", 0, 4, {});
  SayDone("view_planner", 1, 4, {});
  const std::vector<ModuleId> late = {{"view_planner", 2}};
  EXPECT_EQ(barrier_.NotDone(4), late);
  EXPECT_EQ(ToText(late), "view_planner (UAV 2)");
  EXPECT_FALSE(barrier_.Complete(4));
  SayDone("view_planner", 2, 4, {});
  EXPECT_TRUE(barrier_.Complete(4));
  EXPECT_FALSE(barrier_.Complete(5));
}

TEST_F(StepBarrierTest, WaitsForWhatWasNamedThenCountsItAsLost) {
  SayDone("map_fusion", 0, 1, {{"MAP_BLOCKS", 9}});
  SayDone("view_planner", 2, 1, {{"UAV2_PATH", 1}});
  EXPECT_FALSE(barrier_.Complete(1)) << "the path has not come; MAP_BLOCKS nobody here hears";
  others_.Publish(channels::kPath, 2, {});
  hearer_.Handle(100);
  EXPECT_TRUE(barrier_.Complete(1));
  EXPECT_EQ(hearer_.counts().lost, 0);
  SayDone("map_fusion", 0, 2, {});
  SayDone("view_planner", 2, 2, {{"UAV2_PATH", 2}});
  EXPECT_FALSE(barrier_.Complete(2));
  barrier_.GiveUpWaiting();
  EXPECT_TRUE(barrier_.Complete(2));
  EXPECT_EQ(hearer_.counts().lost, 1);
}

TEST_F(StepBarrierTest, DropsAndCountsNonsense) {
  others_.SayBytes("STEP_DONE", {1, 2, 3});
  hearer_.Handle(100);
  EXPECT_EQ(hearer_.counts().bad, 1);
}

}  // namespace
}  // namespace citrine
