#include "sylph_natnet/model_codec.hpp"

#include <optional>

#include "sylph_natnet/byte_writer.hpp"

namespace sylph_natnet {
namespace {

constexpr Version kSizedDescriptions{4, 1};
constexpr std::int32_t kMarkerSetType = 0;
constexpr std::int32_t kRigidBodyType = 1;

std::string readMarkerSet(ByteReader& reader) {
  std::string name = reader.readString("marker set name");
  const std::size_t markers = reader.readCount(1, "marker set");
  for (std::size_t i = 0; i < markers; ++i) {
    reader.readString("marker name");
  }
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

void readDescription(ByteReader& reader, const Version& version, ModelDefinitions& definitions) {
  const std::int32_t type = reader.readI32("description type");
  std::optional<ByteReader> sized;
  if (version >= kSizedDescriptions) {
    sized = reader.take(reader.readCount(1, "description size"), "description");
  }
  ByteReader& body = sized ? *sized : reader;
  if (type == kMarkerSetType) {
    definitions.marker_sets.push_back(readMarkerSet(body));
  } else if (type == kRigidBodyType) {
    definitions.rigid_bodies.push_back(readRigidBodyHead(body));
    if (!sized) {
      skipRigidBodyTail(body, version);
    }
  } else if (!sized) {
    definitions.complete = false;
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
  ModelDefinitions definitions;
  const std::size_t count = payload.readCount(4, "model definitions");
  for (std::size_t i = 0; i < count && definitions.complete; ++i) {
    readDescription(payload, version, definitions);
  }
  return definitions;
}

Datagram makeModelDefinitions(const ModelDefinitions& definitions, const Version& version) {
  ByteWriter payload;
  payload.writeI32(
      static_cast<std::int32_t>(definitions.marker_sets.size() + definitions.rigid_bodies.size()));
  for (const std::string& name : definitions.marker_sets) {
    writeDescription(payload, kMarkerSetType, markerSetDescription(name), version);
  }
  for (const RigidBodyDefinition& body : definitions.rigid_bodies) {
    writeDescription(payload, kRigidBodyType, rigidBodyDescription(body, version), version);
  }
  return makeMessage(MessageId::ModelDefinitions, payload.bytes());
}

}  // namespace sylph_natnet
