#include "sylph_natnet/frame_sequence.hpp"

#include <gtest/gtest.h>

namespace sylph_natnet {
namespace {

using Verdict = FrameSequence::Verdict;

TEST(FrameSequenceTest, CountsNumbersThatWereLeftOut) {
  FrameSequence sequence;
  EXPECT_EQ(Verdict::New, sequence.accept(10));
  EXPECT_EQ(Verdict::New, sequence.accept(11));
  EXPECT_EQ(Verdict::New, sequence.accept(15));
  EXPECT_EQ(3U, sequence.lost());
}

TEST(FrameSequenceTest, AFrameThatComesLateWasNotLost) {
  FrameSequence sequence;
  sequence.accept(1);
  sequence.accept(3);
  EXPECT_EQ(Verdict::Late, sequence.accept(2));
  EXPECT_EQ(0U, sequence.lost());
  EXPECT_EQ(1U, sequence.late());
}

TEST(FrameSequenceTest, ADuplicateIsLateAndLeavesTheLossesAlone) {
  FrameSequence sequence;
  sequence.accept(1);
  sequence.accept(3);
  EXPECT_EQ(Verdict::Late, sequence.accept(3));
  EXPECT_EQ(1U, sequence.lost());
}

TEST(FrameSequenceTest, NumbersFarBackAreARestart) {
  FrameSequence sequence;
  sequence.accept(5000);
  EXPECT_EQ(Verdict::Late, sequence.accept(4900));
  EXPECT_EQ(Verdict::Restart, sequence.accept(4899));
  EXPECT_EQ(Verdict::New, sequence.accept(4900));
  EXPECT_EQ(0U, sequence.lost());
}

TEST(FrameSequenceTest, StandsTheLargestSteps) {
  FrameSequence sequence;
  sequence.accept(INT32_MIN);
  EXPECT_EQ(Verdict::New, sequence.accept(INT32_MAX));
  EXPECT_EQ(Verdict::Restart, sequence.accept(INT32_MIN));
}

TEST(FrameSequenceTest, RestartForgetsTheNumberAndKeepsTheCounters) {
  FrameSequence sequence;
  sequence.accept(1);
  sequence.accept(3);
  sequence.restart();
  EXPECT_EQ(Verdict::New, sequence.accept(2));
  EXPECT_EQ(1U, sequence.lost());
}

}  // namespace
}  // namespace sylph_natnet
