#include "sylph_core/control/robot_reporter.hpp"

#include <gtest/gtest.h>

namespace sylph {
namespace {

TEST(RobotReporterTest, TellsAtItsRateAndNewsAtOnce) {
  RobotReporter reporter(10.0);
  RobotReport report;
  ASSERT_TRUE(reporter.offer(report, 5.0).has_value());
  EXPECT_FALSE(reporter.offer(report, 5.05).has_value());
  report.tracking_error_m = 0.001;  // changes all the time: nobody waits for it
  EXPECT_FALSE(reporter.offer(report, 5.06).has_value());
  report.done = 1;
  const auto news = reporter.offer(report, 5.07);
  ASSERT_TRUE(news.has_value());
  EXPECT_EQ(2U, news->report_id);
  EXPECT_EQ(1, news->done);
  EXPECT_FALSE(reporter.offer(report, 5.11).has_value()) << "the rate counts from the last one";
  ASSERT_TRUE(reporter.offer(report, 5.18).has_value());
  EXPECT_EQ(3U, reporter.last().report_id);
}

}  // namespace
}  // namespace sylph
