#include "sylph_natnet/message.hpp"

#include <stdexcept>

#include "sylph_natnet/byte_writer.hpp"

namespace sylph_natnet {
namespace {

constexpr std::size_t kHeaderBytes = 4;
constexpr std::size_t kLargestPayload = 65507 - kHeaderBytes;
constexpr std::size_t kNameBytes = 256;
/// Bits of the model definition types 0 and 1.
constexpr std::uint32_t kMarkerSetsAndRigidBodies = 3;

void writeSender(ByteWriter& writer, const std::string& name,
                 const std::array<std::uint8_t, 4>& app_version, const Version& version) {
  writer.writeFixedString(name, kNameBytes);
  for (const std::uint8_t part : app_version) {
    writer.writeU8(part);
  }
  writer.writeU8(static_cast<std::uint8_t>(version.major));
  writer.writeU8(static_cast<std::uint8_t>(version.minor));
  writer.writeU16(0);
}

}  // namespace

Message openMessage(const std::uint8_t* data, std::size_t size) {
  ByteReader reader(data, size);
  const auto id = static_cast<MessageId>(reader.readU16("message id"));
  reader.skip(2, "payload size");
  return {id, reader};
}

Datagram makeMessage(MessageId id, const std::vector<std::uint8_t>& payload) {
  if (payload.size() > kLargestPayload) {
    throw std::invalid_argument("NatNet payload of " + std::to_string(payload.size()) +
                                " bytes: at most " + std::to_string(kLargestPayload));
  }
  ByteWriter writer;
  writer.writeU16(static_cast<std::uint16_t>(id));
  writer.writeU16(static_cast<std::uint16_t>(payload.size()));
  writer.writeBytes(payload);
  return writer.bytes();
}

Datagram makeConnect(const std::string& client_name, const Version& version) {
  ByteWriter payload;
  writeSender(payload, client_name, {}, version);
  return makeMessage(MessageId::Connect, payload.bytes());
}

Datagram makeModelDefinitionsRequest(bool with_type_mask) {
  ByteWriter payload;
  if (with_type_mask) {
    payload.writeU32(kMarkerSetsAndRigidBodies);
  }
  return makeMessage(MessageId::RequestModelDefinitions, payload.bytes());
}

Datagram makeRequest(const std::string& command) {
  ByteWriter payload;
  payload.writeString(command);
  return makeMessage(MessageId::Request, payload.bytes());
}

Datagram makeEchoRequest(std::uint64_t client_stamp) {
  ByteWriter payload;
  payload.writeU64(client_stamp);
  return makeMessage(MessageId::EchoRequest, payload.bytes());
}

Datagram makeServerInfo(const ServerInfo& info) {
  ByteWriter payload;
  writeSender(payload, info.name, info.app_version, info.version);
  if (info.version >= Version{3, 0}) {
    payload.writeU64(info.ticks_per_s);
    payload.writeU16(info.data_port);
    payload.writeU8(info.is_multicast ? 1 : 0);
    for (const std::uint8_t part : info.multicast_group) {
      payload.writeU8(part);
    }
  }
  return makeMessage(MessageId::ServerInfo, payload.bytes());
}

Datagram makeEchoResponse(const EchoResponse& echo) {
  ByteWriter payload;
  payload.writeU64(echo.client_stamp);
  payload.writeU64(echo.server_ticks);
  return makeMessage(MessageId::EchoResponse, payload.bytes());
}

ServerInfo parseServerInfo(ByteReader payload) {
  ServerInfo info;
  info.name = payload.readFixedString(kNameBytes, "server name");
  for (std::uint8_t& part : info.app_version) {
    part = payload.readU8("server's own version");
  }
  info.version.major = payload.readU8("bitstream version");
  info.version.minor = payload.readU8("bitstream version");
  payload.skip(2, "bitstream version");
  if (info.version >= Version{3, 0}) {
    info.ticks_per_s = payload.readU64("ticks per second");
    info.data_port = payload.readU16("data port");
    info.is_multicast = payload.readU8("multicast flag") != 0;
    for (std::uint8_t& part : info.multicast_group) {
      part = payload.readU8("multicast group");
    }
  }
  return info;
}

EchoResponse parseEchoResponse(ByteReader payload) {
  EchoResponse echo;
  echo.client_stamp = payload.readU64("echoed stamp");
  echo.server_ticks = payload.readU64("server's clock");
  return echo;
}

std::uint64_t parseEchoRequest(ByteReader payload) {
  return payload.readU64("stamp to echo");
}

}  // namespace sylph_natnet
