#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sylph_natnet/message.hpp"

namespace sylph_natnet {

/// The four numbers of an IPv4 address; 0.0.0.0 is any.
using Ipv4Address = std::array<std::uint8_t, 4>;
constexpr Ipv4Address kAnyAddress{};  ///< 0.0.0.0: whatever interface

/// One end of a link.
struct Endpoint {
  Ipv4Address address{};
  std::uint16_t port = 0;  ///< host byte order; 0: any
};
bool operator==(const Endpoint& a, const Endpoint& b);

/// "192.168.1.10"
std::string toString(const Ipv4Address& address);
/// "192.168.1.10:1510"
std::string toString(const Endpoint& endpoint);

/// @param text  an address or a host's name
/// @throws std::invalid_argument if it is neither
Ipv4Address addressFromString(const std::string& text);
/// 224.0.0.0 ... 239.255.255.255
bool isMulticast(const Ipv4Address& address);

/// A UDP socket that never blocks; waiting is waitForInput()'s. Closed by the destructor.
class UdpSocket {
 public:
  /// @param local  where it receives; port 0: any free one
  /// @param shared  several sockets may use this port, as multicast receivers do
  /// @throws std::runtime_error if the system refuses
  explicit UdpSocket(const Endpoint& local, bool shared = false);
  ~UdpSocket();
  UdpSocket(UdpSocket&& other) noexcept;
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;
  UdpSocket& operator=(UdpSocket&&) = delete;

  /// Receives what is sent to `group` on the network of the local address `interface`.
  /// @throws std::runtime_error if the system refuses, as when no interface has that address
  void joinGroup(const Ipv4Address& group, const Ipv4Address& interface);
  /// Sends to groups through the network of the local address `interface`, to this machine too.
  /// @throws std::runtime_error if the system refuses
  void sendGroupsThrough(const Ipv4Address& interface);

  /// @return false if the system did not take it (no route, network down)
  bool sendTo(const Datagram& datagram, const Endpoint& receiver);
  /// Takes one waiting datagram.
  /// @return its sender, or nothing if none waits
  std::optional<Endpoint> receive(Datagram& datagram);

  /// Where it receives, the port as the system chose it.
  Endpoint localEndpoint() const;
  /// For select() and its like; stays the socket's.
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// Waits until a socket has a datagram.
/// @return false if none came in time
bool waitForInput(const std::vector<const UdpSocket*>& sockets, std::chrono::milliseconds timeout);

/// The local address from which a datagram to `remote` would leave.
/// @return nothing if there is no way to it
std::optional<Ipv4Address> localAddressTowards(const Ipv4Address& remote);

}  // namespace sylph_natnet
