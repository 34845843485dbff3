#include "atom_mapping/ros/transform_wait.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "atom_mapping/ros/frame_name.h"
#include "atom_mapping/ros/header_fault.h"

namespace atom_mapping {

TransformWait::TransformWait(tf2::BufferCore& transforms, std::string map_frame, const InputParameters& parameters,
                             ros::CallbackQueueInterface* queue, Handlers handlers)
    : transforms_(transforms),
      map_frame_(std::move(map_frame)),
      timeout_(
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(parameters.transform_timeout))),
      handlers_(std::move(handlers)),
      filter_(transforms, map_frame_, parameters.queue_size, queue) {
  using Filter = tf2_ros::MessageFilter<sensor_msgs::PointCloud2>;
  filter_.registerCallback(Filter::Callback([this](const CloudPtr& cloud) { release(cloud); }));
  filter_.registerFailureCallback([this](const CloudPtr& cloud, tf2_ros::FilterFailureReason reason) {
    giveUp(cloud, reason == tf2_ros::filter_failure_reasons::OutTheBack ? "it is older than all that tf remembers"
                                                                        : "too many newer clouds wait as well");
  });
}

void TransformWait::add(const CloudPtr& cloud) {
  if (headerFault(cloud->header)) return handlers_.ready(cloud);  // the server refuses it
  waiting_.push_back({cloud, Clock::now() + timeout_});
  filter_.add(cloud);
}

void TransformWait::expire() {
  const Clock::time_point now = Clock::now();
  while (!waiting_.empty() && waiting_.front().deadline <= now) {
    const CloudPtr cloud = waiting_.front().cloud;
    std::string why;
    if (canTransform(cloud, &why)) {
      release(cloud);
    } else {
      giveUp(cloud, why);
    }
  }
}

// MessageFilter::clear would pull its callback from under the thread in which tf may be calling it; what the filter still
// says of these clouds is ignored, as they are not waiting any more.
std::deque<TransformWait::CloudPtr> TransformWait::clear() {
  std::deque<CloudPtr> clouds;
  for (const Waiting& waiting : waiting_) clouds.push_back(waiting.cloud);
  waiting_.clear();
  return clouds;
}

bool TransformWait::canTransform(const CloudPtr& cloud, std::string* why) const {
  try {
    return transforms_.canTransform(map_frame_, withoutSlash(cloud->header.frame_id), cloud->header.stamp, why);
  } catch (const std::runtime_error& fault) {  // of stamps too far apart to subtract
    if (why != nullptr) *why = fault.what();
    return false;
  }
}

// Whether it was waiting still.
bool TransformWait::forget(const CloudPtr& cloud) {
  const auto found = std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& w) { return w.cloud == cloud; });
  if (found == waiting_.end()) return false;
  waiting_.erase(found);
  return true;
}

// Hands on a cloud and, before it, older ones that the filter forgot.
void TransformWait::release(const CloudPtr& cloud) {
  std::deque<CloudPtr> older;
  for (const Waiting& waiting : waiting_) {
    if (waiting.cloud == cloud) break;
    older.push_back(waiting.cloud);
  }
  if (older.size() == waiting_.size()) return;  // given up before
  for (const CloudPtr& ready : older) {
    if (canTransform(ready) && forget(ready)) handlers_.ready(ready);
  }
  if (forget(cloud)) handlers_.ready(cloud);
}

void TransformWait::giveUp(const CloudPtr& cloud, const std::string& why) {
  if (forget(cloud)) handlers_.given_up(cloud, why);
}

}  // namespace atom_mapping
