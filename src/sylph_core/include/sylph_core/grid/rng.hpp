#pragma once

#include <random>

namespace sylph {

/// The one random generator of the suite. It is always passed in: the same seed gives the same
/// result.
using Rng = std::mt19937;

}  // namespace sylph
