#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// A plan that cannot be carried out.
class PlanRefused : public std::invalid_argument {
 public:
  /// @param message  one line for the operator, with timestep and agents
  PlanRefused(Timestep timestep, std::vector<AgentId> agents, const std::string& message)
      : std::invalid_argument(message), timestep_(timestep), agents_(std::move(agents)) {}

  Timestep timestep() const { return timestep_; }
  const std::vector<AgentId>& agents() const { return agents_; }

 private:
  Timestep timestep_;
  std::vector<AgentId> agents_;
};

}  // namespace sylph
