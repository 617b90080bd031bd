#include "sylph_core/execution/event_line.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <variant>

#include "text/json_integer.hpp"
#include "text/one_line.hpp"

namespace sylph {
namespace {

using nlohmann::json;

json toJson(const Configuration& cells) {
  json list = json::array();
  for (const Cell& cell : cells) {
    list.push_back({cell.row, cell.col});
  }
  return list;
}

Configuration cellsFromJson(const json& list) {
  Configuration cells;
  for (const json& cell : list) {
    cells.push_back({integerOf<int>(cell.at(0)), integerOf<int>(cell.at(1))});
  }
  return cells;
}

json toJson(const MissionPlan& plan) {
  json configurations = json::array();
  for (const Configuration& cells : plan.plan) {
    configurations.push_back(toJson(cells));
  }
  json partners = json::array();
  json svo_deg = json::array();
  for (const SocialState& social : plan.social) {
    partners.push_back(social.partners);
    svo_deg.push_back(social.svo_deg);  // not a number becomes null
  }
  return {{"replaces_plan_id", plan.replaces_plan_id},
          {"planner", plan.planner},
          {"planning_s", plan.planning_s},
          {"robots", plan.robots},
          {"goals", toJson(plan.goals)},
          {"configurations", std::move(configurations)},
          {"partners", std::move(partners)},
          {"svo_deg", std::move(svo_deg)}};
}

MissionPlan planFromJson(const json& object, std::uint32_t plan_id) {
  MissionPlan plan;
  plan.plan_id = plan_id;
  plan.replaces_plan_id = integerOf<std::uint32_t>(object.at("replaces_plan_id"));
  plan.planner = object.at("planner").get<std::string>();
  plan.planning_s = object.at("planning_s").get<double>();
  plan.robots = object.at("robots").get<std::vector<std::string>>();
  plan.goals = cellsFromJson(object.at("goals"));
  for (const json& cells : object.at("configurations")) {
    plan.plan.push_back(cellsFromJson(cells));
  }
  const json& partners = object.at("partners");
  const json& svo_deg = object.at("svo_deg");
  for (std::size_t step = 0; step < partners.size(); ++step) {
    SocialState social;
    social.partners = integersOf<AgentId>(partners.at(step));
    for (const json& value : svo_deg.at(step)) {
      social.svo_deg.push_back(value.is_null() ? std::numeric_limits<float>::quiet_NaN()
                                               : value.get<float>());
    }
    plan.social.push_back(std::move(social));
  }
  return plan;
}

/// Adds what an event tells to its object.
struct ToJson {
  json& object;
  const std::vector<std::string>& names;

  void addRobot(const char* event, int robot) const {
    object["event"] = event;
    object["robot"] = names.at(static_cast<std::size_t>(robot));
  }
  void operator()(const event::Started& started) const {
    object["event"] = "plan";
    object["plan"] = toJson(*started.plan);
  }
  void operator()(const event::Refused& refused) const {
    object["event"] = "refused";
    object["reason"] = refused.reason;
  }
  void operator()(const event::Abandoned& /*abandoned*/) const { object["event"] = "abandoned"; }
  void operator()(const event::Released& released) const {
    addRobot("released", released.robot);
    object["sequence"] = released.sequence;
  }
  void operator()(const event::Accepted& accepted) const {
    addRobot("accepted", accepted.robot);
    object["count"] = accepted.count;
  }
  void operator()(const event::Done& done) const {
    addRobot("done", done.robot);
    object["sequence"] = done.sequence;
  }
  void operator()(const event::Condition& event) const {
    addRobot("condition", event.robot);
    object["condition"] = toString(event.condition);
    object["reason"] = event.reason;
  }
  void operator()(const event::Lost& lost) const {
    addRobot("lost", lost.robot);
    object["reason"] = lost.reason;
  }
  void operator()(const event::Mode& mode) const {
    object["event"] = "mode";
    object["mode"] = toString(mode.mode);
    object["reason"] = mode.reason;
  }
  void operator()(const event::Phase& phase) const {
    object["event"] = "phase";
    object["phase"] = toString(phase.phase);
  }
};

int robotOf(const json& object, const std::vector<std::string>& names) {
  const auto robot = object.at("robot").get<std::string>();
  const auto found = std::find(names.begin(), names.end(), robot);
  if (found == names.end()) {
    throw std::runtime_error("robot '" + inOneLine(robot) + "' is not in the experiment");
  }
  return static_cast<int>(found - names.begin());
}

/// The enumerator that toString() calls so.
template <typename Enumerator>
Enumerator wordOf(const json& object, const char* key) {
  const auto word = object.at(key).get<std::string>();
  for (std::uint8_t value = 0; toString(static_cast<Enumerator>(value)) != "unknown"; ++value) {
    if (toString(static_cast<Enumerator>(value)) == word) {
      return static_cast<Enumerator>(value);
    }
  }
  throw std::runtime_error("unknown " + std::string(key) + " '" + inOneLine(word) + "'");
}

using What = ExecutionEvent::What;

What whatFromJson(const json& object, std::uint32_t plan_id,
                  const std::vector<std::string>& names) {
  const auto name = object.at("event").get<std::string>();
  const auto reason = [&] { return object.at("reason").get<std::string>(); };
  if (name == "plan") {
    return event::Started{
        std::make_shared<const MissionPlan>(planFromJson(object.at("plan"), plan_id))};
  }
  if (name == "refused") {
    return event::Refused{reason()};
  }
  if (name == "abandoned") {
    return event::Abandoned{};
  }
  if (name == "released") {
    return event::Released{robotOf(object, names), integerOf<int>(object.at("sequence"))};
  }
  if (name == "accepted") {
    return event::Accepted{robotOf(object, names), integerOf<int>(object.at("count"))};
  }
  if (name == "done") {
    return event::Done{robotOf(object, names), integerOf<int>(object.at("sequence"))};
  }
  if (name == "condition") {
    return event::Condition{robotOf(object, names), wordOf<RobotCondition>(object, "condition"),
                            reason()};
  }
  if (name == "lost") {
    return event::Lost{robotOf(object, names), reason()};
  }
  if (name == "mode") {
    return event::Mode{wordOf<ExecutionMode>(object, "mode"), reason()};
  }
  if (name == "phase") {
    return event::Phase{wordOf<ExecutionPhase>(object, "phase")};
  }
  throw std::runtime_error("unknown event '" + inOneLine(name) + "'");
}

}  // namespace

std::string toLine(const StampedEvent& entry, const std::vector<std::string>& names) {
  json object = {{"stamp", entry.stamp_s}, {"plan_id", entry.event.plan_id}};
  std::visit(ToJson{object, names}, entry.event.what);
  return object.dump();
}

StampedEvent eventFromLine(const std::string& line, const std::vector<std::string>& names) {
  try {
    const json object = json::parse(line);
    if (object.contains("number")) {
      throw std::runtime_error(
          "written by an earlier version of the suite, whose events had a 'number': "
          "start with a new run folder");
    }
    const auto plan_id = integerOf<std::uint32_t>(object.at("plan_id"));
    return {object.at("stamp").get<double>(), {plan_id, whatFromJson(object, plan_id, names)}};
  } catch (const json::exception& error) {
    throw std::runtime_error(error.what());
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace sylph
