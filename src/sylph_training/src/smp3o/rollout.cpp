#include "sylph_training/smp3o/rollout.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace sylph_training {
namespace {

using Column = torch::Tensor Rollout::*;

constexpr std::array<Column, 19> kColumns = {
    &Rollout::cells,
    &Rollout::views,
    &Rollout::vectors,
    &Rollout::svo,
    &Rollout::svo_now,
    &Rollout::memory,
    &Rollout::partners,
    &Rollout::overlaps,
    &Rollout::actions,
    &Rollout::action_log_probs,
    &Rollout::svo_levels,
    &Rollout::svo_log_probs,
    &Rollout::has_svo_choice,
    &Rollout::values,
    &Rollout::valid,
    &Rollout::blocks,
    &Rollout::external_rewards,
    &Rollout::social_rewards,
    &Rollout::action_rewards,
};

torch::Tensor toTensor(const std::vector<std::int64_t>& values) {
  return torch::tensor(values, torch::kLong);
}

torch::Tensor toTensor(const std::vector<float>& values) {
  return torch::tensor(values, torch::kFloat);
}

torch::Tensor logProbsOf(const torch::Tensor& logits, const torch::Tensor& chosen) {
  return torch::log_softmax(logits, 1).gather(1, chosen.unsqueeze(1)).squeeze(1);
}

Rollout joined(const std::vector<Rollout>& parts) {
  Rollout whole;
  for (const Column column : kColumns) {
    std::vector<torch::Tensor> tensors;
    tensors.reserve(parts.size());
    for (const Rollout& part : parts) {
      tensors.push_back(part.*column);
    }
    whole.*column = torch::cat(tensors);
  }
  return whole;
}

}  // namespace

/// The pieces of all worlds while they grow.
class RolloutCollector::Pieces {
 public:
  explicit Pieces(int worlds) : open_(static_cast<std::size_t>(worlds)) {}

  void addStep(std::int64_t base_row, const std::vector<std::int64_t>& first_rows) {
    for (std::size_t world = 0; world < open_.size(); ++world) {
      open_[world].agents = first_rows[world + 1] - first_rows[world];
      open_[world].first_rows.push_back(base_row + first_rows[world]);
    }
  }
  /// @param end_values  per agent of the world
  void close(std::size_t world, std::vector<float> end_values) {
    open_[world].end_values = std::move(end_values);
    closed_.push_back(std::exchange(open_[world], {}));
  }
  std::vector<EpisodePiece> take() { return std::move(closed_); }

 private:
  std::vector<EpisodePiece> open_;
  std::vector<EpisodePiece> closed_;
};

struct RolloutCollector::Decision {
  PolicyInput input;    // on the host
  PolicyOutput output;  // on the host
};

RolloutCollector::RolloutCollector(EnvironmentBatch batch, bool memory_fed_back,
                                   torch::Device device)
    : batch_(std::move(batch)), memory_fed_back_(memory_fed_back), device_(device) {}

RolloutCollector::Decision RolloutCollector::decide(PolicyModel& model) {
  Decision decision;
  if (!memory_.defined()) {
    memory_ = torch::zeros({batch_.rowCount(), model->memoryWidth()});
  }
  decision.input = batch_.observe();
  decision.input.memory = memory_;
  decision.output = model->forward(decision.input.to(device_));
  PolicyOutput& output = decision.output;
  for (torch::Tensor* tensor :
       {&output.actions, &output.svo, &output.values, &output.blocking, &output.memory}) {
    // The worlds are on the processor: one copy a step and not one a number.
    *tensor = tensor->to(torch::kCPU);
  }
  return decision;
}

std::vector<sylph::Action> RolloutCollector::drawActions(const torch::Tensor& probabilities) {
  const torch::Tensor rows = probabilities.to(torch::kFloat).contiguous();
  const auto* row = rows.data_ptr<float>();
  std::vector<sylph::Action> actions;
  for (int world = 0; world < batch_.worldCount(); ++world) {
    const int agents = batch_.world(world).instance().agentCount();
    for (int agent = 0; agent < agents; ++agent, row += sylph::kActionCount) {
      const int drawn = drawFrom(row, sylph::kActionCount, batch_.rngOfWorld(world));
      actions.push_back(sylph::kActions[static_cast<std::size_t>(drawn)]);
    }
  }
  return actions;
}

Rollout RolloutCollector::collect(PolicyModel& model, int steps) {
  if (steps < 1) {
    throw std::invalid_argument("steps = " + std::to_string(steps) + ": must be > 0");
  }
  const torch::NoGradGuard no_grad;
  std::vector<Rollout> parts;
  Pieces pieces(batch_.worldCount());
  std::int64_t base_row = 0;
  for (int step = 0; step < steps; ++step) {
    const std::vector<std::int64_t> first_rows = batch_.firstRows();
    const Decision decision = decide(model);
    const auto actions = drawActions(torch::softmax(decision.output.actions, 1));
    Rollout part;
    recordState(decision, actions, part);
    const BatchStep outcome = batch_.step(actions, torch::softmax(decision.output.svo, 1));
    recordStep(outcome, actions, part);
    part.svo_log_probs = logProbsOf(decision.output.svo, part.svo_levels);
    parts.push_back(std::move(part));
    pieces.addStep(base_row, first_rows);
    base_row += first_rows.back();
    if (memory_fed_back_) {
      memory_ = decision.output.memory;
    }
    closePieces(model, outcome, step + 1 == steps, pieces);
    carryMemory(batch_.resetFinished());
  }
  Rollout rollout = joined(parts);
  rollout.pieces = pieces.take();
  rollout.episodes = batch_.takeRecords();
  return rollout;
}

void RolloutCollector::closePieces(PolicyModel& model, const BatchStep& outcome, bool is_last,
                                   Pieces& pieces) {
  const auto worlds = static_cast<std::size_t>(batch_.worldCount());
  torch::Tensor values;  // of the states reached; asked for where an episode is cut short
  for (std::size_t world = 0; world < worlds; ++world) {
    const bool is_solved = outcome.is_solved[world] != 0;
    if (!is_last && outcome.is_finished[world] == 0) {
      continue;
    }
    const std::int64_t first = batch_.firstRows()[world];
    const std::int64_t end = batch_.firstRows()[world + 1];
    std::vector<float> end_values(static_cast<std::size_t>(end - first), 0.F);
    if (!is_solved) {
      if (!values.defined()) {
        // An episode that is cut short would have gone on: the critic says for how much. Solved
        // ones end with nothing to come.
        values = decide(model).output.values.contiguous();
      }
      std::copy(values.data_ptr<float>() + first, values.data_ptr<float>() + end,
                end_values.begin());
    }
    pieces.close(world, std::move(end_values));
  }
}

void RolloutCollector::recordState(const Decision& decision,
                                   const std::vector<sylph::Action>& actions, Rollout& part) const {
  std::vector<std::int64_t> partners;
  std::vector<std::int64_t> cells;
  std::vector<float> overlaps;
  std::vector<float> valid;
  std::vector<float> blocks;
  for (int index = 0; index < batch_.worldCount(); ++index) {
    const Environment& world = batch_.world(index);
    for (sylph::AgentId agent = 0; agent < world.instance().agentCount(); ++agent) {
      const auto row = static_cast<std::size_t>(agent);
      const sylph::Cell& cell = world.cells()[row];
      cells.insert(cells.end(), {cell.row, cell.col});
      partners.push_back(world.partners()[row]);
      overlaps.push_back(static_cast<float>(world.partnerOverlap(agent)));
      blocks.push_back(world.blockedCounts()[row] > 0 ? 1.F : 0.F);
      for (const sylph::Action action : sylph::kActions) {
        valid.push_back(world.isValid(agent, action) ? 1.F : 0.F);
      }
    }
  }
  std::vector<std::int64_t> chosen;
  chosen.reserve(actions.size());
  for (const sylph::Action action : actions) {
    chosen.push_back(static_cast<std::int64_t>(action));
  }
  // In half the memory: a rollout holds millions of views.
  part.views = decision.input.views.permute({0, 2, 3, 1}).to(torch::kBFloat16);
  part.vectors = decision.input.vectors;
  part.svo = decision.input.svo;
  part.memory = decision.input.memory;
  part.cells = toTensor(cells).view({-1, 2});
  part.partners = toTensor(partners);
  part.overlaps = toTensor(overlaps);
  part.actions = toTensor(chosen);
  part.action_log_probs = logProbsOf(decision.output.actions, part.actions);
  part.values = decision.output.values;
  part.valid = toTensor(valid).view({-1, sylph::kActionCount});
  part.blocks = toTensor(blocks);
}

// What collided counts as invalid too, as in the authors' code.
void RolloutCollector::recordStep(const BatchStep& step, const std::vector<sylph::Action>& actions,
                                  Rollout& part) {
  auto valid = part.valid.accessor<float, 2>();
  for (std::size_t row = 0; row < actions.size(); ++row) {
    if (step.is_penalized[row]) {
      valid[static_cast<std::int64_t>(row)][static_cast<std::int64_t>(actions[row])] = 0.F;
    }
  }
  part.svo_now = toTensor(step.svo).view({-1, sylph::kSvoLevelCount});
  part.svo_levels = toTensor(step.svo_levels);
  part.has_svo_choice = toTensor(step.has_svo_choice);
  part.external_rewards = toTensor(step.external_rewards);
  part.social_rewards = toTensor(step.social_rewards);
  part.action_rewards = toTensor(step.action_rewards);
}

void RolloutCollector::carryMemory(const std::vector<std::int64_t>& carried_rows) {
  const torch::Tensor with_blank = torch::cat({memory_, torch::zeros({1, memory_.size(1)})});
  std::vector<std::int64_t> rows = carried_rows;
  std::replace(rows.begin(), rows.end(), std::int64_t{-1}, memory_.size(0));
  memory_ = with_blank.index_select(0, toTensor(rows));
}

}  // namespace sylph_training
