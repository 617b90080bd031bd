#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "sylph_natnet/udp_socket.hpp"

namespace sylph_natnet {

/// Sends an input's datagrams, each behind its length in two bytes, the lower one first.
inline void sendAll(const std::uint8_t* data, std::size_t size, UdpSocket& from,
                    const Endpoint& to) {
  while (size >= 2) {
    const std::size_t length = std::min<std::size_t>(data[0] + 256U * data[1], size - 2);
    from.sendTo({data + 2, data + 2 + length}, to);
    data += 2 + length;
    size -= 2 + length;
  }
}

}  // namespace sylph_natnet
