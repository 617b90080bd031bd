#include "sylph_robot_node/shutdown_request.hpp"

#include <csignal>

namespace sylph_robot_node {
namespace {

// The one thing that a signal handler may write.
volatile std::sig_atomic_t shutdown_requested = 0;  // NOLINT(*-avoid-non-const-global-variables)

extern "C" void requestShutdown(int /*signal*/) {
  shutdown_requested = 1;
}

}  // namespace

void catchShutdownSignals() {
  std::signal(SIGINT, requestShutdown);
  std::signal(SIGTERM, requestShutdown);
}

bool isShutdownRequested() {
  return shutdown_requested != 0;
}

}  // namespace sylph_robot_node
