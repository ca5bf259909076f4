#include "modules/launch/results_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ResultsTable, SaysWhereToLookWhenMessagesWereLost) {
  logs::Metrics metrics;
  metrics.messages_lost = 0;
  EXPECT_THAT(ResultsTable(metrics, "nowhere"), Not(HasSubstr("doctor")));
  metrics.messages_lost = 14;
  EXPECT_THAT(ResultsTable(metrics, "nowhere"),
              HasSubstr("14: a slow host or a small buffer, see ./citrine doctor"));
}

}  // namespace
}  // namespace citrine
