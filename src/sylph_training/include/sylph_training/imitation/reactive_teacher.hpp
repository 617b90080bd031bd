#pragma once

#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/policy/network.hpp"
#include "sylph_core/search/pibt.hpp"
#include "sylph_training/imitation/team_state.hpp"

namespace sylph_training {

/// Tells in any configuration what each agent should do: PIBT with the swap rule, in the order of
/// the SVOs, most selfish first.
///
/// Of equally short moves it prefers, softly, those to cells that nobody is on and those straight
/// on: that makes it repeat 75 to 82 % of its own moves that do not come closer to the goal instead
/// of 53 to 58 %, and what does not repeat cannot be learned. Preferring free cells strictly breaks
/// it: 28 instead of 46 of 48 dense worlds solved.
class ReactiveTeacher {
 public:
  /// @param problem, rng  must outlive this object
  ReactiveTeacher(const sylph::SearchProblem& problem, sylph::Rng& rng);

  /// @param team    of the same problem
  /// @param svo_deg  that tells the order, one per agent [deg]
  /// @param logits   n x 5: what a policy prefers among equally short moves; nullptr: nothing
  std::vector<sylph::Action> desiredActions(const TeamState& team,
                                            const std::vector<float>& svo_deg,
                                            const sylph::AgentRows* logits = nullptr);

 private:
  class Ranking : public sylph::MoveRanking {
   public:
    Ranking(const sylph::SearchProblem& problem, sylph::Rng& rng);
    void prepare(const TeamState& team, const sylph::AgentRows* logits);
    void rank(sylph::AgentId agent, sylph::VertexId at, const sylph::Occupants& occupied_now,
              sylph::Moves& moves) override;

   private:
    const sylph::SearchProblem* problem_;
    sylph::Rng* rng_;
    const sylph::AgentRows* logits_ = nullptr;
    std::vector<sylph::VertexId> straight_;  // per agent: where its last move would take it again
  };

  const sylph::SearchProblem* problem_;
  sylph::Pibt pibt_;
  Ranking ranking_;
};

}  // namespace sylph_training
