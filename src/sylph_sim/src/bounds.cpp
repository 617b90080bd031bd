#include "sylph_sim/bounds.hpp"

#include <stdexcept>

namespace sylph_sim {

void requireWithin(const std::string& name, double value, const sylph::Range& range,
                   const std::string& /*meaning*/) {
  if (!range.contains(value)) {
    throw std::invalid_argument(name + " = " + sylph::shortNumber(value) + ": must be " +
                                sylph::toString(range));
  }
}

}  // namespace sylph_sim
