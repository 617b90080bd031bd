// Whatever a server sends, a client goes on: datagrams over the loopback interface to a client.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "sylph_natnet/client.hpp"

namespace sylph_natnet {
namespace {

/// What the input's first byte says of how the client reads frames; nothing: as the server tells.
std::optional<Version> bitstream(std::uint8_t byte) {
  constexpr std::array<Version, 7> kVersions{
      {{2, 0}, {2, 5}, {2, 9}, {3, 0}, {4, 0}, {4, 1}, {4, 4}}};
  return byte < kVersions.size() ? std::optional<Version>(kVersions[byte]) : std::nullopt;
}

/// Sends the input's datagrams, each behind its length in two bytes, the lower one first.
void sendAll(const std::uint8_t* data, std::size_t size, UdpSocket& server,
             const Endpoint& client) {
  while (size >= 2) {
    const std::size_t length = std::min<std::size_t>(data[0] + 256U * data[1], size - 2);
    server.sendTo({data + 2, data + 2 + length}, client);
    data += 2 + length;
    size -= 2 + length;
  }
}

}  // namespace
}  // namespace sylph_natnet

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sylph_natnet;
  if (size == 0) {
    return 0;
  }
  UdpSocket server({{{127, 0, 0, 1}}, 0});
  ClientOptions options;
  options.command_port = server.localEndpoint().port;
  options.bitstream = bitstream(data[0]);
  Client client(options);
  client.pollAll(std::chrono::milliseconds(0));  // says where it is
  Datagram hello;
  const std::optional<Endpoint> sender = server.receive(hello);
  if (sender) {
    sendAll(data + 1, size - 1, server, *sender);
    client.pollAll(std::chrono::milliseconds(0));
    client.clock();
    client.pollAll(std::chrono::milliseconds(0));
  }
  return 0;
}
