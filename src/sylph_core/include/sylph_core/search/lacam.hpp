#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/graph.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// LaCAM*: depth-first search over configurations with lazily enumerated successors.
///
/// Okumura 2023, "LaCAM: Search-Based Algorithm for Quick Multi-Agent Pathfinding", Alg. 1, and
/// "Improving LaCAM for Scalable Eventually Optimal Multi-Agent Pathfinding", Alg. 1, which adds
/// the costs and the rewiring. Their high-level node N is Node, with N.config, N.tree, N.order and
/// N.neigh as `configuration`, `constraint_tree`, steps->order() and `neighbors`; Open is a stack,
/// Explored a hash map; a low-level node C is Constraint; get_new_config(N, C) is
/// JointSteps::generate(); g and h are `cost` and `cost_to_go`.
///
/// Each configuration carries a tree of constraints, each binding one more agent, in the order of
/// the generator, to one of its moves. Before a constraint is handed to the generator its children
/// are appended, so that in the end every legal step is at a leaf, where all agents are bound and
/// the generator can only say whether the step is legal. Children are left out only if the agents
/// bound so far already collide, swap or (where the motion model forbids it) rotate, which no
/// further binding mends. Thus the search sees every configuration that can be reached under the
/// motion model: it finds a solution if there is one and is exhausted if there is none.
///
/// After the first solution the search goes on among the configurations that can still lead to a
/// better one, and shortens the ways to known ones ("rewiring"). The cost it minimises is the sum
/// over agents and timesteps of not resting on the goal, which is the sum of costs up to rests on
/// the goal before an agent leaves it again.
class Lacam {
 public:
  /// What a call of search() came to, see there.
  enum class Status { Solved, Exhausted, Unfinished };

  /// All arguments by reference must outlive this object.
  Lacam(const SearchProblem& problem, ConfigurationGenerator& generator, Rng& rng)
      : Lacam(problem, problem.starts, generator, rng) {}
  /// From another configuration than the problem's starts.
  Lacam(const SearchProblem& problem, const Vertices& from, ConfigurationGenerator& generator,
        Rng& rng);

  /// Searches until a solution is found that is better than the one known before.
  /// @param max_steps  most calls of the generator
  /// @return Exhausted: there is none, so that the one known before, if any, is optimal;
  /// Unfinished: the time or the steps were not enough, another call goes on from here
  Status search(const Deadline& deadline, long max_steps);

  /// Makes a solution known to the search, which then only looks for better ones; only its begin
  /// where the time is over before.
  void insert(const std::vector<Vertices>& plan, const Deadline& deadline);

  /// Whether a solution is known, found or inserted.
  bool isSolved() const { return goal_ != nullptr; }
  /// Cost of the solution, at most its sum of costs.
  long cost() const { return goal_->cost; }
  /// The solution; before there is one, the way to the configuration nearest to the goals.
  std::vector<Vertices> plan() const;
  /// Configurations generated.
  long nodeCount() const { return static_cast<long>(nodes_.size()); }

 private:
  struct Constraint {
    std::int32_t parent;  // in the tree of constraints
    std::int32_t depth;   // number of agents bound
    VertexId target;      // of agent order()[depth - 1]
  };
  struct Node {
    Vertices configuration;
    Priorities priorities;
    std::unique_ptr<JointSteps> steps;
    std::vector<Constraint> constraint_tree;  // a queue from next_constraint on
    std::size_t next_constraint = 0;
    std::vector<Node*> neighbors;
    Node* parent = nullptr;
    long cost = 0;        // to come
    long cost_to_go = 0;  // lower bound
  };

  Node* findNode(const Vertices& configuration, std::uint64_t hash) const;
  Node* addNode(const Vertices& configuration, std::uint64_t hash, Node* parent);
  void expandOnce(Node& node);
  void bind(const Node& node, std::size_t constraint);
  void appendChildren(Node& node, std::size_t constraint);
  bool isConsistent(const Node& node, int depth, VertexId target) const;
  void connect(Node& from, Node& to);
  bool isWorthwhile(const Node& node) const;
  long stepCost(const Vertices& from, const Vertices& to) const;

  const SearchProblem* problem_;
  ConfigurationGenerator* generator_;
  Rng* rng_;

  std::deque<Node> nodes_;
  std::unordered_multimap<std::uint64_t, Node*> explored_;
  std::vector<Node*> open_;  // a stack
  Node* start_ = nullptr;
  Node* goal_ = nullptr;
  Node* nearest_ = nullptr;
  Vertices to_;  // scratch: the step being generated
};

}  // namespace sylph
