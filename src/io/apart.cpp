#include "atom_mapping/io/apart.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace atom_map {
namespace {

constexpr std::size_t kLongestFault = 4096;  // bytes, which a pipe holds
constexpr unsigned kPatience = 6;            // seconds by the clock for one of CPU time

struct Pipe {
  Descriptor out;
  Descriptor in;
};

Pipe makePipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

void writeAll(int descriptor, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) ::_exit(1);  // whoever listened is gone
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

// How many came before the end.
std::size_t readAll(int descriptor, char* bytes, std::size_t size) {
  std::size_t there = 0;
  while (there < size) {
    const ssize_t count = ::read(descriptor, bytes + there, size - there);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    there += static_cast<std::size_t>(count);
  }
  return there;
}

void limit(decltype(RLIMIT_AS) resource, rlim_t value) {
  rlimit limits{};
  if (::getrlimit(resource, &limits) != 0) return;
  limits.rlim_cur = std::min(value, limits.rlim_max);
  ::setrlimit(resource, &limits);
}

std::size_t bytesMapped() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

[[noreturn]] void workApart(const std::function<void(const Apart::Send&)>& work, int data, int fault, unsigned seconds,
                            std::size_t memory) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGPIPE, SIG_IGN);
  for (const int fatal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGALRM}) std::signal(fatal, SIG_DFL);
  ::alarm(kPatience * seconds);  // a lock that another thread held takes no CPU time
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds);
  limit(RLIMIT_AS, memory);
  try {
    work([data](const void* bytes, std::size_t size) { writeAll(data, static_cast<const char*>(bytes), size); });
  } catch (const std::exception& error) {
    writeAll(fault, error.what(), std::min(std::strlen(error.what()), kLongestFault));
  }
  ::_exit(0);
}

}  // namespace

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

Apart::Apart(const std::function<void(const Send&)>& work, unsigned seconds, std::size_t memory) {
  // One at a time, lest one child keeps another's pipes open.
  static std::mutex forking;
  const std::lock_guard lock(forking);
  Pipe data = makePipe();
  Pipe fault = makePipe();
  const std::size_t most = bytesMapped() + memory;
  child_ = ::fork();
  if (child_ == 0) workApart(work, data.in.number(), fault.in.number(), seconds, most);
  if (child_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  data_ = std::move(data.out);
  fault_ = std::move(fault.out);
}

Apart::~Apart() {
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Apart::receive(void* bytes, std::size_t size) {
  if (readAll(data_.number(), static_cast<char*>(bytes), size) != size) throwWhy();
}

void Apart::throwWhy() {
  std::string fault(kLongestFault, '\0');
  fault.resize(readAll(fault_.number(), fault.data(), fault.size()));
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  if (!fault.empty()) throw std::runtime_error(fault);
  if (WIFSIGNALED(status)) throw std::runtime_error("reading it ended by signal " + std::to_string(WTERMSIG(status)));
  throw std::runtime_error("reading it ended too early");
}

}  // namespace atom_map
