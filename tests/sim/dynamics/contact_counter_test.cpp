#include "sim/dynamics/contact_counter.h"

#include <gtest/gtest.h>

namespace citrine::sim {
namespace {

TEST(ContactCounter, CountsALastingContactOnce) {
  ContactCounter counter(2);
  for (int k = 0; k < 1000; ++k) counter.Touch(1, 0, FromSeconds(0.002 * k));
  EXPECT_EQ(counter.count(1), 1);
  EXPECT_EQ(counter.count(2), 0);
}

TEST(ContactCounter, CountsAgainOnlyAfterHalfASecondApart) {
  ContactCounter counter(1);
  counter.Touch(1, 0, FromSeconds(1.0));
  counter.Touch(1, 0, FromSeconds(1.5));
  EXPECT_EQ(counter.count(1), 1);
  counter.Touch(1, 0, FromSeconds(2.1));
  EXPECT_EQ(counter.count(1), 2);
}

TEST(ContactCounter, CountsForBothUavsWhoeverIsNamedFirst) {
  ContactCounter counter(3);
  counter.Touch(3, 1, FromSeconds(1));
  counter.Touch(1, 3, FromSeconds(1.1));
  EXPECT_EQ(counter.count(1), 1);
  EXPECT_EQ(counter.count(2), 0);
  EXPECT_EQ(counter.count(3), 1);
}

TEST(ContactCounter, KeepsPartnersApart) {
  ContactCounter counter(2);
  counter.Touch(1, 0, FromSeconds(1));
  counter.Touch(1, 2, FromSeconds(1.1));
  EXPECT_EQ(counter.count(1), 2);
  EXPECT_EQ(counter.count(2), 1);
}

}  // namespace
}  // namespace citrine::sim
