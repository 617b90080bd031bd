// Whatever a server sends, a client goes on: datagrams over the loopback interface to a client.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fuzz/datagrams.hpp"
#include "sylph_natnet/client.hpp"

namespace sylph_natnet {
namespace {

/// What the input's first byte says of how the client reads frames; nothing: as the server tells.
std::optional<Version> bitstream(std::uint8_t byte) {
  constexpr std::array<Version, 7> kVersions{
      {{2, 0}, {2, 5}, {2, 9}, {3, 0}, {4, 0}, {4, 1}, {4, 4}}};
  return byte < kVersions.size() ? std::optional<Version>(kVersions[byte]) : std::nullopt;
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
