#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sylph_natnet/echo_clock.hpp"
#include "sylph_natnet/frame_sequence.hpp"
#include "sylph_natnet/types.hpp"
#include "sylph_natnet/udp_socket.hpp"

namespace sylph_natnet {

/// How to reach a server, and how patiently.
struct ClientOptions {
  Ipv4Address server{{127, 0, 0, 1}};
  /// Of this computer, where frames arrive; any: that of the route to the server.
  Ipv4Address local_interface = kAnyAddress;
  std::uint16_t command_port = 1510;  ///< of the server
  std::uint16_t data_port = 1511;     ///< of the group; unicast frames come to the command socket
  bool multicast = false;             ///< as the server is set
  Ipv4Address multicast_group{{239, 255, 42, 99}};  ///< as the server is set
  std::optional<Version> bitstream;  ///< read frames as this version, whatever the server tells
  std::string name = "sylph";        ///< as the server is told

  std::chrono::milliseconds retry_period{500};         ///< of what was not answered
  std::chrono::milliseconds silence{1000};             ///< without frames: connect again
  std::chrono::milliseconds keep_alive_period{1000};   ///< unicast servers drop silent clients
  std::chrono::milliseconds definitions_period{5000};  ///< names are asked for again
  std::chrono::milliseconds echo_period{1000};         ///< the server's clock is compared so often
};

/// A frame and when it came.
struct ReceivedFrame {
  Frame frame;
  std::chrono::steady_clock::time_point received;  ///< when its datagram was taken
};

/// Counters since the start.
struct ClientStatistics {
  std::uint64_t datagrams = 0;     ///< from the server, of any kind
  std::uint64_t bytes = 0;         ///< of those
  std::uint64_t frames = 0;        ///< datagrams of mocap data, whether used or not
  std::uint64_t lost = 0;          ///< frame numbers that never came
  std::uint64_t late = 0;          ///< frames overtaken by a newer one, and duplicates
  std::uint64_t superseded = 0;    ///< frames passed over since a newer one waited already
  std::uint64_t parse_errors = 0;  ///< datagrams that are not what they should be
  std::uint64_t foreign = 0;       ///< datagrams from another address than the server's
  std::string last_error;          ///< of the last parse error
  Ipv4Address last_foreign{};      ///< sender of the last foreign datagram
};

/// A NatNet client that keeps itself connected: asks until it is answered, asks again for names
/// when they change, connects anew when frames stop or the server restarts. It has no thread: all
/// happens in poll(). Not thread-safe.
class Client {
 public:
  /// @throws std::runtime_error if a port is taken or the group cannot be joined
  explicit Client(const ClientOptions& options);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// Sends what is due, waits for datagrams and takes all that wait.
  /// @return the newest frame; nothing if none came in time
  std::optional<ReceivedFrame> poll(std::chrono::milliseconds timeout);
  /// As poll(), but passes over no frame.
  /// @return all new frames, oldest first
  std::vector<ReceivedFrame> pollAll(std::chrono::milliseconds timeout);

  /// Nothing while the server has not answered.
  const std::optional<ServerInfo>& serverInfo() const { return info_; }
  /// Of the stream; nothing while it is not known.
  std::optional<Version> version() const;
  /// Empty until the server told them, and again after it restarted: ids may mean others now.
  const ModelDefinitions& definitions() const { return definitions_; }
  /// Whether the server told them.
  bool definitionsKnown() const { return definitions_known_; }
  /// Counts changes of definitions().
  std::uint64_t definitionsRevision() const { return definitions_revision_; }
  /// Counts servers: another number means another clock and other ids.
  std::uint64_t session() const { return session_; }
  /// The server's clock against std::chrono::steady_clock; nothing before 3.0.
  std::optional<ClockEstimate> clock() const;
  /// Counters since the start.
  const ClientStatistics& statistics() const { return statistics_; }

 private:
  using Time = std::chrono::steady_clock::time_point;

  void sendWhatIsDue(Time now);
  void send(const Datagram& datagram);
  bool isSilent(Time now) const { return now - last_frame_ > options_.silence; }

  void drain(UdpSocket& socket, std::vector<ReceivedFrame>& frames);
  std::optional<Frame> handle(const Message& message, Time now);
  void onServerInfo(const ServerInfo& info, Time now);
  void onDefinitions(ByteReader payload);
  void onEcho(const EchoResponse& echo, Time now);
  std::optional<Frame> onFrame(ByteReader payload, Time now);
  void beginSession();
  void loseServer();

  ClientOptions options_;
  UdpSocket command_socket_;
  std::optional<UdpSocket> data_socket_;
  Datagram buffer_;

  std::optional<ServerInfo> info_;
  ModelDefinitions definitions_;
  bool definitions_known_ = false;
  std::uint64_t definitions_revision_ = 0;
  std::uint64_t session_ = 0;
  FrameSequence sequence_;
  std::uint64_t newest_ticks_ = 0;
  EchoClock echo_clock_;
  ClientStatistics statistics_;

  bool connect_wanted_ = true;
  bool definitions_wanted_ = true;
  int unanswered_definitions_requests_ = 0;
  bool session_has_frames_ = false;
  int echoes_ = 0;
  Time last_frame_;
  Time last_connect_;
  Time last_keep_alive_;
  Time last_definitions_request_;
  Time last_echo_;
};

}  // namespace sylph_natnet
