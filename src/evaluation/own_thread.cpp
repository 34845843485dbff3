#include "atom_mapping/evaluation/own_thread.h"

#include <utility>

namespace atom_map {

OwnThread::OwnThread() : thread_([this] { work(); }) {}

OwnThread::~OwnThread() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void OwnThread::run(const std::function<void()>& work) {
  std::packaged_task<void()> task(work);
  std::future<void> done = task.get_future();
  {
    const std::lock_guard lock(mutex_);
    task_ = std::move(task);
  }
  changed_.notify_one();
  done.get();
}

void OwnThread::work() {
  for (;;) {
    std::packaged_task<void()> task;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stopping_ || task_.valid(); });
      if (!task_.valid()) return;
      task = std::exchange(task_, {});
    }
    task();
  }
}

}  // namespace atom_map
