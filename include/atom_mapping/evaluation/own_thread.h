#pragma once

#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

namespace atom_map {

// A thread on which all of one map's work is done, and nothing else: glibc gives it a heap of its own. What maps free and ask
// for then meets only what they freed and asked for themselves, as in a process of their own.
class OwnThread {
 public:
  OwnThread();
  ~OwnThread();
  OwnThread(const OwnThread&) = delete;
  OwnThread& operator=(const OwnThread&) = delete;

  // Returns when the work is done; throws what it throws. From one thread at a time.
  void run(const std::function<void()>& work);

 private:
  void work();

  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::packaged_task<void()> task_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace atom_map
