#include "sylph_natnet/frame_codec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "raw_frame.hpp"

namespace sylph_natnet {
namespace {

const std::vector<Version> kVersions{{2, 0}, {2, 5},  {2, 6},  {2, 7}, {2, 8},
                                     {2, 9}, {2, 10}, {2, 11}, {3, 0}, {3, 1},
                                     {4, 0}, {4, 1},  {4, 2},  {4, 3}, {4, 4}};

Frame parse(const Datagram& datagram, const Version& version) {
  return parseFrame(openMessage(datagram).payload, version);
}

/// A frame that loses nothing in this version.
Frame exampleFrame(const Version& version) {
  Frame frame;
  frame.number = 42;
  frame.timestamp_s = 3.25;
  frame.models_changed = true;
  for (int i = 0; i < 8; ++i) {
    RigidBodySample body;
    body.id = i + 1;
    body.position_m = {0.1F * static_cast<float>(i), -1.5F, 2.0F};
    body.orientation_xyzw = {0.5F, -0.5F, 0.5F, 0.5F};
    body.mean_error_m = 0.0005F;
    body.tracked = version < Version{2, 6} || i % 2 == 0;
    frame.rigid_bodies.push_back(body);
  }
  if (version < Version{3, 0}) {
    frame.latency_s = 0.005F;
  } else {
    frame.mid_exposure_ticks = 0x0123456789abcdefU;
    frame.data_received_ticks = frame.mid_exposure_ticks + 10;
    frame.transmit_ticks = frame.mid_exposure_ticks + 20;
  }
  return frame;
}

class EveryVersion : public testing::TestWithParam<Version> {};

TEST_P(EveryVersion, WritesWhatItReads) {
  const Frame frame = exampleFrame(GetParam());
  EXPECT_EQ(frame, parse(makeFrame(frame, GetParam()), GetParam()));
}

TEST_P(EveryVersion, ReadsRigidBodiesBetweenAllOtherSections) {
  const Frame frame = parse(test::rawFrame(GetParam()), GetParam());
  EXPECT_EQ(1234, frame.number);
  ASSERT_EQ(2U, frame.rigid_bodies.size());
  EXPECT_EQ(7, frame.rigid_bodies[0].id);
  EXPECT_EQ((std::array<float, 3>{1.0F, 2.0F, -3.0F}), frame.rigid_bodies[0].position_m);
  EXPECT_EQ((std::array<float, 4>{0.0F, 0.6F, 0.0F, 0.8F}), frame.rigid_bodies[0].orientation_xyzw);
  EXPECT_EQ(0.25F, frame.rigid_bodies[0].mean_error_m);
  EXPECT_TRUE(frame.rigid_bodies[0].tracked);
  EXPECT_EQ(-3, frame.rigid_bodies[1].id);
  EXPECT_EQ(GetParam() < (Version{2, 6}), frame.rigid_bodies[1].tracked);
}

TEST_P(EveryVersion, ReadsTheSuffixBehindAllOtherSections) {
  const Frame frame = parse(test::rawFrame(GetParam()), GetParam());
  EXPECT_EQ(12.5, frame.timestamp_s);
  EXPECT_TRUE(frame.models_changed);
  EXPECT_FALSE(frame.recording);
  const bool has_ticks = GetParam() >= Version{3, 0};
  EXPECT_EQ(has_ticks ? 1'000'000'000'000U : 0U, frame.mid_exposure_ticks);
  EXPECT_EQ(has_ticks ? 1'000'000'000'200U : 0U, frame.transmit_ticks);
  EXPECT_EQ(has_ticks ? 0.0F : 0.004F, frame.latency_s);
}

TEST_P(EveryVersion, RefusesAFrameCutAtAnyByte) {
  for (const Datagram& whole :
       {test::rawFrame(GetParam()), makeFrame(exampleFrame(GetParam()), GetParam())}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Datagram cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_THROW(parse(cut, GetParam()), ParseError) << "after " << size << " bytes";
    }
  }
}

TEST_P(EveryVersion, RefusesBytesBehindItsEnd) {
  for (const std::size_t bytes : {1, 4, 33}) {
    Datagram longer = makeFrame(exampleFrame(GetParam()), GetParam());
    longer.resize(longer.size() + bytes);
    try {
      parse(longer, GetParam());
      ADD_FAILURE() << bytes << " bytes more were accepted";
    } catch (const ParseError& error) {
      EXPECT_EQ("frame: " + std::to_string(bytes) + " bytes are left behind its end",
                std::string(error.what()));
    }
  }
}

/// Versions whose frames have one layout.
int layoutOf(const Version& version) {
  const std::vector<Version> changes{{2, 1}, {2, 3},  {2, 6}, {2, 7},
                                     {2, 9}, {2, 11}, {3, 0}, {4, 1}};
  return static_cast<int>(std::count_if(changes.begin(), changes.end(),
                                        [&](const Version& change) { return version >= change; }));
}

TEST_P(EveryVersion, IsRefusedAsAVersionOfAnotherLayout) {
  const Datagram raw = test::rawFrame(GetParam());
  for (const Version& other : kVersions) {
    SCOPED_TRACE("read as " + toString(other));
    if (layoutOf(other) == layoutOf(GetParam())) {
      EXPECT_EQ(parse(raw, GetParam()), parse(raw, other));
    } else {
      EXPECT_THROW(parse(raw, other), ParseError);
    }
  }
}

TEST_P(EveryVersion, IsNeverReadAsAnotherFrameWhereItIsEmpty) {
  Frame frame;
  frame.number = 7;
  frame.timestamp_s = 1e6 / 3;
  const Datagram datagram = makeFrame(frame, GetParam());
  for (const Version& other : kVersions) {
    try {
      EXPECT_EQ(parse(datagram, GetParam()), parse(datagram, other)) << toString(other);
    } catch (const ParseError&) {
      EXPECT_NE(layoutOf(other), layoutOf(GetParam())) << toString(other);
    }
  }
}

TEST_P(EveryVersion, RefusesCountsThatCannotBeTrue) {
  // The first count, that of the marker sets, follows header and frame number.
  for (const std::int32_t count : {-1, 1 << 24, std::numeric_limits<std::int32_t>::max(),
                                   std::numeric_limits<std::int32_t>::min()}) {
    ByteWriter writer;
    writer.writeI32(1);
    writer.writeI32(count);
    writer.writeI32(count);
    writer.writeBytes(std::vector<std::uint8_t>(500, 0));
    EXPECT_THROW(parseFrame({writer.bytes().data(), writer.bytes().size()}, GetParam()), ParseError)
        << count;
  }
}

TEST_P(EveryVersion, SurvivesMutatedFrames) {
  const Datagram whole = test::rawFrame(GetParam());
  std::mt19937 rng(20241122U);
  int parsed = 0;
  for (int round = 0; round < 20000; ++round) {
    Datagram mutant = whole;
    const std::size_t changes = 1 + rng() % 4;
    for (std::size_t i = 0; i < changes; ++i) {
      mutant[4 + rng() % (mutant.size() - 4)] = static_cast<std::uint8_t>(rng());
    }
    mutant.resize(mutant.size() - rng() % 3 * (rng() % 20));
    try {
      const Frame frame = parse(mutant, GetParam());
      ASSERT_LE(frame.rigid_bodies.size(), mutant.size() / 36);
      ++parsed;
    } catch (const ParseError& error) {
      ASSERT_STRNE("", error.what());
    }
  }
  EXPECT_GT(parsed, 0);
  EXPECT_LT(parsed, 20000);
}

INSTANTIATE_TEST_SUITE_P(FrameCodecTest, EveryVersion, testing::ValuesIn(kVersions),
                         [](const testing::TestParamInfo<Version>& version) {
                           return "V" + std::to_string(version.param.major) + "_" +
                                  std::to_string(version.param.minor);
                         });

TEST(FrameCodecTest, KnowsThat29IsOlderThan30) {
  const Datagram old = test::rawFrame({2, 9});
  EXPECT_EQ(7, parse(old, {2, 9}).rigid_bodies[0].id);
  // Taken for 3.0, the marker block shifts all that follows.
  EXPECT_THROW(parse(old, {3, 0}), ParseError);
}

TEST(FrameCodecTest, RefusesVersionsBeforeTheOldest) {
  EXPECT_THROW(parse(test::rawFrame({2, 0}), {1, 9}), ParseError);
  EXPECT_THROW(makeFrame({}, {1, 9}), std::invalid_argument);
}

/// Payload of a 4.1 frame up to and including a rigid body section of these sizes, zeros after it.
std::vector<std::uint8_t> withRigidBodySection(std::int32_t count, std::size_t bytes) {
  ByteWriter writer;
  writer.writeI32(5);
  for (int i = 0; i < 4; ++i) {
    writer.writeI32(0);  // two empty sections: count and size
  }
  writer.writeI32(count);
  writer.writeI32(static_cast<std::int32_t>(bytes));
  writer.writeBytes(std::vector<std::uint8_t>(bytes + 40 + 54, 0));
  return writer.bytes();
}

TEST(FrameCodecTest, ReadsRigidBodyRecordsThatHaveGrown) {
  const std::vector<std::uint8_t> payload = withRigidBodySection(3, 3 * 50);
  EXPECT_EQ(3U, parseFrame({payload.data(), payload.size()}, {4, 3}).rigid_bodies.size());
}

TEST(FrameCodecTest, RefusesRigidBodyRecordsThatAreTooSmallOrUneven) {
  for (const std::size_t bytes : {3 * 37, 3 * 38 + 1, 0}) {
    const std::vector<std::uint8_t> payload = withRigidBodySection(3, bytes);
    EXPECT_THROW(parseFrame({payload.data(), payload.size()}, {4, 1}), ParseError) << bytes;
  }
}

TEST(FrameCodecTest, KeepsValuesThatAreNoNumbers) {
  Frame frame;
  frame.rigid_bodies.resize(1);
  frame.rigid_bodies[0].position_m[1] = std::numeric_limits<float>::quiet_NaN();
  const Frame read = parse(makeFrame(frame, {4, 1}), {4, 1});
  EXPECT_TRUE(std::isnan(read.rigid_bodies[0].position_m[1]));
}

TEST(FrameCodecTest, ErrorsNameTheField) {
  const Datagram whole = makeFrame(exampleFrame({3, 0}), {3, 0});
  const Datagram cut(whole.begin(), whole.begin() + 30);
  try {
    parse(cut, {3, 0});
    FAIL() << "no error";
  } catch (const ParseError& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("rigid bodies: count of 8"))
        << error.what();
  }
}

}  // namespace
}  // namespace sylph_natnet
