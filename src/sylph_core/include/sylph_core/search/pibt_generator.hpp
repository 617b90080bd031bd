#pragma once

#include <vector>

#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/move_ranking.hpp"
#include "sylph_core/search/pibt.hpp"

namespace sylph {

/// PIBT as LaCAM's configuration generator.
class PibtGenerator : public ConfigurationGenerator {
 public:
  /// @param ranking      what agents want; must outlive this object
  /// @param tie_breaks   per agent: who chooses first among those that waited equally long, larger
  ///                     first; equal values fall back to the lower index
  PibtGenerator(Pibt pibt, MoveRanking& ranking, std::vector<double> tie_breaks);

  std::vector<AgentId> order(const Vertices& configuration, const Vertices* before,
                             const std::vector<int>& waited) override;
  bool generate(const Vertices& from, const std::vector<AgentId>& order, Vertices& to) override;

 private:
  Pibt pibt_;
  MoveRanking* ranking_;
  std::vector<double> tie_breaks_;
};

/// Agents by time waited, longest first; ties by `tie_breaks`, largest first, then by index.
std::vector<AgentId> orderByWaiting(const std::vector<int>& waited,
                                    const std::vector<double>& tie_breaks);

/// `waited` of the next timestep: 0 for agents on their goal, one more for all others.
std::vector<int> updateWaited(const std::vector<int>& waited, const Vertices& configuration,
                              const Vertices& goals);

}  // namespace sylph
