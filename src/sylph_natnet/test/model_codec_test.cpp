#include "sylph_natnet/model_codec.hpp"

#include <gtest/gtest.h>

#include <random>

#include "sylph_natnet/byte_writer.hpp"

namespace sylph_natnet {
namespace {

const std::vector<Version> kVersions{{2, 9}, {3, 0}, {4, 0}, {4, 1}, {4, 2}};

ModelDefinitions parse(const Datagram& datagram, const Version& version) {
  return parseModelDefinitions(openMessage(datagram).payload, version);
}

ModelDefinitions exampleDefinitions() {
  ModelDefinitions definitions;
  definitions.marker_sets = {"all"};
  for (int i = 0; i < 8; ++i) {
    RigidBodyDefinition body;
    body.name = "robot_" + std::to_string(i);
    body.id = 100 + i;
    body.offset_m = {0.0F, 0.5F, -1.0F};
    definitions.rigid_bodies.push_back(body);
  }
  return definitions;
}

/// Definitions with markers and a skeleton in the middle, written from the protocol's description.
Datagram rawDefinitions(const Version& version) {
  const auto describe = [&version](ByteWriter& writer, int type, const ByteWriter& body) {
    writer.writeI32(type);
    if (version >= Version{4, 1}) {
      writer.writeI32(static_cast<int>(body.bytes().size()));
    }
    writer.writeBytes(body.bytes());
  };
  const auto rigidBody = [&version](const std::string& name, int id) {
    ByteWriter body;
    body.writeString(name);
    body.writeI32(id);
    body.writeI32(-1);
    for (int i = 0; i < (version >= Version{4, 2} ? 7 : 3); ++i) {
      body.writeFloat(0.0F);
    }
    if (version >= Version{3, 0}) {
      body.writeI32(2);
      for (int i = 0; i < 6; ++i) {
        body.writeFloat(0.1F);
      }
      body.writeI32(0);
      body.writeI32(0);
    }
    if (version >= Version{4, 0}) {
      body.writeString("left");
      body.writeString("right");
    }
    return body;
  };
  ByteWriter marker_set;
  marker_set.writeString("set");
  marker_set.writeI32(2);
  marker_set.writeString("one");
  marker_set.writeString("two");
  ByteWriter skeleton;
  skeleton.writeString("person");
  skeleton.writeI32(1);
  skeleton.writeI32(0);

  ByteWriter payload;
  payload.writeI32(4);
  describe(payload, 0, marker_set);
  describe(payload, 1, rigidBody("first", 1));
  describe(payload, 2, skeleton);
  describe(payload, 1, rigidBody("second", 2));
  return makeMessage(MessageId::ModelDefinitions, payload.bytes());
}

TEST(ModelCodecTest, WritesWhatItReads) {
  for (const Version& version : kVersions) {
    EXPECT_EQ(exampleDefinitions(),
              parse(makeModelDefinitions(exampleDefinitions(), version), version))
        << toString(version);
  }
}

TEST(ModelCodecTest, ReadsRigidBodiesWithMarkers) {
  for (const Version& version : kVersions) {
    const ModelDefinitions definitions = parse(rawDefinitions(version), version);
    ASSERT_FALSE(definitions.rigid_bodies.empty()) << toString(version);
    EXPECT_EQ("first", definitions.rigid_bodies[0].name);
    EXPECT_EQ(1, definitions.rigid_bodies[0].id);
    EXPECT_EQ(std::vector<std::string>{"set"}, definitions.marker_sets);
  }
}

TEST(ModelCodecTest, PassesASkeletonWhereItsSizeIsTold) {
  for (const Version version : {Version{4, 1}, Version{4, 2}}) {
    const ModelDefinitions definitions = parse(rawDefinitions(version), version);
    EXPECT_TRUE(definitions.complete);
    ASSERT_EQ(2U, definitions.rigid_bodies.size());
    EXPECT_EQ("second", definitions.rigid_bodies[1].name);
  }
}

TEST(ModelCodecTest, StopsAtASkeletonWhoseSizeIsUnknown) {
  for (const Version version : {Version{2, 9}, Version{3, 0}, Version{4, 0}}) {
    const ModelDefinitions definitions = parse(rawDefinitions(version), version);
    EXPECT_FALSE(definitions.complete);
    EXPECT_EQ(1U, definitions.rigid_bodies.size());
  }
}

TEST(ModelCodecTest, RefusesDefinitionsCutAtAnyByte) {
  for (const Version& version : kVersions) {
    const Datagram whole = makeModelDefinitions(exampleDefinitions(), version);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Datagram cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_THROW(parse(cut, version), ParseError) << toString(version) << " after " << size;
    }
  }
}

TEST(ModelCodecTest, RefusesCountsThatCannotBeTrue) {
  for (const std::int32_t count : {-1, 1 << 30}) {
    ByteWriter payload;
    payload.writeI32(count);
    payload.writeBytes(std::vector<std::uint8_t>(100, 0));
    EXPECT_THROW(parseModelDefinitions({payload.bytes().data(), payload.bytes().size()}, {4, 0}),
                 ParseError);
  }
}

TEST(ModelCodecTest, SurvivesMutatedDefinitions) {
  std::mt19937 rng(7);
  for (const Version& version : kVersions) {
    const Datagram whole = rawDefinitions(version);
    for (int round = 0; round < 10000; ++round) {
      Datagram mutant = whole;
      for (std::size_t i = 0; i < 1 + rng() % 4; ++i) {
        mutant[4 + rng() % (mutant.size() - 4)] = static_cast<std::uint8_t>(rng());
      }
      try {
        ASSERT_LE(parse(mutant, version).rigid_bodies.size(), mutant.size() / 4);
      } catch (const ParseError& error) {
        ASSERT_STRNE("", error.what());
      }
    }
  }
}

}  // namespace
}  // namespace sylph_natnet
