#pragma once

#include "sylph_natnet/byte_writer.hpp"
#include "sylph_natnet/message.hpp"
#include "sylph_natnet/version.hpp"

/// A frame with something in every section, written from the protocol's description alone and not
/// with the codec that it tests: two rigid bodies (ids 7 and -3) with markers, marker sets, loose
/// and labelled markers, a skeleton, an asset, a force plate and a device.
namespace sylph_natnet::test {

constexpr std::size_t kBones = 2;

inline void writeFloats(ByteWriter& writer, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    writer.writeFloat(0.5F * static_cast<float>(i));
  }
}

inline void writeBody(ByteWriter& writer, const Version& version, int id, bool tracked) {
  writer.writeI32(id);
  for (const float value : {1.0F, 2.0F, -3.0F, 0.0F, 0.6F, 0.0F, 0.8F}) {
    writer.writeFloat(value);
  }
  if (version < Version{3, 0}) {
    writer.writeI32(3);
    writeFloats(writer, 9);
    writer.writeI32(1);
    writer.writeI32(2);
    writer.writeI32(3);
    writeFloats(writer, 3);
  }
  writer.writeFloat(0.25F);
  if (version >= Version{2, 6}) {
    writer.writeI16(tracked ? 1 : 0);
  }
}

/// Appends a section: its count, in 4.1 and later its size, its body.
inline void writeSection(ByteWriter& writer, const Version& version, int count,
                         const ByteWriter& body) {
  writer.writeI32(count);
  if (version >= Version{4, 1}) {
    writer.writeI32(static_cast<int>(body.bytes().size()));
  }
  writer.writeBytes(body.bytes());
}

inline ByteWriter markerSets() {
  ByteWriter body;
  body.writeString("all");
  body.writeI32(2);
  writeFloats(body, 6);
  body.writeString("");
  body.writeI32(0);
  return body;
}

inline ByteWriter skeleton(const Version& version) {
  ByteWriter body;
  body.writeI32(1);
  body.writeI32(kBones);
  for (std::size_t bone = 0; bone < kBones; ++bone) {
    writeBody(body, version, 65537, true);
  }
  return body;
}

inline ByteWriter asset(const Version& version) {
  ByteWriter body;
  body.writeI32(4);
  body.writeI32(1);
  writeBody(body, version, 1, true);
  body.writeI32(1);
  body.writeI32(9);
  writeFloats(body, 4);
  body.writeI16(0);
  body.writeFloat(0.001F);
  return body;
}

inline ByteWriter labelledMarkers(const Version& version) {
  ByteWriter body;
  for (int marker = 0; marker < 2; ++marker) {
    body.writeI32(marker);
    writeFloats(body, 4);
    if (version >= Version{2, 6}) {
      body.writeI16(0);
    }
    if (version >= Version{3, 0}) {
      body.writeFloat(0.0005F);
    }
  }
  return body;
}

inline ByteWriter analog() {
  ByteWriter body;
  body.writeI32(1);
  body.writeI32(2);
  body.writeI32(3);
  writeFloats(body, 3);
  body.writeI32(0);
  return body;
}

inline ByteWriter rawFramePayload(const Version& version) {
  ByteWriter writer;
  writer.writeI32(1234);
  writeSection(writer, version, 2, markerSets());
  ByteWriter loose;
  writeFloats(loose, 3);
  writeSection(writer, version, 1, loose);
  ByteWriter bodies;
  writeBody(bodies, version, 7, true);
  writeBody(bodies, version, -3, false);
  writeSection(writer, version, 2, bodies);
  if (version >= Version{2, 1}) {
    writeSection(writer, version, 1, skeleton(version));
  }
  if (version >= Version{4, 1}) {
    writeSection(writer, version, 1, asset(version));
  }
  if (version >= Version{2, 3}) {
    writeSection(writer, version, 2, labelledMarkers(version));
  }
  if (version >= Version{2, 9}) {
    writeSection(writer, version, 1, analog());
  }
  if (version >= Version{2, 11}) {
    writeSection(writer, version, 1, analog());
  }
  if (version < Version{3, 0}) {
    writer.writeFloat(0.004F);
  }
  writer.writeU32(111);
  writer.writeU32(222);
  if (version >= Version{2, 7}) {
    writer.writeDouble(12.5);
  } else {
    writer.writeFloat(12.5F);
  }
  if (version >= Version{3, 0}) {
    writer.writeU64(1'000'000'000'000U);
    writer.writeU64(1'000'000'000'100U);
    writer.writeU64(1'000'000'000'200U);
  }
  if (version >= Version{4, 1}) {
    writer.writeU32(333);
    writer.writeU32(444);
  }
  writer.writeI16(2);
  writer.writeI32(0);
  return writer;
}

inline Datagram rawFrame(const Version& version) {
  return makeMessage(MessageId::FrameOfData, rawFramePayload(version).bytes());
}

}  // namespace sylph_natnet::test
