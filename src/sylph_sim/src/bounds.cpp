#include "sylph_sim/bounds.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace sylph_sim {
namespace {

[[noreturn]] void refuse(const std::string& name, double value, const std::string& allowed) {
  std::ostringstream text;
  text << name << " = " << value << ": must be " << allowed;
  throw std::invalid_argument(text.str());
}

}  // namespace

void requirePositive(const std::string& name, double value) {
  if (!std::isfinite(value) || value <= 0.0) {
    refuse(name, value, "> 0");
  }
}

void requireNotNegative(const std::string& name, double value) {
  if (!std::isfinite(value) || value < 0.0) {
    refuse(name, value, ">= 0");
  }
}

void requireInRange(const std::string& name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    std::ostringstream allowed;
    allowed << "in " << low << " ... " << high;
    refuse(name, value, allowed.str());
  }
}

}  // namespace sylph_sim
