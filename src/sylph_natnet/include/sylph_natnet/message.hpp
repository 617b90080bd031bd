#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sylph_natnet/byte_reader.hpp"
#include "sylph_natnet/types.hpp"

/// NatNet's datagrams: u16 id, u16 payload bytes, payload; little endian, packed.
namespace sylph_natnet {

/// First field of each datagram, by the names of OptiTrack's SDK.
enum class MessageId : std::uint16_t {
  Connect = 0,
  ServerInfo = 1,
  Request = 2,
  Response = 3,
  RequestModelDefinitions = 4,
  ModelDefinitions = 5,
  RequestFrame = 6,
  FrameOfData = 7,
  Text = 8,
  Disconnect = 9,
  KeepAlive = 10,
  DisconnectByTimeout = 11,
  EchoRequest = 12,
  EchoResponse = 13,
  Discovery = 14,
  UnrecognizedRequest = 100,
};

using Datagram = std::vector<std::uint8_t>;  ///< A whole datagram, header and payload

/// A datagram taken apart; `payload` looks into it.
struct Message {
  MessageId id;        ///< may be one that this enum does not have
  ByteReader payload;  ///< what stands behind the header
};

/// The payload is what was received: its length in the header may be wrong or too small a number.
/// @throws ParseError if there is no header
Message openMessage(const std::uint8_t* data, std::size_t size);
inline Message openMessage(const Datagram& datagram) {
  return openMessage(datagram.data(), datagram.size());
}

/// @throws std::invalid_argument if the payload does not fit into a UDP datagram
Datagram makeMessage(MessageId id, const std::vector<std::uint8_t>& payload = {});

// What a client sends.

/// @param version  bitstream that the client can read
Datagram makeConnect(const std::string& client_name, const Version& version);
/// @param with_type_mask  adds which descriptions are wanted (marker sets and rigid bodies),
/// without
///                        which some servers keep silent
Datagram makeModelDefinitionsRequest(bool with_type_mask);
/// @param command  "FrameRate", "Bitstream,4.1", ...
Datagram makeRequest(const std::string& command);
/// @param client_stamp  comes back in the answer.
Datagram makeEchoRequest(std::uint64_t client_stamp);

// What a server sends.

/// Answer to a connect.
Datagram makeServerInfo(const ServerInfo& info);
/// Answer to an echo request.
Datagram makeEchoResponse(const EchoResponse& echo);

// Reading of payloads. All throw ParseError.

/// Of the answer to a connect, by the version that stands in it.
ServerInfo parseServerInfo(ByteReader payload);
/// Of the answer to an echo request.
EchoResponse parseEchoResponse(ByteReader payload);
/// @return the client's stamp.
std::uint64_t parseEchoRequest(ByteReader payload);

}  // namespace sylph_natnet
