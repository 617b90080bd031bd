#include "sylph_natnet/udp_socket.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace sylph_natnet {
namespace {

constexpr std::size_t kLargestDatagram = 65536;

in_addr toSystem(const Ipv4Address& address) {
  in_addr system{};
  // Both are in network order, byte by byte.
  std::memcpy(&system.s_addr, address.data(), address.size());
  return system;
}

sockaddr_in toSystem(const Endpoint& endpoint) {
  sockaddr_in system{};
  system.sin_family = AF_INET;
  system.sin_port = htons(endpoint.port);
  system.sin_addr = toSystem(endpoint.address);
  return system;
}

Endpoint fromSystem(const sockaddr_in& system) {
  Endpoint endpoint;
  std::memcpy(endpoint.address.data(), &system.sin_addr.s_addr, endpoint.address.size());
  endpoint.port = ntohs(system.sin_port);
  return endpoint;
}

std::runtime_error failure(const std::string& what, int error_number = errno) {
  return std::runtime_error(what + ": " + std::generic_category().message(error_number));
}

}  // namespace

bool operator==(const Endpoint& a, const Endpoint& b) {
  return a.address == b.address && a.port == b.port;
}

std::string toString(const Ipv4Address& address) {
  std::string text;
  for (const std::uint8_t part : address) {
    text += (text.empty() ? "" : ".") + std::to_string(part);
  }
  return text;
}

std::string toString(const Endpoint& endpoint) {
  return toString(endpoint.address) + ":" + std::to_string(endpoint.port);
}

Ipv4Address addressFromString(const std::string& text) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  if (text.empty() || getaddrinfo(text.c_str(), nullptr, &hints, &found) != 0) {
    throw std::invalid_argument("address '" + text + "': neither an IPv4 address nor a known host");
  }
  sockaddr_in system{};
  std::memcpy(&system, found->ai_addr, sizeof(system));
  freeaddrinfo(found);
  return fromSystem(system).address;
}

bool isMulticast(const Ipv4Address& address) {
  return address[0] >= 224 && address[0] <= 239;
}

UdpSocket::UdpSocket(const Endpoint& local, bool shared)
    : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  if (descriptor_ < 0) {
    throw failure("UDP socket");
  }
  const int on = 1;
  const sockaddr_in address = toSystem(local);
  if ((shared && setsockopt(descriptor_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on)) != 0) ||
      bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    const int error_number = errno;
    close(descriptor_);
    throw failure("UDP socket on " + toString(local), error_number);
  }
}

UdpSocket::~UdpSocket() {
  if (descriptor_ >= 0) {
    close(descriptor_);
  }
}

UdpSocket::UdpSocket(UdpSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

// These change the socket, though not the number that stands for it.
// NOLINTBEGIN(readability-make-member-function-const)

void UdpSocket::joinGroup(const Ipv4Address& group, const Ipv4Address& interface) {
  ip_mreq request{};
  request.imr_multiaddr = toSystem(group);
  request.imr_interface = toSystem(interface);
  if (setsockopt(descriptor_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &request, sizeof(request)) != 0) {
    throw failure("joining " + toString(group) + " on interface " + toString(interface));
  }
}

void UdpSocket::sendGroupsThrough(const Ipv4Address& interface) {
  const in_addr address = toSystem(interface);
  // Simulator and bridge may be on one computer.
  const unsigned char loop = 1;
  if (setsockopt(descriptor_, IPPROTO_IP, IP_MULTICAST_IF, &address, sizeof(address)) != 0 ||
      setsockopt(descriptor_, IPPROTO_IP, IP_MULTICAST_LOOP, &loop, sizeof(loop)) != 0) {
    throw failure("multicast through interface " + toString(interface));
  }
}

bool UdpSocket::sendTo(const Datagram& datagram, const Endpoint& receiver) {
  const sockaddr_in address = toSystem(receiver);
  return sendto(descriptor_, datagram.data(), datagram.size(), 0,
                reinterpret_cast<const sockaddr*>(&address), sizeof(address)) >= 0;
}

std::optional<Endpoint> UdpSocket::receive(Datagram& datagram) {
  std::array<std::uint8_t, kLargestDatagram> buffer;  // not initialised: it is filled below
  sockaddr_in sender{};
  socklen_t sender_size = sizeof(sender);
  const ssize_t size = recvfrom(descriptor_, buffer.data(), buffer.size(), 0,
                                reinterpret_cast<sockaddr*>(&sender), &sender_size);
  if (size < 0) {
    return std::nullopt;
  }
  datagram.assign(buffer.begin(), buffer.begin() + size);
  return fromSystem(sender);
}

// NOLINTEND(readability-make-member-function-const)

Endpoint UdpSocket::localEndpoint() const {
  sockaddr_in local{};
  socklen_t size = sizeof(local);
  if (getsockname(descriptor_, reinterpret_cast<sockaddr*>(&local), &size) != 0) {
    throw failure("UDP socket's own address");
  }
  return fromSystem(local);
}

bool waitForInput(const std::vector<const UdpSocket*>& sockets, std::chrono::milliseconds timeout) {
  std::vector<pollfd> requests;
  requests.reserve(sockets.size());
  for (const UdpSocket* socket : sockets) {
    requests.push_back({socket->descriptor(), POLLIN, 0});
  }
  return poll(requests.data(), requests.size(), static_cast<int>(timeout.count())) > 0;
}

std::optional<Ipv4Address> localAddressTowards(const Ipv4Address& remote) {
  const UdpSocket probe(Endpoint{});
  const sockaddr_in address = toSystem(Endpoint{remote, 9});
  // Connecting a UDP socket sends nothing; it only asks for the route.
  if (connect(probe.descriptor(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) !=
      0) {
    return std::nullopt;
  }
  return probe.localEndpoint().address;
}

}  // namespace sylph_natnet
