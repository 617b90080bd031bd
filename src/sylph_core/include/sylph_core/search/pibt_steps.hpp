#pragma once

#include <vector>

#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/move_ranking.hpp"
#include "sylph_core/search/pibt.hpp"

namespace sylph {

/// PIBT's joint steps from one configuration.
class PibtSteps : public JointSteps {
 public:
  /// All arguments by reference must outlive this object.
  PibtSteps(Pibt& pibt, MoveRanking& ranking, const Vertices& configuration,
            std::vector<AgentId> order);

  const std::vector<AgentId>& order() const override { return order_; }
  bool generate(Vertices& to) override;

 private:
  Pibt* pibt_;
  MoveRanking* ranking_;
  const Vertices* configuration_;
  std::vector<AgentId> order_;
};

/// Agents by priority, highest first; ties by `tie_breaks`, largest first, then by index.
std::vector<AgentId> orderByPriority(const Priorities& priorities,
                                     const std::vector<double>& tie_breaks);

/// The priorities of the next timestep: 0 for agents on their goal, one more for all others.
Priorities updatePriorities(const Priorities& priorities, const Vertices& configuration,
                            const Vertices& goals);

}  // namespace sylph
