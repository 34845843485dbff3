// Work that may crash, hang or want all memory there is, done in a process of its own.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <utility>

namespace atom_map {

// A file descriptor that is closed in the end.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept { *this = std::move(other); }
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int number() const { return number_; }

 private:
  int number_ = -1;
};

// A child process, forked from this one, and what it sends. It may use what was not locked by another thread at that
// moment: allocation is safe, a log is not. One thread at a time.
class Apart {
 public:
  using Send = std::function<void(const void* bytes, std::size_t size)>;

  // Starts work(send), which may take `seconds` of CPU time, six times as long by the clock, and `memory` bytes beyond what
  // this process has.
  Apart(const std::function<void(const Send&)>& work, unsigned seconds, std::size_t memory);
  ~Apart();  // ends it, done or not
  Apart(const Apart&) = delete;
  Apart& operator=(const Apart&) = delete;

  // Waits for the next `size` bytes. Throws std::runtime_error where they never come: what work threw, or how it died.
  void receive(void* bytes, std::size_t size);

 private:
  [[noreturn]] void throwWhy();

  pid_t child_ = -1;
  Descriptor data_;   // what it sends
  Descriptor fault_;  // what it threw
};

}  // namespace atom_map
