#include "atom_mapping/ros/time_watch.h"

#include <gtest/gtest.h>

namespace atom_mapping {
namespace {

TEST(TimeWatch, AClockThatRunsOnOrStandsIsFine) {
  TimeWatch watch;
  for (const double now : {0.0, 0.0, 1.0, 1.5, 1.5, 1e9}) EXPECT_FALSE(watch.clockWentBack(ros::Time(now)));
}

TEST(TimeWatch, AClockThatGoesBackIsNoticedOnce) {
  TimeWatch watch;
  watch.clockWentBack(ros::Time(100.0));
  EXPECT_TRUE(watch.clockWentBack(ros::Time(99.999)));
  EXPECT_FALSE(watch.clockWentBack(ros::Time(99.999)));
  EXPECT_FALSE(watch.clockWentBack(ros::Time(100.5)));
}

// How many of some stamps are taken for a new beginning, the newest in the map being 100 s.
int countBeginnings(const std::vector<double>& stamps) {
  TimeWatch watch;
  int count = 0;
  for (const double stamp : stamps) count += watch.stampsWentBack(ros::Time(stamp), ros::Time(100.0)) ? 1 : 0;
  return count;
}

TEST(TimeWatch, CloudsOutOfOrderAreNoNewBeginning) {
  EXPECT_EQ(countBeginnings({10.0, 101.0, 10.1, 102.0, 10.2, 10.3, 10.4, 10.5, 103.0}), 0);
  EXPECT_EQ(countBeginnings({99.1, 99.2, 99.3, 99.4, 99.5, 99.6, 99.7}), 0);  // a little late
  EXPECT_EQ(countBeginnings({10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0}), 0);  // the same again and again
  EXPECT_EQ(countBeginnings({10.0, 9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0}), 0);   // no order at all
}

TEST(TimeWatch, CloudsThatGoOnInThePastAre) {
  EXPECT_EQ(countBeginnings({10.0, 10.1, 10.2, 10.3}), 0);
  EXPECT_EQ(countBeginnings({10.0, 10.1, 10.2, 10.3, 10.4}), 1);
}

TEST(TimeWatch, BeforeTheFirstMappedCloudThereIsNoPast) {
  TimeWatch watch;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(watch.stampsWentBack(ros::Time(1.0 + i), ros::Time()));
}

}  // namespace
}  // namespace atom_mapping
