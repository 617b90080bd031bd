// Whatever clients send, a server goes on: datagrams over the loopback interface to a server.

#include <cstddef>
#include <cstdint>

#include "fuzz/datagrams.hpp"
#include "sylph_natnet/server.hpp"

// The first byte chooses the version; datagrams follow, see sendAll().
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sylph_natnet;
  if (size == 0) {
    return 0;
  }
  ServerOptions options;
  options.command_port = 0;
  options.data_port = 0;
  options.version = data[0] % 2 == 0 ? Version{4, 1} : Version{2, 9};
  Server server(options);
  server.setDefinitions({{{"robot_0", 1, -1, {}}}, {"all"}, ""});
  UdpSocket client({options.address, 0});
  const Endpoint endpoint{options.address, server.commandPort()};
  sendAll(data + 1, size - 1, client, endpoint);
  server.serve(1'000'000'000);
  Frame frame;
  frame.rigid_bodies.resize(1);
  server.send(frame);
  return 0;
}
