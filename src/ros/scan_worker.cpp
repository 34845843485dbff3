#include "atom_mapping/ros/scan_worker.h"

#include <utility>

namespace atom_mapping {

ScanWorker::ScanWorker(CloudServer& server, const tf2::BufferCore& transforms, std::size_t capacity, Done done)
    : server_(server), transforms_(transforms), capacity_(capacity), done_(std::move(done)), thread_([this] {
        work();
      }) {}

ScanWorker::~ScanWorker() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void ScanWorker::add(const CloudPtr& cloud) {
  CloudPtr oldest;
  {
    const std::lock_guard lock(mutex_);
    clouds_.push_back(cloud);
    if (clouds_.size() > capacity_) {
      oldest = clouds_.front();
      clouds_.pop_front();
    }
  }
  changed_.notify_one();
  if (oldest) done_(*oldest, server_.drop(Drop::kOverload, "clouds come faster than they can be mapped"));
}

void ScanWorker::clear() {
  std::deque<CloudPtr> dropped;
  {
    const std::lock_guard lock(mutex_);
    dropped.swap(clouds_);
  }
  for (const CloudPtr& cloud : dropped)
    done_(*cloud, server_.drop(Drop::kTimeJump, "time jumped back while it waited"));
}

void ScanWorker::work() {
  for (;;) {
    CloudPtr cloud;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stopping_ || !clouds_.empty(); });
      if (stopping_) return;
      cloud = clouds_.front();
      clouds_.pop_front();
    }
    done_(*cloud, server_.insert(*cloud, transforms_));
  }
}

}  // namespace atom_mapping
