#include "sylph_adg_central/event_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace sylph_adg_central {
namespace {

using Kind = sylph::ExecutionEvent::Kind;
using nlohmann::json;

constexpr std::array<std::pair<Kind, const char*>, 10> kKinds = {{
    {Kind::Started, "plan"},
    {Kind::Refused, "refused"},
    {Kind::Abandoned, "abandoned"},
    {Kind::Released, "released"},
    {Kind::Accepted, "accepted"},
    {Kind::Done, "done"},
    {Kind::Condition, "condition"},
    {Kind::Lost, "lost"},
    {Kind::Mode, "mode"},
    {Kind::Phase, "phase"},
}};

json toJson(const sylph::Configuration& cells) {
  json list = json::array();
  for (const sylph::Cell& cell : cells) {
    list.push_back({cell.row, cell.col});
  }
  return list;
}

sylph::Configuration cellsFromJson(const json& list) {
  sylph::Configuration cells;
  for (const json& cell : list) {
    cells.push_back({cell.at(0).get<int>(), cell.at(1).get<int>()});
  }
  return cells;
}

json toJson(const sylph::MissionPlan& plan) {
  json configurations = json::array();
  for (const sylph::Configuration& cells : plan.plan) {
    configurations.push_back(toJson(cells));
  }
  json partners = json::array();
  json svo_deg = json::array();
  for (const sylph::SocialState& social : plan.social) {
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

sylph::MissionPlan planFromJson(const json& object, std::uint32_t plan_id) {
  sylph::MissionPlan plan;
  plan.plan_id = plan_id;
  plan.replaces_plan_id = object.at("replaces_plan_id").get<std::uint32_t>();
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
    sylph::SocialState social;
    social.partners = partners.at(step).get<std::vector<sylph::AgentId>>();
    for (const json& value : svo_deg.at(step)) {
      social.svo_deg.push_back(value.is_null() ? std::numeric_limits<float>::quiet_NaN()
                                               : value.get<float>());
    }
    plan.social.push_back(std::move(social));
  }
  return plan;
}

}  // namespace

json toJson(const sylph::ExecutionEvent& event, double stamp_s,
            const std::vector<std::string>& names) {
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [&](const auto& entry) { return entry.first == event.kind; });
  json object = {{"stamp", stamp_s}, {"event", kind->second}, {"plan_id", event.plan_id}};
  if (event.robot >= 0) {
    object["robot"] = names.at(static_cast<std::size_t>(event.robot));
  }
  if (event.kind != Kind::Started && event.kind != Kind::Refused && event.kind != Kind::Abandoned &&
      event.kind != Kind::Lost) {
    object["number"] = event.number;
  }
  if (!event.text.empty()) {
    object["text"] = event.text;
  }
  if (event.plan) {
    object["plan"] = toJson(*event.plan);
  }
  return object;
}

sylph::ExecutionEvent eventFromJson(const json& object, const std::vector<std::string>& names) {
  try {
    sylph::ExecutionEvent event;
    const auto name = object.at("event").get<std::string>();
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                   [&](const auto& entry) { return entry.second == name; });
    if (kind == kKinds.end()) {
      throw std::runtime_error("unknown event '" + name + "'");
    }
    event.kind = kind->first;
    event.plan_id = object.at("plan_id").get<std::uint32_t>();
    if (object.contains("robot")) {
      const auto robot = object.at("robot").get<std::string>();
      const auto found = std::find(names.begin(), names.end(), robot);
      if (found == names.end()) {
        throw std::runtime_error("robot '" + robot + "' is not in the experiment");
      }
      event.robot = static_cast<int>(found - names.begin());
    }
    event.number = object.value("number", 0);
    event.text = object.value("text", std::string());
    if (event.kind == Kind::Started) {
      event.plan = std::make_shared<const sylph::MissionPlan>(
          planFromJson(object.at("plan"), event.plan_id));
    }
    return event;
  } catch (const json::exception& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace sylph_adg_central
