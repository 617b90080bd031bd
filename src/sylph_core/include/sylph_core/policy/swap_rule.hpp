#pragma once

#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// The swap rule of PIBT: two agents that want past each other in a corridor have to back out to a
/// junction. Okumura 2023, "Improving LaCAM for Scalable Eventually Optimal Multi-Agent
/// Pathfinding". The pusher wants to the place where the puller is.
///
/// Places are whole numbers, so that whoever numbers the cells in its own way can ask.
/// - `to_go(agent, place)`: distance to the agent's goal [cells]
/// - `ways_on(place, back, onward)`: number of ways on from a place, without the way back and
///   without dead ends whose agent is home; sets `onward` to one of them

/// swap_required of the paper: whether pushing the puller down the corridor brings the two no
/// further: they meet no junction before one of them has to come back.
template <typename ToGo, typename WaysOn>
bool mustSwap(const ToGo& to_go, const WaysOn& ways_on, AgentId pusher, AgentId puller,
              int pusher_at, int puller_at) {
  while (to_go(pusher, puller_at) < to_go(pusher, pusher_at)) {
    int onward = puller_at;
    const int ways = ways_on(puller_at, pusher_at, onward);
    if (ways >= 2) {
      return false;
    }
    if (ways == 0) {
      break;
    }
    pusher_at = puller_at;
    puller_at = onward;
  }
  return to_go(puller, pusher_at) < to_go(puller, puller_at) &&
         (to_go(pusher, pusher_at) == 0 || to_go(pusher, puller_at) < to_go(pusher, pusher_at));
}

/// swap_possible of the paper: whether backing out leads to a junction where the two can change
/// places. The puller backs out in front of the pusher.
template <typename WaysOn>
bool canSwap(const WaysOn& ways_on, int pusher_at, int puller_at) {
  const int begin = pusher_at;
  while (puller_at != begin) {
    int onward = puller_at;
    const int ways = ways_on(puller_at, pusher_at, onward);
    if (ways != 1) {
      return ways >= 2;
    }
    pusher_at = puller_at;
    puller_at = onward;
  }
  return false;
}

}  // namespace sylph
