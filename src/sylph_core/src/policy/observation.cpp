#include "sylph_core/policy/observation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "sylph_core/social/svo.hpp"

namespace sylph {
namespace {

constexpr float kFarAway = 64.F;        // [cells] where distances saturate
constexpr float kPriorityScale = 64.F;  // [timesteps]
constexpr float kMostPriority = 2.5F;   // where it saturates, in units of kPriorityScale
constexpr float kCostToGoRange = 8.F;   // [cells] where the cost-to-go channel saturates
constexpr int kHalfView = kFieldOfView / 2;
constexpr std::size_t kDirections = 4;
constexpr auto kWidestSvo_deg = static_cast<float>(kSvoLevelSpacingDeg * kMostProsocialLevel);

constexpr std::size_t at(Channel channel) {
  return static_cast<std::size_t>(channel);
}

constexpr std::size_t at(VectorEntry entry) {
  return static_cast<std::size_t>(entry);
}

constexpr std::array<Action, kDirections> kMoves = {Action::North, Action::East, Action::South,
                                                    Action::West};

float saturated(double distance_cells) {
  return std::min(static_cast<float>(distance_cells) / kFarAway, 1.F);
}

/// Sets four channels to the bits of four directions.
void setDirections(Channel first, const RightOfWay::Directions& bits, float* features) {
  for (std::size_t way = 0; way < kDirections; ++way) {
    features[at(first) + way] = bits[way] ? 1.F : 0.F;
  }
}

std::vector<ObservationEntry> allEntries() {
  std::vector<ObservationEntry> entries;
  const auto bit = [&](const std::string& name, const std::string& meaning) {
    entries.push_back({name, meaning, 0.0, 1.0});
  };
  const auto bits = [&](const std::string& name, const std::string& before,
                        const std::string& after) {
    for (const char* way : {"north", "east", "south", "west"}) {
      bit(name + "_" + way, before + way + after);
    }
  };
  bit("obstacle", "an obstacle or outside the map");
  bit("agent", "an agent, oneself included");
  bit("own_goal", "one's own goal");
  bit("projected_goal", "goal of an agent in view, clamped to the border of the view");
  bit("less_prosocial", "an agent whose SVO is lower than one's own");
  bits("nearer", "from here a step ", " comes closer to one's own goal");
  bit("other_goal", "the goal of another agent");
  bit("farther_to_go", "an agent that has farther to its goal than oneself");
  bits("desired", "another agent that comes closer to its goal by going ", "");
  bit("at_goal", "another agent that is on its goal");
  bits("came", "an agent, oneself included, whose last move was ", "");
  bits("swap", "an agent, oneself included, that wants past who is ",
       " and has to back out with it");
  bits("clear", "an agent, oneself included, who would have to swap with the one ",
       " of it after its move");
  bit("pressed", "an agent, oneself included, that another one of lower SVO pushes off its cell");
  entries.push_back({"cost_to_go", "cells that it is farther to one's goal from here / 8", -1, 1});
  entries.push_back({"svo_gap", "another agent's SVO less one's own / 45 degrees", -1, 1});
  entries.push_back({"inherited_gap",
                     "another agent's inherited SVO less one's own inherited one / 45 degrees; "
                     "where oneself is: one's inherited SVO less one's own",
                     -1, 1});
  entries.push_back({"goal_right", "unit direction to the goal, east", -1, 1});
  entries.push_back({"goal_up", "unit direction to the goal, north", -1, 1});
  entries.push_back({"straight_distance", "cells to the goal in a straight line / 64", 0, 1});
  entries.push_back({"way_to_go", "cells to the goal / 64", 0, 1});
  entries.push_back({"on_goal", "oneself is on the goal", 0, 1});
  entries.push_back({"priority", "timesteps since one was on the goal / 64", 0, 2.5});
  entries.push_back({"tie_break", "a number of one's own, drawn at the start", 0, 1});
  return entries;
}

}  // namespace

std::string ObservationEntry::toText() const {
  std::ostringstream text;
  text << name << " [" << lowest << ", " << highest << "]: " << meaning;
  return text.str();
}

const std::vector<ObservationEntry>& observationEntries() {
  static const std::vector<ObservationEntry> kEntries = allEntries();
  return kEntries;
}

ObservationEncoder::ObservationEncoder(const Grid& grid,
                                       const std::vector<DistanceField>& distances)
    : distances_(distances),
      map_(grid, kHalfView),
      right_of_way_(map_, distances),
      goal_owner_(static_cast<std::size_t>(map_.size()), -1) {
  for (std::size_t agent = 0; agent < distances.size(); ++agent) {
    goal_owner_[static_cast<std::size_t>(map_.indexOf(distances[agent].goal()))] =
        static_cast<AgentId>(agent);
  }
}

void ObservationEncoder::setStates(const AgentStates& states) {
  const std::size_t count = distances_.size();
  for (const std::size_t size :
       {states.cells.size(), states.last_moves.size(), states.svo_deg.size(),
        states.priorities.size(), states.tie_breaks.size()}) {
    if (size != count) {
      throw std::invalid_argument("states of " + std::to_string(size) + " agents: must be " +
                                  std::to_string(count));
    }
  }
  states_ = states;
  map_.place(states_.cells);
  right_of_way_.setStates(states_.cells, states_.svo_deg);
  seen_.assign(count, {});
  to_go_.assign(count, 0);
  for (std::size_t agent = 0; agent < count; ++agent) {
    see(static_cast<AgentId>(agent));
  }
}

void ObservationEncoder::see(AgentId agent) {
  const auto self = static_cast<std::size_t>(agent);
  to_go_[self] = distances_[self].at(states_.cells[self]);
  float* const seen = seen_[self].data();
  seen[at(Channel::Agent)] = 1.F;
  seen[at(Channel::AtGoal)] = to_go_[self] == 0 ? 1.F : 0.F;
  setDirections(Channel::DesiredNorth, right_of_way_.desired(agent), seen);
  for (std::size_t way = 0; way < kDirections; ++way) {
    seen[at(Channel::CameNorth) + way] = states_.last_moves[self] == kMoves[way] ? 1.F : 0.F;
  }
  setDirections(Channel::SwapNorth, right_of_way_.swaps(agent), seen);
  setDirections(Channel::ClearNorth, right_of_way_.clears(agent), seen);
  seen[at(Channel::Pressed)] =
      right_of_way_.inheritedSvoDeg(agent) < states_.svo_deg[self] ? 1.F : 0.F;
}

void ObservationEncoder::encode(AgentId agent, float* view, float* vector) const {
  std::fill(view, view + kObservationSize, 0.F);
  addOwnWay(agent, view);
  addAgents(agent, view);
  addGoals(agent, view);
  addVector(agent, vector);
}

// Obstacles, the directions that come closer to one's own goal, and the cost to go.
void ObservationEncoder::addOwnWay(AgentId agent, float* view) const {
  const DistanceField& distance = distances_[static_cast<std::size_t>(agent)];
  const Cell& center = states_.cells[static_cast<std::size_t>(agent)];
  const int to_go = to_go_[static_cast<std::size_t>(agent)];
  float* features = view;
  for (int row = center.row - kHalfView; row <= center.row + kHalfView; ++row) {
    for (int col = center.col - kHalfView; col <= center.col + kHalfView;
         ++col, features += kChannelCount) {
      const Cell cell{row, col};
      const int here = distance.at(cell);
      if (here == DistanceField::kUnreachable) {
        features[at(Channel::Obstacle)] = map_.isObstacle(map_.indexOf(cell)) ? 1.F : 0.F;
        features[at(Channel::CostToGo)] = 1.F;
        continue;
      }
      features[at(Channel::CostToGo)] =
          std::clamp(static_cast<float>(here - to_go) / kCostToGoRange, -1.F, 1.F);
      for (std::size_t way = 0; way < kDirections; ++way) {
        features[at(Channel::NearerNorth) + way] =
            distance.at(neighbor(cell, kMoves[way])) < here ? 1.F : 0.F;
      }
    }
  }
}

void ObservationEncoder::addAgents(AgentId agent, float* view) const {
  const Cell& center = states_.cells[static_cast<std::size_t>(agent)];
  for (int row = 0; row < kFieldOfView; ++row) {
    const int first = map_.indexOf({center.row - kHalfView + row, center.col - kHalfView});
    for (int col = 0; col < kFieldOfView; ++col) {
      const AgentId occupant = map_.occupant(first + col);
      float* const features = view + (row * kFieldOfView + col) * kChannelCount;
      if (occupant == agent) {
        addSelf(agent, features);
      } else if (occupant >= 0) {
        addOther(agent, occupant, features);
        const Cell& goal = distances_[static_cast<std::size_t>(occupant)].goal();
        // As PRIMAL does (Sartoretti et al. 2019): where to outside of the view others want to go.
        const int goal_row = std::clamp(goal.row - center.row, -kHalfView, kHalfView) + kHalfView;
        const int goal_col = std::clamp(goal.col - center.col, -kHalfView, kHalfView) + kHalfView;
        view[static_cast<std::size_t>((goal_row * kFieldOfView + goal_col) * kChannelCount) +
             at(Channel::ProjectedGoal)] = 1.F;
      }
    }
  }
}

// What one desires stands in one's own way already.
void ObservationEncoder::addSelf(AgentId agent, float* features) const {
  const auto self = static_cast<std::size_t>(agent);
  features[at(Channel::Agent)] = 1.F;
  for (std::size_t channel = at(Channel::CameNorth); channel <= at(Channel::Pressed); ++channel) {
    features[channel] = seen_[self][channel];
  }
  features[at(Channel::InheritedGap)] =
      (right_of_way_.inheritedSvoDeg(agent) - states_.svo_deg[self]) / kWidestSvo_deg;
}

void ObservationEncoder::addOther(AgentId agent, AgentId other, float* features) const {
  const auto self = static_cast<std::size_t>(agent);
  const auto seen = static_cast<std::size_t>(other);
  for (std::size_t channel = 0; channel < kChannelCount; ++channel) {
    features[channel] += seen_[seen][channel];
  }
  const float gap_deg = states_.svo_deg[seen] - states_.svo_deg[self];
  features[at(Channel::LessProsocial)] = gap_deg < 0.F ? 1.F : 0.F;
  features[at(Channel::FartherToGo)] = to_go_[seen] > to_go_[self] ? 1.F : 0.F;
  features[at(Channel::SvoGap)] = gap_deg / kWidestSvo_deg;
  features[at(Channel::InheritedGap)] =
      (right_of_way_.inheritedSvoDeg(other) - right_of_way_.inheritedSvoDeg(agent)) /
      kWidestSvo_deg;
}

void ObservationEncoder::addGoals(AgentId agent, float* view) const {
  const Cell& center = states_.cells[static_cast<std::size_t>(agent)];
  for (int row = 0; row < kFieldOfView; ++row) {
    const int first = map_.indexOf({center.row - kHalfView + row, center.col - kHalfView});
    for (int col = 0; col < kFieldOfView; ++col) {
      const AgentId owner = goal_owner_[static_cast<std::size_t>(first + col)];
      if (owner >= 0) {
        const Channel channel = owner == agent ? Channel::OwnGoal : Channel::OtherGoal;
        view[static_cast<std::size_t>((row * kFieldOfView + col) * kChannelCount) + at(channel)] =
            1.F;
      }
    }
  }
}

void ObservationEncoder::addVector(AgentId agent, float* vector) const {
  const auto self = static_cast<std::size_t>(agent);
  const Cell& cell = states_.cells[self];
  const Cell& goal = distances_[self].goal();
  const double right = goal.col - cell.col;
  const double up = cell.row - goal.row;
  const double straight = std::hypot(right, up);
  vector[at(VectorEntry::GoalRight)] = straight > 0.0 ? static_cast<float>(right / straight) : 0.F;
  vector[at(VectorEntry::GoalUp)] = straight > 0.0 ? static_cast<float>(up / straight) : 0.F;
  vector[at(VectorEntry::StraightDistance)] = saturated(straight);
  vector[at(VectorEntry::WayToGo)] = saturated(to_go_[self]);
  vector[at(VectorEntry::OnGoal)] = to_go_[self] == 0 ? 1.F : 0.F;
  vector[at(VectorEntry::Priority)] =
      std::min(static_cast<float>(states_.priorities[self]) / kPriorityScale, kMostPriority);
  vector[at(VectorEntry::TieBreak)] = states_.tie_breaks[self];
}

}  // namespace sylph
