#include "sylph_natnet/model_codec.hpp"

#include <array>
#include <optional>
#include <utility>

#include "sylph_natnet/byte_writer.hpp"

namespace sylph_natnet {
namespace {

constexpr Version kSizedDescriptions{4, 1};

// Types of descriptions.
constexpr std::int32_t kMarkerSet = 0;
constexpr std::int32_t kRigidBody = 1;
constexpr std::int32_t kSkeleton = 2;
constexpr std::int32_t kForcePlate = 3;
constexpr std::int32_t kDevice = 4;
constexpr std::int32_t kCamera = 5;

/// How descriptions that do not tell their size are passed, and what no robot needs in them. From
/// 3.0 to 4.0 public accounts of bones contradict each other; the reading that ends where the data
/// end is the right one.
enum class Reading {
  BonesLikeBodies,      ///< with the markers that a rigid body has
  BonesWithoutMarkers,  ///< as before 3.0
  BodiesOnly,           ///< nothing but marker sets and rigid bodies can be passed
};

void skipStrings(ByteReader& reader, const char* field) {
  const std::size_t count = reader.readCount(1, field);
  for (std::size_t i = 0; i < count; ++i) {
    reader.readString(field);
  }
}

std::string readMarkerSet(ByteReader& reader) {
  std::string name = reader.readString("marker set name");
  skipStrings(reader, "marker names");
  return name;
}

/// What every version has in common.
RigidBodyDefinition readRigidBodyHead(ByteReader& reader) {
  RigidBodyDefinition body;
  body.name = reader.readString("rigid body name");
  body.id = reader.readI32("rigid body id");
  body.parent_id = reader.readI32("rigid body parent");
  for (float& value : body.offset_m) {
    value = reader.readFloat("rigid body offset");
  }
  return body;
}

/// After the head, where the description does not tell its size.
void skipRigidBodyTail(ByteReader& reader, const Version& version) {
  if (version < Version{3, 0}) {
    return;
  }
  const std::size_t marker_bytes = 12 + 4;  // position, active label
  const std::size_t markers = reader.readCount(marker_bytes, "rigid body markers");
  reader.skip(markers * marker_bytes, "rigid body markers");
  if (version >= Version{4, 0}) {
    for (std::size_t i = 0; i < markers; ++i) {
      reader.readString("marker name");
    }
  }
}

void skipSkeleton(ByteReader& reader, const Version& version, Reading reading) {
  reader.readString("skeleton name");
  reader.skip(4, "skeleton id");
  const std::size_t bones = reader.readCount(1 + 4 + 4 + 12, "bones");
  for (std::size_t i = 0; i < bones; ++i) {
    readRigidBodyHead(reader);
    if (reading == Reading::BonesLikeBodies) {
      skipRigidBodyTail(reader, version);
    }
  }
}

void skipForcePlate(ByteReader& reader) {
  reader.skip(4, "force plate id");
  reader.readString("force plate serial number");
  constexpr std::size_t kFloats = 2 + 3 + 12 * 12 + 4 * 3;  // size, origin, calibration, corners
  reader.skip(kFloats * 4, "force plate");
  reader.skip(4 + 4, "force plate type and data type");
  skipStrings(reader, "force plate channels");
}

void skipDevice(ByteReader& reader) {
  reader.skip(4, "device id");
  reader.readString("device name");
  reader.readString("device serial number");
  reader.skip(4 + 4, "device type and data type");
  skipStrings(reader, "device channels");
}

void skipCamera(ByteReader& reader) {
  reader.readString("camera name");
  reader.skip(12 + 16, "camera pose");
}

/// Passes a description that does not tell its size.
/// @return false if its layout is not known
bool skipUnsized(ByteReader& reader, std::int32_t type, const Version& version, Reading reading) {
  if (reading == Reading::BodiesOnly) {
    return false;
  }
  if (type == kSkeleton) {
    skipSkeleton(reader, version, reading);
  } else if (type == kForcePlate) {
    skipForcePlate(reader);
  } else if (type == kDevice) {
    skipDevice(reader);
  } else if (type == kCamera) {
    skipCamera(reader);
  } else {
    return false;
  }
  return true;
}

/// "skeleton 'person'" of a description that stands at `reader`.
std::string nameOf(std::int32_t type, ByteReader reader) {
  const std::array<const char*, 7> names{"marker set", "rigid body", "skeleton", "force plate",
                                         "device",     "camera",     "asset"};
  if (type < 0 || static_cast<std::size_t>(type) >= names.size()) {
    return "description of unknown type " + std::to_string(type);
  }
  std::string name = names[static_cast<std::size_t>(type)];
  try {
    if (type == kForcePlate || type == kDevice) {
      reader.skip(4, "id");
    }
    return name + " '" + reader.readString("name") + "'";
  } catch (const ParseError&) {
    return name;
  }
}

void readDescription(ByteReader& reader, const Version& version, Reading reading,
                     ModelDefinitions& definitions) {
  const std::int32_t type = reader.readI32("description type");
  std::optional<ByteReader> sized;
  if (version >= kSizedDescriptions) {
    sized = reader.take(reader.readCount(1, "description size"), "description");
  }
  ByteReader& body = sized ? *sized : reader;
  if (type == kMarkerSet) {
    definitions.marker_sets.push_back(readMarkerSet(body));
  } else if (type == kRigidBody) {
    definitions.rigid_bodies.push_back(readRigidBodyHead(body));
    if (!sized) {
      skipRigidBodyTail(body, version);
    }
  } else if (!sized) {
    const ByteReader start = body;
    if (!skipUnsized(body, type, version, reading)) {
      definitions.unread = nameOf(type, start);
    }
  }
}

/// @throws ParseError unless the last description that can be read ends where the data end
ModelDefinitions read(ByteReader payload, const Version& version, Reading reading) {
  ModelDefinitions definitions;
  const std::size_t count = payload.readCount(4, "model definitions");
  for (std::size_t i = 0; i < count; ++i) {
    readDescription(payload, version, reading, definitions);
    if (!definitions.unread.empty()) {
      return definitions;
    }
  }
  payload.requireEnd("model definitions");
  return definitions;
}

/// The definitions if this reading fits, else nothing.
std::optional<ModelDefinitions> tryToRead(ByteReader payload, const Version& version,
                                          Reading reading) {
  try {
    ModelDefinitions definitions = read(payload, version, reading);
    return definitions.unread.empty() ? std::optional(std::move(definitions)) : std::nullopt;
  } catch (const ParseError&) {
    return std::nullopt;
  }
}

std::vector<std::uint8_t> rigidBodyDescription(const RigidBodyDefinition& body,
                                               const Version& version) {
  ByteWriter writer;
  writer.writeString(body.name);
  writer.writeI32(body.id);
  writer.writeI32(body.parent_id);
  for (const float value : body.offset_m) {
    writer.writeFloat(value);
  }
  if (version >= Version{4, 2}) {
    for (const float value : {0.0F, 0.0F, 0.0F, 1.0F}) {
      writer.writeFloat(value);  // rotation offset
    }
  }
  if (version >= Version{3, 0}) {
    writer.writeI32(0);  // markers
  }
  return writer.bytes();
}

std::vector<std::uint8_t> markerSetDescription(const std::string& name) {
  ByteWriter writer;
  writer.writeString(name);
  writer.writeI32(0);  // markers
  return writer.bytes();
}

void writeDescription(ByteWriter& writer, std::int32_t type, const std::vector<std::uint8_t>& body,
                      const Version& version) {
  writer.writeI32(type);
  if (version >= kSizedDescriptions) {
    writer.writeI32(static_cast<std::int32_t>(body.size()));
  }
  writer.writeBytes(body);
}

}  // namespace

ModelDefinitions parseModelDefinitions(ByteReader payload, const Version& version) {
  for (const Reading reading : {Reading::BonesLikeBodies, Reading::BonesWithoutMarkers}) {
    if (std::optional<ModelDefinitions> definitions = tryToRead(payload, version, reading)) {
      return *std::move(definitions);
    }
  }
  return read(payload, version, Reading::BodiesOnly);
}

Datagram makeModelDefinitions(const ModelDefinitions& definitions, const Version& version) {
  ByteWriter payload;
  payload.writeI32(
      static_cast<std::int32_t>(definitions.marker_sets.size() + definitions.rigid_bodies.size()));
  for (const std::string& name : definitions.marker_sets) {
    writeDescription(payload, kMarkerSet, markerSetDescription(name), version);
  }
  for (const RigidBodyDefinition& body : definitions.rigid_bodies) {
    writeDescription(payload, kRigidBody, rigidBodyDescription(body, version), version);
  }
  return makeMessage(MessageId::ModelDefinitions, payload.bytes());
}

}  // namespace sylph_natnet
