#include "sylph_core/search/deadline.hpp"

#include <chrono>

namespace sylph {

double steadyTime() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace sylph
