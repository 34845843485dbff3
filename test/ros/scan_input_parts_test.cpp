// The steps between a subscriber and the server: waiting for a transform, and the worker's queue.
#include <gtest/gtest.h>
#include <ros/callback_queue.h>

#include <array>
#include <future>

#include "atom_mapping/base/random.h"
#include "atom_mapping/ros/scan_server.h"
#include "atom_mapping/ros/scan_worker.h"
#include "atom_mapping/ros/transform_wait.h"
#include "simulated_input.h"

namespace atom_mapping {
namespace {

using CloudPtr = sensor_msgs::PointCloud2::ConstPtr;

const SimulatedDrive kDrive = makeCoarseDrive();

CloudPtr makeCloud(int i, const std::string& frame = "velodyne") {
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header = kDrive.header(i, frame);
  return cloud;
}

class TransformWaitTest : public testing::Test {
 protected:
  void make(double timeout, std::uint32_t queue_size = 10) {
    wait_ = std::make_unique<TransformWait>(
        transforms_, "map", InputParameters{timeout, queue_size}, &queue_,
        TransformWait::Handlers{[this](const CloudPtr& cloud) { ready_.push_back(cloud); },
                                [this](const CloudPtr& cloud, const std::string& why) {
                                  given_up_.push_back(cloud);
                                  why_ = why;
                                }});
  }

  void tellTransform(int i) { transforms_.setTransform(kDrive.transform(i), "test"); }
  void run() { queue_.callAvailable(); }

  tf2::BufferCore transforms_;
  ros::CallbackQueue queue_;
  std::unique_ptr<TransformWait> wait_;
  std::vector<CloudPtr> ready_;
  std::vector<CloudPtr> given_up_;
  std::string why_;
};

TEST_F(TransformWaitTest, ACloudWithItsTransformGoesOnAtOnce) {
  make(10.0);
  tellTransform(0);
  const CloudPtr cloud = makeCloud(0);
  wait_->add(cloud);
  run();
  EXPECT_EQ(ready_, std::vector<CloudPtr>{cloud});
}

TEST_F(TransformWaitTest, CloudsGoOnInTheirOrderAsTransformsCome) {
  make(10.0);
  const std::vector<CloudPtr> clouds{makeCloud(0), makeCloud(1), makeCloud(2)};
  for (const CloudPtr& cloud : clouds) wait_->add(cloud);
  run();
  EXPECT_TRUE(ready_.empty());
  for (int i = 0; i < 3; ++i) {
    tellTransform(i);
    run();
    EXPECT_EQ(ready_.size(), static_cast<std::size_t>(i + 1));
  }
  EXPECT_EQ(ready_, clouds);
  wait_->expire();
  EXPECT_TRUE(given_up_.empty());
}

TEST_F(TransformWaitTest, ACloudThatWaitedForTooLongIsGivenUpOnce) {
  make(0.0);
  wait_->add(makeCloud(0, "nowhere"));
  run();
  wait_->expire();
  ASSERT_EQ(given_up_.size(), 1U);
  EXPECT_NE(why_.find("nowhere"), std::string::npos) << why_;
  auto late = kDrive.transform(0);
  late.child_frame_id = "nowhere";
  transforms_.setTransform(late, "test");
  run();
  wait_->expire();
  EXPECT_TRUE(ready_.empty());
  EXPECT_EQ(given_up_.size(), 1U);
}

TEST_F(TransformWaitTest, ACloudWhoseTransformCameIsNotGivenUp) {
  make(0.0);
  const CloudPtr cloud = makeCloud(0);
  wait_->add(cloud);
  tellTransform(0);
  wait_->expire();  // before the filter's own callback
  run();
  EXPECT_EQ(ready_, std::vector<CloudPtr>{cloud});
  EXPECT_TRUE(given_up_.empty());
}

TEST_F(TransformWaitTest, TheOldestIsGivenUpWhenTooManyWait) {
  make(10.0, 3);
  std::vector<CloudPtr> clouds;
  for (int i = 0; i < 5; ++i) clouds.push_back(makeCloud(i));
  for (const CloudPtr& cloud : clouds) wait_->add(cloud);
  run();
  EXPECT_EQ(given_up_, (std::vector<CloudPtr>{clouds[0], clouds[1]}));
}

TEST_F(TransformWaitTest, ACloudOlderThanTfsMemoryIsGivenUp) {
  make(10.0);
  tellTransform(0);
  tellTransform(1000);
  wait_->add(makeCloud(1));
  run();
  EXPECT_EQ(given_up_.size(), 1U);
  EXPECT_NE(why_.find("older"), std::string::npos) << why_;
}

TEST_F(TransformWaitTest, WhatNoTransformCanHelpGoesOnToBeRefused) {
  make(10.0);
  wait_->add(makeCloud(0, ""));
  auto unstamped = boost::make_shared<sensor_msgs::PointCloud2>(*makeCloud(0));
  unstamped->header.stamp = ros::Time();
  wait_->add(unstamped);
  EXPECT_EQ(ready_.size(), 2U);
}

TEST_F(TransformWaitTest, ClearForgetsAndReturnsThem) {
  make(0.0);
  const CloudPtr cloud = makeCloud(0);
  wait_->add(cloud);
  tellTransform(0);  // its callback is on the way
  EXPECT_EQ(wait_->clear(), std::deque<CloudPtr>{cloud});
  run();
  wait_->expire();
  EXPECT_TRUE(ready_.empty());
  EXPECT_TRUE(given_up_.empty());
  tellTransform(1);
  wait_->add(makeCloud(1));
  run();
  EXPECT_EQ(ready_.size(), 1U);
}

TEST_F(TransformWaitTest, SurvivesRandomHeaders) {
  make(0.0, 3);
  tellTransform(0);
  tellTransform(1);
  atom_map::Random random(3);
  const std::array<std::string, 7> frames{"", "/", "//", "velodyne", "/velodyne", "map", std::string("a\0\xff b", 5)};
  const std::array<std::uint32_t, 10> numbers{
      0, 1, SimulatedDrive::kStart, 100000000, 999999999, 1000000000, 0x7FFFFFFF, 0x80000000, 4000000000, 0xFFFFFFFF};
  ScanServer server{atom_map::MappingParameters()};
  std::size_t count = 0;
  for (; count < 10000; ++count) {
    auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
    cloud->header.frame_id = frames[random.next() % frames.size()];
    cloud->header.stamp.sec = numbers[random.next() % numbers.size()];
    cloud->header.stamp.nsec = numbers[random.next() % numbers.size()];
    wait_->add(cloud);
    run();
    wait_->expire();
  }
  EXPECT_EQ(ready_.size() + given_up_.size(), count);
  for (const CloudPtr& cloud : ready_) server.insert(*cloud, transforms_);
  EXPECT_GT(server.counts().droppedFor(Drop::kMalformed), count / 10);
  EXPECT_GT(server.counts().mapped, 10U);
}

// A worker that stands still in its first cloud until released.
class ScanWorkerTest : public testing::Test {
 protected:
  ScanWorkerTest() {
    for (int i = 0; i < 10; ++i) transforms_.setTransform(kDrive.transform(i), "test");
    worker_.add(makeCloud(0));
    began_.get_future().wait();
  }

  void done(const sensor_msgs::PointCloud2& cloud, const ScanOutcome& outcome) {
    if (cloud.header.stamp == kDrive.header(0, "").stamp) {
      began_.set_value();
      released_.get_future().wait();
    }
    {
      const std::lock_guard lock(mutex_);
      if (!outcome.drop) mapped_.push_back(cloud.header.stamp);
    }
    if (cloud.header.stamp == kDrive.header(9, "").stamp) finished_.set_value();
  }

  tf2::BufferCore transforms_;
  ScanServer server_{atom_map::MappingParameters()};
  std::promise<void> began_;
  std::promise<void> released_;
  std::promise<void> finished_;
  std::mutex mutex_;
  std::vector<ros::Time> mapped_;
  ScanWorker worker_{server_, transforms_, 3, [this](const auto& cloud, const auto& outcome) { done(cloud, outcome); }};
};

TEST_F(ScanWorkerTest, TheOldestAreDroppedUnderOverload) {
  for (int i = 1; i < 10; ++i) worker_.add(makeCloud(i));
  EXPECT_EQ(server_.counts().droppedFor(Drop::kOverload), 6U);
  released_.set_value();
  finished_.get_future().wait();
  std::vector<ros::Time> expected;
  for (const int i : {0, 7, 8, 9}) expected.push_back(kDrive.header(i, "").stamp);
  const std::lock_guard lock(mutex_);
  EXPECT_EQ(mapped_, expected);
}

TEST_F(ScanWorkerTest, ClearDropsWhatWaits) {
  for (int i = 1; i < 4; ++i) worker_.add(makeCloud(i));
  worker_.clear();
  EXPECT_EQ(server_.counts().droppedFor(Drop::kTimeJump), 3U);
  released_.set_value();
  worker_.add(makeCloud(9));
  finished_.get_future().wait();
  EXPECT_EQ(server_.counts().mapped, 2U);
}

TEST_F(ScanWorkerTest, StopsWithCloudsWaiting) {
  for (int i = 1; i < 4; ++i) worker_.add(makeCloud(i));
  released_.set_value();
}

}  // namespace
}  // namespace atom_mapping
