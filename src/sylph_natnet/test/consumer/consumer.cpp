// What a user of the installed library writes: asks where a server might be.
#include <sylph_natnet/udp_socket.hpp>

int main() {
  const sylph_natnet::Ipv4Address group = sylph_natnet::addressFromString("239.255.42.99");
  return sylph_natnet::isMulticast(group) ? 0 : 1;
}
