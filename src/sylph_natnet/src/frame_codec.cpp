#include "sylph_natnet/frame_codec.hpp"

#include <stdexcept>

#include "sylph_natnet/byte_writer.hpp"

namespace sylph_natnet {
namespace {

constexpr Version kSizedSections{4, 1};  ///< each section tells its size in bytes from here on
constexpr std::size_t kPointBytes = 12;
constexpr std::size_t kRigidBodyBytes = 38;  ///< from 3.0 on
constexpr std::int16_t kTrackedBit = 1;
constexpr std::int16_t kRecordingBit = 1;
constexpr std::int16_t kModelsChangedBit = 2;

/// In 4.1 and later: the bytes of a section's body.
std::size_t readSectionBytes(ByteReader& reader, const char* section) {
  return reader.readCount(1, section);
}

/// Passes a section whose size is told.
void skipSized(ByteReader& reader, const char* section) {
  reader.skip(4, section);
  reader.skip(readSectionBytes(reader, section), section);
}

RigidBodySample readRigidBody(ByteReader& reader, const Version& version) {
  RigidBodySample body;
  body.id = reader.readI32("rigid body id");
  for (float& value : body.position_m) {
    value = reader.readFloat("rigid body position");
  }
  for (float& value : body.orientation_xyzw) {
    value = reader.readFloat("rigid body orientation");
  }
  if (version < Version{3, 0}) {
    const std::size_t marker_bytes = kPointBytes + 4 + 4;  // position, id, size
    const std::size_t markers = reader.readCount(marker_bytes, "rigid body markers");
    reader.skip(markers * marker_bytes, "rigid body markers");
  }
  body.mean_error_m = reader.readFloat("rigid body mean error");
  if (version >= Version{2, 6}) {
    body.tracked = (reader.readI16("rigid body flags") & kTrackedBit) != 0;
  }
  return body;
}

std::vector<RigidBodySample> readRigidBodies(ByteReader& reader, const Version& version) {
  std::vector<RigidBodySample> bodies;
  if (version >= kSizedSections) {
    const std::size_t count = reader.readCount(kRigidBodyBytes, "rigid bodies");
    const std::size_t bytes = readSectionBytes(reader, "rigid bodies");
    ByteReader section = reader.take(bytes, "rigid bodies");
    // A record that has grown is read as far as it is known.
    const std::size_t stride = count > 0 ? bytes / count : 0;
    if (count > 0 && (bytes % count != 0 || stride < kRigidBodyBytes)) {
      throw ParseError("rigid bodies: " + std::to_string(count) + " in " + std::to_string(bytes) +
                       " bytes");
    }
    for (std::size_t i = 0; i < count; ++i) {
      ByteReader record = section.take(stride, "rigid body");
      bodies.push_back(readRigidBody(record, version));
    }
    return bodies;
  }
  const std::size_t count = reader.readCount(kRigidBodyBytes - 2, "rigid bodies");
  for (std::size_t i = 0; i < count; ++i) {
    bodies.push_back(readRigidBody(reader, version));
  }
  return bodies;
}

void skipMarkers(ByteReader& reader, const Version& version) {
  if (version >= kSizedSections) {
    skipSized(reader, "marker sets");
    skipSized(reader, "other markers");
    return;
  }
  const std::size_t sets = reader.readCount(5, "marker sets");
  for (std::size_t i = 0; i < sets; ++i) {
    reader.readString("marker set name");
    reader.skip(reader.readCount(kPointBytes, "marker set") * kPointBytes, "marker set");
  }
  reader.skip(reader.readCount(kPointBytes, "other markers") * kPointBytes, "other markers");
}

void skipSkeletons(ByteReader& reader, const Version& version) {
  if (version < Version{2, 1}) {
    return;
  }
  const std::size_t skeletons = reader.readCount(8, "skeletons");
  for (std::size_t i = 0; i < skeletons; ++i) {
    reader.skip(4, "skeleton id");
    const std::size_t bones = reader.readCount(kRigidBodyBytes - 2, "bones");
    for (std::size_t bone = 0; bone < bones; ++bone) {
      readRigidBody(reader, version);
    }
  }
}

void skipLabelledMarkers(ByteReader& reader, const Version& version) {
  if (version < Version{2, 3}) {
    return;
  }
  std::size_t marker_bytes = 4 + kPointBytes + 4;    // id, position, size
  marker_bytes += version >= Version{2, 6} ? 2 : 0;  // flags
  marker_bytes += version >= Version{3, 0} ? 4 : 0;  // residual
  reader.skip(reader.readCount(marker_bytes, "labelled markers") * marker_bytes,
              "labelled markers");
}

/// Force plates and devices share a layout.
void skipAnalog(ByteReader& reader, const char* section) {
  const std::size_t plates = reader.readCount(8, section);
  for (std::size_t i = 0; i < plates; ++i) {
    reader.skip(4, section);
    const std::size_t channels = reader.readCount(4, section);
    for (std::size_t channel = 0; channel < channels; ++channel) {
      reader.skip(reader.readCount(4, section) * 4, section);
    }
  }
}

/// All between the rigid bodies and the suffix.
void skipRest(ByteReader& reader, const Version& version) {
  if (version >= kSizedSections) {
    for (const char* section :
         {"skeletons", "assets", "labelled markers", "force plates", "devices"}) {
      skipSized(reader, section);
    }
    return;
  }
  skipSkeletons(reader, version);
  skipLabelledMarkers(reader, version);
  if (version >= Version{2, 9}) {
    skipAnalog(reader, "force plates");
  }
  if (version >= Version{2, 11}) {
    skipAnalog(reader, "devices");
  }
}

void readSuffix(ByteReader& reader, const Version& version, Frame& frame) {
  if (version < Version{3, 0}) {
    frame.latency_s = reader.readFloat("latency");
  }
  reader.skip(8, "timecode");
  frame.timestamp_s = version >= Version{2, 7} ? reader.readDouble("timestamp")
                                               : static_cast<double>(reader.readFloat("timestamp"));
  if (version >= Version{3, 0}) {
    frame.mid_exposure_ticks = reader.readU64("mid-exposure ticks");
    frame.data_received_ticks = reader.readU64("data-received ticks");
    frame.transmit_ticks = reader.readU64("transmit ticks");
  }
  if (version >= kSizedSections) {
    reader.skip(8, "precision timestamp");
  }
  const std::int16_t flags = reader.readI16("frame flags");
  frame.recording = (flags & kRecordingBit) != 0;
  frame.models_changed = (flags & kModelsChangedBit) != 0;
  reader.skip(4, "end tag");
}

void writeEmptySection(ByteWriter& writer, const Version& version) {
  writer.writeI32(0);
  if (version >= kSizedSections) {
    writer.writeI32(0);
  }
}

void writeRigidBodies(ByteWriter& writer, const Frame& frame, const Version& version) {
  const std::size_t count = frame.rigid_bodies.size();
  writer.writeI32(static_cast<std::int32_t>(count));
  if (version >= kSizedSections) {
    writer.writeI32(static_cast<std::int32_t>(count * kRigidBodyBytes));
  }
  for (const RigidBodySample& body : frame.rigid_bodies) {
    writer.writeI32(body.id);
    for (const float value : body.position_m) {
      writer.writeFloat(value);
    }
    for (const float value : body.orientation_xyzw) {
      writer.writeFloat(value);
    }
    if (version < Version{3, 0}) {
      writer.writeI32(0);  // markers
    }
    writer.writeFloat(body.mean_error_m);
    if (version >= Version{2, 6}) {
      writer.writeI16(body.tracked ? kTrackedBit : std::int16_t{0});
    }
  }
}

/// Sections between the rigid bodies and the suffix.
int sectionsAfterRigidBodies(const Version& version) {
  int sections = 0;
  sections += version >= Version{2, 1} ? 1 : 0;   // skeletons
  sections += version >= Version{2, 3} ? 1 : 0;   // labelled markers
  sections += version >= Version{2, 9} ? 1 : 0;   // force plates
  sections += version >= Version{2, 11} ? 1 : 0;  // devices
  sections += version >= kSizedSections ? 1 : 0;  // assets
  return sections;
}

void writeSuffix(ByteWriter& writer, const Frame& frame, const Version& version) {
  if (version < Version{3, 0}) {
    writer.writeFloat(frame.latency_s);
  }
  writer.writeU64(0);  // timecode and its subframe
  if (version >= Version{2, 7}) {
    writer.writeDouble(frame.timestamp_s);
  } else {
    writer.writeFloat(static_cast<float>(frame.timestamp_s));
  }
  if (version >= Version{3, 0}) {
    writer.writeU64(frame.mid_exposure_ticks);
    writer.writeU64(frame.data_received_ticks);
    writer.writeU64(frame.transmit_ticks);
  }
  if (version >= kSizedSections) {
    writer.writeU64(0);  // precision timestamp
  }
  writer.writeI16(static_cast<std::int16_t>((frame.recording ? kRecordingBit : 0) |
                                            (frame.models_changed ? kModelsChangedBit : 0)));
  writer.writeI32(0);  // end tag
}

}  // namespace

Frame parseFrame(ByteReader payload, const Version& version) {
  if (version < kOldestVersion) {
    throw ParseError("bitstream " + toString(version) + ": older than " + toString(kOldestVersion));
  }
  Frame frame;
  frame.number = payload.readI32("frame number");
  // Sections have no directory: to come to one, all before it have to be read.
  skipMarkers(payload, version);
  frame.rigid_bodies = readRigidBodies(payload, version);
  skipRest(payload, version);
  readSuffix(payload, version, frame);
  // A frame that was read by the wrong version rarely ends where its data do.
  payload.requireEnd("frame");
  return frame;
}

Datagram makeFrame(const Frame& frame, const Version& version) {
  if (version < kOldestVersion) {
    throw std::invalid_argument("bitstream " + toString(version) + ": at least " +
                                toString(kOldestVersion));
  }
  ByteWriter payload;
  payload.writeI32(frame.number);
  writeEmptySection(payload, version);  // marker sets
  writeEmptySection(payload, version);  // other markers
  writeRigidBodies(payload, frame, version);
  for (int i = 0; i < sectionsAfterRigidBodies(version); ++i) {
    writeEmptySection(payload, version);
  }
  writeSuffix(payload, frame, version);
  return makeMessage(MessageId::FrameOfData, payload.bytes());
}

}  // namespace sylph_natnet
