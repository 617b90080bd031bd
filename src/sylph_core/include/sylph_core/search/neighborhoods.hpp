#pragma once

#include <array>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/graph.hpp"
#include "sylph_core/search/improvement_settings.hpp"
#include "sylph_core/search/reservation_table.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// Ways to choose the agents whose paths are planned anew together.
enum class NeighborhoodKind {
  Random,    ///< any agents
  Delayed,   ///< a delayed agent and those that keep it from arriving earlier
  Crossing,  ///< agents that pass a vertex or those around it, at any time
  Jam,       ///< agents close to each other in space and time, around where one loses time
};

/// All kinds.
constexpr std::array<NeighborhoodKind, 4> kNeighborhoodKinds = {
    NeighborhoodKind::Random, NeighborhoodKind::Delayed, NeighborhoodKind::Crossing,
    NeighborhoodKind::Jam};

/// Chooses neighbourhoods of a solution for large-neighbourhood search.
///
/// Li et al. 2021, "Anytime Multi-Agent Path Finding via Large Neighborhood Search", for the first
/// three kinds.
class Neighborhoods {
 public:
  /// @param problem, table  must outlive this object
  Neighborhoods(const SearchProblem& problem, const ReservationTable& table,
                const ImprovementSettings& settings);

  /// @param size  > 0, at most the number of agents
  /// @return at most `size` different agents, one at least
  std::vector<AgentId> pick(NeighborhoodKind kind, int size, Rng& rng);

 private:
  std::vector<AgentId> pickRandom(int size, Rng& rng) const;
  std::vector<AgentId> pickDelayed(int size, Rng& rng);
  std::vector<AgentId> pickCrossing(int size, Rng& rng);
  std::vector<AgentId> pickJam(int size, Rng& rng);
  AgentId drawDelayedAgent(Rng& rng) const;
  int delayOf(AgentId agent) const;
  void walk(AgentId agent, int size, Rng& rng);
  void beginPick();
  void add(AgentId agent);
  int agentCount() const { return problem_->agentCount(); }
  bool isFull(int size) const { return static_cast<int>(picked_.size()) >= size; }

  /// Picks the agents that pass `center` or what is around it, nearest first.
  /// @param addVisitors  adds those that pass a vertex in time
  template <typename AddVisitors>
  void pickAround(VertexId center, int size, AddVisitors addVisitors);

  const SearchProblem* problem_;
  const ReservationTable* table_;
  int walks_;
  Timestep jam_reach_;
  std::vector<AgentId> picked_;
  std::vector<bool> is_picked_;
  std::vector<VertexId> frontier_;  // scratch of pickAround()
  std::vector<bool> is_seen_;
};

}  // namespace sylph
