#include "sylph_rehearsal/event_queue.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sylph_rehearsal {
namespace {

TEST(EventQueueTest, GoesByTimeAndThenByTheOrderOfAdding) {
  EventQueue queue(10.0);
  std::string order;
  const auto note = [&](char letter) { return [&order, letter] { order += letter; }; };
  queue.at(12.0, note('d'));
  queue.at(11.0, note('b'));
  queue.at(11.0, note('c'));
  queue.after(0.5, [&] {
    order += 'a';
    queue.at(3.0, note('!'));  // what is past happens next
  });
  queue.at(13.0, note('x'));
  queue.run(12.0, [] { return true; });
  EXPECT_EQ("a!bcd", order);
  EXPECT_EQ(12.0, queue.now());
}

TEST(EventQueueTest, StopsWhenToldSo) {
  EventQueue queue;
  int count = 0;
  for (int i = 0; i < 5; ++i) {
    queue.at(i, [&] { ++count; });
  }
  queue.run(100.0, [&] { return count < 3; });
  EXPECT_EQ(3, count);
  EXPECT_EQ(2.0, queue.now());
}

}  // namespace
}  // namespace sylph_rehearsal
