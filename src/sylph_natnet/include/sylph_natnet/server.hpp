#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sylph_natnet/types.hpp"
#include "sylph_natnet/udp_socket.hpp"

namespace sylph_natnet {

/// What a server is called, where it serves and what it tells of itself.
struct ServerOptions {
  Ipv4Address address{{127, 0, 0, 1}};  ///< of the interface that it serves
  std::uint16_t command_port = 1510;    ///< 0: any free one
  std::uint16_t data_port = 1511;       ///< frames leave from it, to the same of the group; 0: any
  bool multicast = false;               ///< frames to the group; false: to each client
  Ipv4Address multicast_group{{239, 255, 42, 99}};  ///< 224.0.0.0 ... 239.255.255.255
  std::string name = "sylph";                       ///< as clients are told
  Version version{4, 1};                            ///< of the bitstream
  std::uint64_t ticks_per_s = 10'000'000;           ///< of its clock
  float frame_rate_hz = 120.0F;                     ///< as clients are told
  std::chrono::milliseconds client_timeout{5000};   ///< of a unicast client that keeps silent
};

/// A NatNet server as Motive is one: answers connect, keep-alive, echo, requests for model
/// definitions and for the frame rate, and streams frames to the group or to each client that
/// connected. It has no thread and no clock of its own: the caller steps it and tells its ticks.
/// Not thread-safe.
class Server {
 public:
  /// @throws std::runtime_error if a port is taken or the group cannot be reached
  explicit Server(const ServerOptions& options);

  /// The port in use, also if any free one was asked for.
  std::uint16_t commandPort() const { return command_socket_.localEndpoint().port; }
  /// As commandPort().
  std::uint16_t dataPort() const { return data_socket_.localEndpoint().port; }
  const ServerOptions& options() const { return options_; }

  /// What clients that ask are told from now on. A frame with `models_changed` makes them ask.
  void setDefinitions(const ModelDefinitions& definitions) { definitions_ = definitions; }

  /// Answers all commands that wait.
  /// @param now_ticks  the server's clock, for echoes
  /// @return how many there were
  std::size_t serve(std::uint64_t now_ticks);
  /// Waits for a command.
  /// @return false if none came in time
  bool waitForCommand(std::chrono::milliseconds timeout) const;

  /// Streams a frame.
  /// @return to how many receivers; the group counts as one
  std::size_t send(const Frame& frame);

  /// Unicast clients that are being served.
  std::size_t clientCount() const { return clients_.size(); }

 private:
  using SteadyTime = std::chrono::steady_clock::time_point;
  struct Client {
    Endpoint endpoint;
    SteadyTime last_heard;
  };

  void answer(const Message& message, const Endpoint& sender, std::uint64_t now_ticks);
  void answerRequest(ByteReader payload, const Endpoint& sender);
  void remember(const Endpoint& sender);
  void refresh(const Endpoint& sender);
  void forget(const Endpoint& sender);
  void dropSilentClients();
  ServerInfo info() const;

  ServerOptions options_;
  ModelDefinitions definitions_;
  UdpSocket command_socket_;
  UdpSocket data_socket_;
  std::vector<Client> clients_;
};

}  // namespace sylph_natnet
