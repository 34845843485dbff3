// Work that may crash, hang or want all memory there is, done in a process of its own.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>

namespace atom_map {

// A child process, forked from this one, and what it sends. It may use what was not locked by another thread at that
// moment: allocation is safe, a log is not. One thread at a time.
class Apart {
 public:
  using Send = std::function<void(const void* bytes, std::size_t size)>;

  // Starts work(send), which may take `seconds` of CPU time, six times as long by the clock, and kMemory beyond what this
  // process has.
  Apart(const std::function<void(const Send&)>& work, unsigned seconds);
  ~Apart();  // ends it, done or not
  Apart(const Apart&) = delete;
  Apart& operator=(const Apart&) = delete;

  // Waits for the next `size` bytes. Throws std::runtime_error where they never come: what work threw, or how it died.
  void receive(void* bytes, std::size_t size);

  static constexpr std::size_t kMemory = std::size_t{2} << 30U;  // bytes

 private:
  [[noreturn]] void throwWhy();

  pid_t child_ = -1;
  int data_ = -1;   // what it sends
  int fault_ = -1;  // what it threw
};

}  // namespace atom_map
