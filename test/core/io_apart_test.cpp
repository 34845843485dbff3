// Whatever becomes of the process that works, whoever asked it gets the bytes or the reason.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "atom_mapping/io/apart.h"

namespace atom_map {
namespace {

constexpr std::size_t kMemory = std::size_t{1} << 30U;  // bytes

std::string whyNot(const std::function<void(const Apart::Send&)>& work) {
  Apart apart(work, 1, kMemory);
  char byte = 0;
  try {
    apart.receive(&byte, 1);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(WorkApart, ItsBytesArriveHoweverManyTheyAre) {
  const std::vector<int> sent(1000000, 7);
  Apart apart([&](const Apart::Send& send) { send(sent.data(), sent.size() * sizeof(int)); }, 10, kMemory);
  std::vector<int> received(sent.size());
  apart.receive(received.data(), 4);
  apart.receive(received.data() + 1, (sent.size() - 1) * sizeof(int));
  EXPECT_EQ(received, sent);
  EXPECT_THROW(apart.receive(received.data(), 1), std::runtime_error);
}

TEST(WorkApart, WhatItThrowsArrives) {
  EXPECT_EQ(whyNot([](const auto&) { throw std::runtime_error("no such thing"); }), "no such thing");
  EXPECT_EQ(whyNot([](const auto&) {}), "reading it ended too early");
}

TEST(WorkApart, ItsDeathIsToldAndHarmsNobody) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL}) {
    EXPECT_EQ(whyNot([=](const auto&) { std::raise(signal); }), "reading it ended by signal " + std::to_string(signal));
  }
}

void workForEver(const Apart::Send& /*send*/) {
  for (volatile unsigned i = 0;; i = i + 1) {
  }
}

TEST(WorkApart, ItEndsWithItsTime) {
  EXPECT_EQ(whyNot(workForEver), "reading it ended by signal " + std::to_string(SIGXCPU));
}

// As it would for a lock that another thread held when the process was forked.
TEST(WorkApart, ItEndsWithItsTimeThoughItOnlyWaits) {
  const auto wait = [](const auto&) {
    for (;;) pause();
  };
  EXPECT_EQ(whyNot(wait), "reading it ended by signal " + std::to_string(SIGALRM));
}

TEST(WorkApart, ItEndsWithWhoeverStartedIt) {
  const Apart apart(workForEver, 1000, kMemory);
}

#ifndef __SANITIZE_ADDRESS__
std::size_t openDescriptors() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

// Not under sanitizers, which need descriptors themselves: to look whether memory can be read they open a pipe.
TEST(WorkApart, WhereDescriptorsRunOutNoneIsLost) {
  const std::size_t before = openDescriptors();
  rlimit limits{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &limits), 0);
  const int next = ::dup(0);  // the least that is free
  ::close(next);
  for (const int room : {1, 2, 3}) {
    const rlimit few{static_cast<rlim_t>(next + room), limits.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &few);
    EXPECT_THROW(Apart(workForEver, 1, kMemory), std::system_error) << room;
  }
  ::setrlimit(RLIMIT_NOFILE, &limits);
  EXPECT_EQ(openDescriptors(), before);
}

TEST(WorkApart, ItMayNotTakeAllMemory) {
  EXPECT_EQ(whyNot([](const auto&) { std::vector<char>(kMemory + (1U << 30U)); }), "std::bad_alloc");
}
#endif

}  // namespace
}  // namespace atom_map
