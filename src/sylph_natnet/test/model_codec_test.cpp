#include "sylph_natnet/model_codec.hpp"

#include <gtest/gtest.h>

#include <random>

#include "sylph_natnet/byte_writer.hpp"

namespace sylph_natnet {
namespace {

const std::vector<Version> kVersions{{2, 0}, {2, 9}, {2, 11}, {3, 0}, {3, 1},
                                     {4, 0}, {4, 1}, {4, 2},  {4, 3}, {4, 4}};

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

/// Writes definitions from the protocol's description alone, not with the codec that it tests.
class RawDefinitions {
 public:
  explicit RawDefinitions(const Version& version) : version_(version) {}

  RawDefinitions& markerSet() {
    ByteWriter body;
    body.writeString("set");
    writeNames(body, {"one", "two"});
    return describe(0, body);
  }

  RawDefinitions& rigidBody(const std::string& name, int id) {
    ByteWriter body;
    writeRigidBody(body, name, id, true);
    return describe(1, body);
  }

  /// @param with_markers  whether bones have what rigid bodies have
  RawDefinitions& skeleton(bool with_markers, int bones = 3) {
    ByteWriter body;
    body.writeString("person");
    body.writeI32(1);
    body.writeI32(bones);
    for (int bone = 0; bone < bones; ++bone) {
      writeRigidBody(body, "bone " + std::to_string(bone), bone + 1, with_markers);
    }
    return describe(2, body);
  }

  RawDefinitions& forcePlate() {
    ByteWriter body;
    body.writeI32(1);
    body.writeString("FP-4060");
    writeFloats(body, 2 + 3 + 144 + 12);
    body.writeI32(2);
    body.writeI32(0);
    writeNames(body, {"Fx", "Fy", "Fz", "Mx", "My", "Mz"});
    return describe(3, body);
  }

  RawDefinitions& device() {
    ByteWriter body;
    body.writeI32(5);
    body.writeString("NI-DAQ");
    body.writeString("12345");
    body.writeI32(1);
    body.writeI32(1);
    writeNames(body, {"ai0", "ai1"});
    return describe(4, body);
  }

  RawDefinitions& camera() {
    ByteWriter body;
    body.writeString("Prime 13 #1");
    writeFloats(body, 7);
    return describe(5, body);
  }

  RawDefinitions& asset() {
    ByteWriter body;
    body.writeString("trained");
    body.writeI32(1);
    body.writeI32(2);
    body.writeI32(1);
    writeRigidBody(body, "part", 1, true);
    body.writeI32(1);
    body.writeString("marker");
    body.writeI32(1);
    writeFloats(body, 4);
    body.writeI16(0);
    return describe(6, body);
  }

  RawDefinitions& ofType(int type) { return describe(type, ByteWriter()); }

  Datagram datagram() const {
    ByteWriter payload;
    payload.writeI32(count_);
    payload.writeBytes(descriptions_.bytes());
    return makeMessage(MessageId::ModelDefinitions, payload.bytes());
  }

 private:
  static void writeFloats(ByteWriter& writer, int count) {
    for (int i = 0; i < count; ++i) {
      writer.writeFloat(0.1F * static_cast<float>(i));
    }
  }

  static void writeNames(ByteWriter& writer, const std::vector<std::string>& names) {
    writer.writeI32(static_cast<int>(names.size()));
    for (const std::string& name : names) {
      writer.writeString(name);
    }
  }

  void writeRigidBody(ByteWriter& writer, const std::string& name, int id, bool with_markers) {
    writer.writeString(name);
    writer.writeI32(id);
    writer.writeI32(-1);
    writeFloats(writer, version_ >= Version{4, 2} ? 7 : 3);
    if (version_ >= Version{3, 0} && with_markers) {
      writer.writeI32(2);
      writeFloats(writer, 6);
      writer.writeI32(0);
      writer.writeI32(0);
      if (version_ >= Version{4, 0}) {
        writer.writeString("left");
        writer.writeString("right");
      }
    }
  }

  RawDefinitions& describe(int type, const ByteWriter& body) {
    ++count_;
    descriptions_.writeI32(type);
    if (version_ >= Version{4, 1}) {
      descriptions_.writeI32(static_cast<int>(body.bytes().size()));
    }
    descriptions_.writeBytes(body.bytes());
    return *this;
  }

  Version version_;
  int count_ = 0;
  ByteWriter descriptions_;
};

/// All that a lab has, with a robot's body before, between and behind.
Datagram fullLab(const Version& version, bool bones_have_markers) {
  RawDefinitions raw(version);
  raw.skeleton(bones_have_markers).rigidBody("first", 1).markerSet().forcePlate().device();
  raw.camera().rigidBody("second", 2).skeleton(bones_have_markers).camera();
  if (version >= Version{4, 1}) {
    raw.asset();
  }
  return raw.rigidBody("third", 3).datagram();
}

std::vector<std::string> bodyNames(const ModelDefinitions& definitions) {
  std::vector<std::string> names;
  for (const RigidBodyDefinition& body : definitions.rigid_bodies) {
    names.push_back(body.name);
  }
  return names;
}

TEST(ModelCodecTest, WritesWhatItReads) {
  for (const Version& version : kVersions) {
    EXPECT_EQ(exampleDefinitions(),
              parse(makeModelDefinitions(exampleDefinitions(), version), version))
        << toString(version);
  }
}

TEST(ModelCodecTest, ReadsRigidBodiesBetweenAllThatALabHas) {
  for (const Version& version : kVersions) {
    for (const bool bones_have_markers : {true, false}) {
      SCOPED_TRACE(toString(version) + (bones_have_markers ? " with" : " without"));
      const ModelDefinitions definitions = parse(fullLab(version, bones_have_markers), version);
      EXPECT_EQ("", definitions.unread);
      EXPECT_EQ((std::vector<std::string>{"first", "second", "third"}), bodyNames(definitions));
      EXPECT_EQ(2, definitions.rigid_bodies[1].id);
      EXPECT_EQ(std::vector<std::string>{"set"}, definitions.marker_sets);
    }
  }
}

TEST(ModelCodecTest, PassesASkeletonWithoutBones) {
  for (const Version& version : kVersions) {
    const Datagram raw = RawDefinitions(version).skeleton(true, 0).rigidBody("robot", 1).datagram();
    EXPECT_EQ(std::vector<std::string>{"robot"}, bodyNames(parse(raw, version)));
  }
}

TEST(ModelCodecTest, NamesWhatItCannotPassAndKeepsWhatCameBefore) {
  for (const Version version : {Version{2, 9}, Version{3, 0}, Version{4, 0}}) {
    SCOPED_TRACE(toString(version));
    const auto unread = [&](RawDefinitions raw) {
      const ModelDefinitions definitions = parse(raw.rigidBody("hidden", 2).datagram(), version);
      EXPECT_EQ(std::vector<std::string>{"seen"}, bodyNames(definitions));
      return definitions.unread;
    };
    const RawDefinitions start = RawDefinitions(version).rigidBody("seen", 1);
    EXPECT_EQ("asset 'trained'", unread(RawDefinitions(start).asset()));
    EXPECT_EQ("description of unknown type 9", unread(RawDefinitions(start).ofType(9)));
    EXPECT_EQ("description of unknown type -1", unread(RawDefinitions(start).ofType(-1)));
    // A camera with a tail that no account of the protocol has.
    EXPECT_EQ("camera 'Prime 13 #1'", unread(RawDefinitions(start).camera().ofType(1)));
  }
}

TEST(ModelCodecTest, PassesUnknownTypesWhereTheirSizeIsTold) {
  const Datagram raw = RawDefinitions({4, 1}).ofType(9).rigidBody("robot", 1).datagram();
  EXPECT_EQ(std::vector<std::string>{"robot"}, bodyNames(parse(raw, {4, 1})));
}

TEST(ModelCodecTest, RefusesBytesBehindTheLastDescription) {
  for (const Version& version : kVersions) {
    Datagram longer = makeModelDefinitions(exampleDefinitions(), version);
    longer.resize(longer.size() + 4);
    EXPECT_THROW(parse(longer, version), ParseError) << toString(version);
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

TEST(ModelCodecTest, SurvivesMutatedAndCutDefinitions) {
  std::mt19937 rng(7);
  int parsed = 0;
  for (const Version& version : kVersions) {
    for (const bool bones_have_markers : {true, false}) {
      const Datagram whole = fullLab(version, bones_have_markers);
      for (int round = 0; round < 5000; ++round) {
        Datagram mutant = whole;
        for (std::size_t i = 0; i < 1 + rng() % 4; ++i) {
          mutant[4 + rng() % (mutant.size() - 4)] = static_cast<std::uint8_t>(rng());
        }
        mutant.resize(mutant.size() - rng() % 3 * (rng() % mutant.size()) / 2);
        // A copy that ends where the data end, for the address sanitizer.
        mutant.shrink_to_fit();
        try {
          ASSERT_LE(parse(mutant, version).rigid_bodies.size(), mutant.size() / 4);
          ++parsed;
        } catch (const ParseError& error) {
          ASSERT_STRNE("", error.what());
        }
      }
    }
  }
  EXPECT_GT(parsed, 0);
}

TEST(ModelCodecTest, AFullLabCutAtAnyByteIsRefusedOrNamesWhatIsUnread) {
  for (const Version& version : kVersions) {
    const Datagram whole = fullLab(version, true);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Datagram cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      try {
        EXPECT_NE("", parse(cut, version).unread) << toString(version) << " after " << size;
      } catch (const ParseError& error) {
        EXPECT_STRNE("", error.what());
      }
    }
  }
}

}  // namespace
}  // namespace sylph_natnet
