#include "sylph_core/policy/observation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sylph {
namespace {

constexpr float kFarAway = 64.F;       // [cells] where distances saturate
constexpr float kCostToGoRange = 8.F;  // [cells] where the cost-to-go channel saturates
constexpr int kHalfView = kFieldOfView / 2;

constexpr std::size_t at(Channel channel) {
  return static_cast<std::size_t>(channel);
}

// The k-th of four channels, in the order of the moves North, East, South, West.
constexpr std::size_t at(Channel first, Action move) {
  return at(first) + static_cast<std::size_t>(move) - static_cast<std::size_t>(Action::North);
}

constexpr std::array<Action, 4> kMoves = {Action::North, Action::East, Action::South, Action::West};

float saturated(double distance_cells) {
  return std::min(static_cast<float>(distance_cells) / kFarAway, 1.F);
}

}  // namespace

const std::array<std::string, kChannelCount>& channelNames() {
  static const std::array<std::string, kChannelCount> names = {
      "obstacle",      "agent",        "own_goal",     "projected_goal", "less_prosocial",
      "nearer_north",  "nearer_east",  "nearer_south", "nearer_west",    "other_goal",
      "farther_to_go", "wishes_north", "wishes_east",  "wishes_south",   "wishes_west",
      "at_goal",       "came_north",   "came_east",    "came_south",     "came_west",
      "cost_to_go"};
  return names;
}

ObservationEncoder::ObservationEncoder(const Grid& grid,
                                       const std::vector<DistanceField>& distances)
    : stride_(grid.cols() + 2 * kMargin), distances_(distances) {
  const auto size = static_cast<std::size_t>(stride_ * (grid.rows() + 2 * kMargin));
  is_obstacle_.assign(size, 1);
  occupant_.assign(size, -1);
  goal_owner_.assign(size, -1);
  for (const Cell& cell : grid.freeCells()) {
    is_obstacle_[static_cast<std::size_t>(indexOf(cell))] = 0;
  }
  for (std::size_t agent = 0; agent < distances.size(); ++agent) {
    goal_owner_[static_cast<std::size_t>(indexOf(distances[agent].goal()))] =
        static_cast<AgentId>(agent);
  }
}

void ObservationEncoder::setStates(const AgentStates& states) {
  const std::size_t count = distances_.size();
  if (states.cells.size() != count || states.last_moves.size() != count ||
      states.svo_deg.size() != count) {
    throw std::invalid_argument("states of " + std::to_string(states.cells.size()) +
                                " agents: must be " + std::to_string(count));
  }
  for (const Cell& cell : states_.cells) {
    occupant_[static_cast<std::size_t>(indexOf(cell))] = -1;
  }
  states_ = states;
  seen_.assign(count, {});
  to_go_.assign(count, 0);
  for (std::size_t agent = 0; agent < count; ++agent) {
    const Cell& cell = states_.cells[agent];
    occupant_[static_cast<std::size_t>(indexOf(cell))] = static_cast<AgentId>(agent);
    const DistanceField& distance = distances_[agent];
    to_go_[agent] = distance.at(cell);
    std::array<float, kChannelCount>& seen = seen_[agent];
    seen[at(Channel::AtGoal)] = to_go_[agent] == 0 ? 1.F : 0.F;
    for (const Action move : kMoves) {
      seen[at(Channel::WishesNorth, move)] =
          distance.at(neighbor(cell, move)) < to_go_[agent] ? 1.F : 0.F;
    }
    if (states_.last_moves[agent] != Action::Stay) {
      seen[at(Channel::CameNorth, states_.last_moves[agent])] = 1.F;
    }
  }
}

void ObservationEncoder::encode(AgentId agent, float* view, float* vector) const {
  std::fill(view, view + kObservationSize, 0.F);
  addOwnWay(agent, view);
  addOthers(agent, view);
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
        features[at(Channel::Obstacle)] =
            is_obstacle_[static_cast<std::size_t>(indexOf(cell))] != 0 ? 1.F : 0.F;
        features[at(Channel::CostToGo)] = 1.F;
        continue;
      }
      features[at(Channel::CostToGo)] =
          std::clamp(static_cast<float>(here - to_go) / kCostToGoRange, -1.F, 1.F);
      for (const Action move : kMoves) {
        features[at(Channel::NearerNorth, move)] =
            distance.at(neighbor(cell, move)) < here ? 1.F : 0.F;
      }
    }
  }
}

void ObservationEncoder::addOthers(AgentId agent, float* view) const {
  const auto self = static_cast<std::size_t>(agent);
  const Cell& center = states_.cells[self];
  for (int row = 0; row < kFieldOfView; ++row) {
    const int first = indexOf({center.row - kHalfView + row, center.col - kHalfView});
    for (int col = 0; col < kFieldOfView; ++col) {
      const AgentId occupant = occupant_[static_cast<std::size_t>(first + col)];
      if (occupant < 0) {
        continue;
      }
      float* features = view + (row * kFieldOfView + col) * kChannelCount;
      const auto other = static_cast<std::size_t>(occupant);
      features[at(Channel::Agent)] = 1.F;
      if (occupant == agent) {
        continue;
      }
      for (std::size_t channel = 0; channel < kChannelCount; ++channel) {
        features[channel] += seen_[other][channel];
      }
      features[at(Channel::LessProsocial)] =
          states_.svo_deg[other] < states_.svo_deg[self] ? 1.F : 0.F;
      features[at(Channel::FartherToGo)] = to_go_[other] > to_go_[self] ? 1.F : 0.F;
      const Cell& goal = distances_[other].goal();
      const int goal_row = std::clamp(goal.row - center.row, -kHalfView, kHalfView) + kHalfView;
      const int goal_col = std::clamp(goal.col - center.col, -kHalfView, kHalfView) + kHalfView;
      view[static_cast<std::size_t>((goal_row * kFieldOfView + goal_col) * kChannelCount) +
           at(Channel::ProjectedGoal)] = 1.F;
    }
  }
}

void ObservationEncoder::addGoals(AgentId agent, float* view) const {
  const Cell& center = states_.cells[static_cast<std::size_t>(agent)];
  for (int row = 0; row < kFieldOfView; ++row) {
    const int first = indexOf({center.row - kHalfView + row, center.col - kHalfView});
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
  vector[0] = straight > 0.0 ? static_cast<float>(right / straight) : 0.F;
  vector[1] = straight > 0.0 ? static_cast<float>(up / straight) : 0.F;
  vector[2] = saturated(straight);
  vector[3] = saturated(to_go_[self]);
  vector[4] = to_go_[self] == 0 ? 1.F : 0.F;
}

}  // namespace sylph
