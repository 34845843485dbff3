// The thread on which one map of a comparison works.
#include "atom_mapping/evaluation/own_thread.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace atom_map {
namespace {

TEST(OwnThread, DoesWorkInOrderOnOneThreadThatIsNotTheCallers) {
  OwnThread thread;
  std::vector<std::thread::id> threads;
  for (std::size_t i = 0; i < 100; ++i) {
    thread.run([&] { threads.push_back(std::this_thread::get_id()); });
    ASSERT_EQ(threads.size(), i + 1) << "run() should return when the work is done";
    EXPECT_EQ(threads[i], threads[0]);
  }
  EXPECT_NE(threads[0], std::this_thread::get_id());
}

TEST(OwnThread, ThrowsWhatTheWorkThrowsAndGoesOn) {
  OwnThread thread;
  EXPECT_THROW(thread.run([] { throw std::runtime_error("no"); }), std::runtime_error);
  bool done = false;
  thread.run([&] { done = true; });
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace atom_map
