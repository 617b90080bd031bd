#include "sylph_rehearsal/link.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sylph_rehearsal {
namespace {

/// Sends 1000 numbers, one each 10 ms, and tells in which order they come.
std::vector<int> sendThousand(const LinkOptions& options, std::vector<double>* delays_s = nullptr) {
  EventQueue queue;
  Link link(queue, options, sylph::Rng(7));
  std::vector<int> arrived;
  for (int number = 0; number < 1000; ++number) {
    const double sent_s = 0.01 * number;
    queue.at(sent_s, [&, number, sent_s] {
      link.send([&, number, sent_s] {
        arrived.push_back(number);
        if (delays_s != nullptr) {
          delays_s->push_back(queue.now() - sent_s);
        }
      });
    });
  }
  queue.run(1e9, [] { return true; });
  return arrived;
}

TEST(LinkTest, DelaysWithinItsBoundsAndKeepsTheOrder) {
  LinkOptions options;
  options.delay_s = 0.05;
  options.jitter_s = 0.03;  // longer than the time between two messages
  std::vector<double> delays_s;
  const std::vector<int> arrived = sendThousand(options, &delays_s);
  EXPECT_EQ(1000U, arrived.size());
  EXPECT_TRUE(std::is_sorted(arrived.begin(), arrived.end()));
  EXPECT_GE(*std::min_element(delays_s.begin(), delays_s.end()), 0.05 - 1e-9);
  EXPECT_LE(*std::max_element(delays_s.begin(), delays_s.end()), 0.08 + 1e-9);
}

TEST(LinkTest, LosesAndDoublesTheShareThatItIsTold) {
  LinkOptions options;
  options.loss = 0.2;
  EXPECT_NEAR(800.0, static_cast<double>(sendThousand(options).size()), 50.0);
  options.loss = 0.0;
  options.doubling = 0.2;
  EXPECT_NEAR(1200.0, static_cast<double>(sendThousand(options).size()), 50.0);
  options.loss = 1.0;
  EXPECT_TRUE(sendThousand(options).empty());
}

TEST(LinkTest, LetsMessagesPassOneThatIsHeldUp) {
  LinkOptions options;
  options.reordering = 0.1;
  const std::vector<int> arrived = sendThousand(options);
  EXPECT_EQ(1000U, arrived.size());
  EXPECT_FALSE(std::is_sorted(arrived.begin(), arrived.end()));
}

}  // namespace
}  // namespace sylph_rehearsal
