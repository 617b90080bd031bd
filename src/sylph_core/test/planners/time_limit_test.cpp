#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/planners/lacam_planner.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_core/planners/policy_guide.hpp"
#include "sylph_core/search/distance_generator.hpp"
#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/path_search.hpp"
#include "test/support/random_weights.hpp"

namespace sylph {
namespace {

/// A clock that moves on by a second with each question, so that limits count in questions.
class QuestionClock {
 public:
  Clock clock() {
    return [this] { return static_cast<double>(questions_++); };
  }
  long questions() const { return questions_; }

 private:
  long questions_ = 0;
};

// What is over is asked about by everybody on the way out, and by nobody for long.
TEST(TimeLimitProperty, NoPlannerGoesOnAfterTheLimit) {
  constexpr double kWayOut = 40.0;  // and 3 % for social states
  Rng rng(1);
  const Instance instance = randomInstance(randomMap({12, 12, 0.15}, rng), 30, {}, rng);
  for (const std::string& name : plannerNames()) {
    const auto planner = makePlanner(name, randomPolicy());
    for (const double limit : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 10000.0, 100000.0}) {
      SCOPED_TRACE(name + " with " + std::to_string(limit) + " questions");
      QuestionClock time;
      PlanningLimits limits;
      limits.time_limit_s = limit;
      limits.clock = time.clock();
      const PlanningResult result = planner->plan(instance, limits, rng);
      EXPECT_LE(static_cast<double>(time.questions()), 1.03 * limit + kWayOut);
      const auto violation = checkPlan(instance, result.plan);
      EXPECT_EQ(result.outcome != Outcome::Solved, violation.has_value());
      EXPECT_TRUE(!violation || violation->kind == ViolationKind::GoalNotReached)
          << violation->message;
      EXPECT_LE(result.social.size(), result.plan.size() - 1);
    }
  }
}

/// By distance, a second a configuration.
class SlowGuide : public Guide {
 public:
  SlowGuide(const SearchProblem& problem, Rng& rng, double& now_s)
      : problem_(&problem), rng_(&rng), now_s_(&now_s) {}

  std::unique_ptr<ConfigurationGenerator> makeGenerator() override {
    class Generator : public ConfigurationGenerator {
     public:
      explicit Generator(SlowGuide& guide)
          : guide_(&guide), by_distance_(makeDistanceGenerator(*guide.problem_, 0, *guide.rng_)) {}
      std::unique_ptr<JointSteps> enter(const Vertices& configuration, const Vertices* before,
                                        const Priorities& priorities) override {
        *guide_->now_s_ += 1.0;
        ++guide_->calls_;
        return by_distance_->enter(configuration, before, priorities);
      }

     private:
      SlowGuide* guide_;
      std::unique_ptr<ConfigurationGenerator> by_distance_;
    };
    return std::make_unique<Generator>(*this);
  }
  bool isPolicyGuided() const override { return true; }
  std::vector<SocialState> socialStates(const std::vector<Vertices>& /*plan*/,
                                        const Deadline& /*deadline*/) override {
    return {};
  }
  long policyCalls() const override { return calls_; }

 private:
  const SearchProblem* problem_;
  Rng* rng_;
  double* now_s_;
  long calls_ = 0;
};

TEST(TimeLimitTest, APolicyTooSlowForItsShareIsGivenUpAtOnce) {
  double now_s = 0.0;
  const LacamPlanner planner("slow",
                             [&now_s](const SearchProblem& problem, const Instance&, int,
                                      Rng& rng) -> std::unique_ptr<Guide> {
                               return std::make_unique<SlowGuide>(problem, rng, now_s);
                             });
  const Instance instance{Grid(20, 20), {{0, 0}}, {{19, 19}}, {}};
  PlanningLimits limits;
  limits.clock = [&now_s] { return now_s; };
  limits.first_solution_only = true;
  Rng rng(1);
  for (const auto& [limit_s, is_enough] : {std::pair{600.0, false}, {6000.0, true}}) {
    limits.time_limit_s = limit_s;
    const PlanningResult result = planner.plan(instance, limits, rng);
    EXPECT_EQ(Outcome::Solved, result.outcome);
    if (is_enough) {
      EXPECT_GE(result.statistics.policy_calls, 38);
    } else {
      EXPECT_LE(result.statistics.policy_calls, 5);
    }
  }
}

TEST(TimeLimitTest, DistancesAreBrokenOff) {
  const Instance instance{Grid(200, 200), {{0, 0}, {0, 1}}, {{199, 199}, {199, 198}}, {}};
  QuestionClock time;
  PlanningLimits limits;
  limits.time_limit_s = 100.0;
  limits.clock = time.clock();
  Rng rng(1);
  const PlanningResult result = makePlanner("lacam")->plan(instance, limits, rng);
  EXPECT_EQ(Outcome::TimeLimit, result.outcome);
  EXPECT_EQ(Plan{instance.starts}, result.plan);
  EXPECT_FALSE(result.statistics.sum_of_costs_lower_bound.has_value());
  EXPECT_LT(time.questions(), 110);
}

TEST(TimeLimitTest, OnePathOnALargeMapIsBrokenOff) {
  const Instance instance{Grid(200, 200), {{0, 0}}, {{199, 199}}, {}};
  const SearchProblem problem(instance);
  ReservationTable table(problem.graph, instance.motion, 1, 500);
  PathSearch search(problem.graph);
  Rng rng(1);
  QuestionClock patient;
  EXPECT_EQ(399U, search
                      .find(table, problem.starts[0], problem.goals[0], 500,
                            Deadline(1e9, patient.clock()), rng)
                      .size());
  // 400 layers of 629 words.
  EXPECT_GE(patient.questions(), 400 * 629 / 40000);
  QuestionClock hasty;
  EXPECT_TRUE(
      search
          .find(table, problem.starts[0], problem.goals[0], 500, Deadline(2.0, hasty.clock()), rng)
          .empty());
  EXPECT_LE(hasty.questions(), 4);
}

TEST(TimeLimitTest, ManyAgentsAskAtEachStep) {
  Rng rng(1);
  const Instance instance = randomInstance(Grid(40, 40), 600, {}, rng);
  const SearchProblem problem(instance);
  const auto generator = makeDistanceGenerator(problem, 0, rng);
  Lacam lacam(problem, *generator, rng);
  QuestionClock time;
  EXPECT_EQ(Lacam::Status::Unfinished, lacam.search(Deadline(5.0, time.clock()), 1000));
  EXPECT_LE(lacam.nodeCount(), 7);
}

TEST(TimeLimitTest, SocialStatesAreBrokenOff) {
  const Instance instance{Grid(1, 21), {{0, 0}}, {{0, 20}}, {}};
  const SearchProblem problem(instance);
  std::vector<Vertices> plan;
  for (int col = 0; col <= 20; ++col) {
    plan.push_back({problem.graph.vertexAt({0, col})});
  }
  for (const GuideFactory& makeGuide :
       {GuideFactory(makeDistanceGuide),
        makePolicyGuideFactory(randomPolicy(), PolicyUse::Search,
                               defaultSettings(PolicyUse::Search, false))}) {
    // The first question tells when the time begins.
    for (const std::size_t limit : {1, 5, 20, 100}) {
      Rng rng(1);
      const auto guide = makeGuide(problem, instance, 1, rng);
      QuestionClock time;
      const Deadline deadline(static_cast<double>(limit), time.clock());
      EXPECT_EQ(std::min<std::size_t>(limit - 1, 20), guide->socialStates(plan, deadline).size());
    }
  }
}

}  // namespace
}  // namespace sylph
