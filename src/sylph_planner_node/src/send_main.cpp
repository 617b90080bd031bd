#include <ros/ros.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "sylph_core/command/run_command.hpp"
#include "sylph_core/mission/mission.hpp"
#include "sylph_planner_node/send_command.hpp"
#include "sylph_planner_node/send_request.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/run_node.hpp"
#include "sylph_ros/topics.hpp"

namespace {

/// Goals have the form of remappings, which ros::init() would take for itself: remappings of this
/// command are those of ROS's own names, which begin with an underscore.
bool isForRos(const std::string& argument) {
  return argument.front() == '_' && argument.find(":=") != std::string::npos;
}

/// As a node of the suite, in the fleet of `__ns` or ROS_NAMESPACE.
void init(std::vector<std::string> for_ros) {
  std::string fleet;
  const std::string key = "__ns:=";
  for (const std::string& argument : for_ros) {
    fleet = argument.compare(0, key.size(), key) == 0 ? argument.substr(key.size()) : fleet;
  }
  if (const char* environment = std::getenv("ROS_NAMESPACE"); environment && fleet.empty()) {
    fleet = environment;
  }
  for_ros.push_back(key + fleet + "/" + sylph_ros::kSuiteNamespace);
  std::vector<char*> arguments = {const_cast<char*>("sylph_send")};
  for (std::string& argument : for_ros) {
    arguments.push_back(argument.data());
  }
  // Several may run at once; the same name twice would end the one before.
  sylph_ros::initNode(static_cast<int>(arguments.size()), arguments.data(),
                      "sylph_send_" + std::to_string(getpid()));
  if (!ros::master::check()) {
    throw std::runtime_error("no ROS master at " + ros::master::getURI() +
                             ": is a lab running, and is ROS_MASTER_URI right?");
  }
}

/// @throws std::exception if the goals are of no use
int send(const std::vector<std::string>& for_ros, const std::vector<std::string>& goals,
         sylph_planner_node::SendRequest request) {
  try {
    init(for_ros);
    const ros::NodeHandle nh;
    const sylph::Experiment lab = sylph_ros::loadExperiment(nh);
    request.goals = sylph_planner_node::readGoals(goals, lab);
    ros::AsyncSpinner spinner(1);
    spinner.start();
    return sylph_planner_node::SendCommand(nh, lab, request).run();
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::exception& error) {
    const auto* failure = dynamic_cast<const sylph::MissionFailure*>(&error);
    if (failure != nullptr && failure->outcome() == sylph::MissionOutcome::BadRequest) {
      throw;
    }
    std::cerr << "sylph_send: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> for_ros;
  std::vector<const char*> own;
  for (int i = 0; i < argc; ++i) {
    if (i > 0 && isForRos(argv[i])) {
      for_ros.emplace_back(argv[i]);
    } else {
      own.push_back(argv[i]);
    }
  }
  CLI::App app(
      "Sends robots of a running lab to cells, and ends as their mission does: exit status "
      "0 all have arrived (--plan-only: there is a plan), 1 not, 2 the goals are of no use. The "
      "fleet is that of "
      "ROS_NAMESPACE or __ns:=.");
  app.name("sylph_send");
  sylph_planner_node::SendRequest request;
  std::vector<std::string> goals;
  app.add_option("goals", goals, "ROBOT:=ROW,COL of each robot that is to move; row 0 is the top")
      ->required();
  app.add_flag("--others-give-way", request.others_give_way,
               "robots without a goal may step aside and come back; otherwise they stay");
  app.add_flag("--replace", request.replaces, "end the mission that is under way");
  app.add_flag("--plan-only", request.plan_only, "show the plan and its cost, move nothing");
  app.add_option("--save", request.save_path,
                 "write the mission as an experiment file, with the robots where they are");
  app.add_option("--planner", request.planner, "name; the lab's unless given");
  app.add_option("--time-limit", request.time_limit_s, "for planning [s]")
      ->check(sylph::isPositiveSeconds);
  app.add_option("--seed", request.seed, "of the planner");
  app.add_option("--wait", request.wait_s, "for planner and poses to appear [s]")
      ->check(sylph::isPositiveSeconds)
      ->capture_default_str();
  return sylph::runCommand(app, static_cast<int>(own.size()), own.data(),
                           [&] { return send(for_ros, goals, request); });
}
