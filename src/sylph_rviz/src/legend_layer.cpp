#include <sylph_msgs/AgentAction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "sylph_rviz/layers.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

using sylph_msgs::AdgState;

// Lengths at full size; the legend is made smaller to be as high as the map.
constexpr double kMarginM = 0.25;  // from the map to the legend
constexpr double kSignM = 0.22;    // from a sign's middle to its words
constexpr double kLineM = 0.24;    // from line to line
constexpr double kLetterM = 0.14;
constexpr double kTitleM = 0.18;
constexpr std::size_t kColumns = 36;  // letters in a line
constexpr int kLines = 23;
constexpr double kSmallest = 0.5;

/// The factor that makes the legend as high as the map, within bounds.
double legendScale(const MapExtent& map) {
  return std::clamp(map.rows * map.cell_size_m / (kLines * kLineM), kSmallest, 1.0);
}

Marker scaled(Marker marker, double factor) {
  for (geometry_msgs::Point& point : marker.points) {
    point.x *= factor;
    point.y *= factor;
  }
  // The points of a triangle list are multiplied by its scale.
  if (marker.type != Marker::TRIANGLE_LIST) {
    marker.scale.x *= factor;
    marker.scale.y *= factor;
    marker.scale.z *= factor;
  }
  marker.pose.position.x *= factor;
  marker.pose.position.y *= factor;
  return marker;
}

const char* phaseName(std::uint8_t phase) {
  constexpr std::array<const char*, 7> kNames = {"IDLE",   "PENDING",  "EXECUTING", "CUTTING",
                                                 "AT CUT", "FINISHED", "REFUSED"};
  return phase < kNames.size() ? kNames.at(phase) : "?";
}

std::string format(const char* pattern, double first, double second) {
  std::array<char, 128> buffer{};
  std::snprintf(buffer.data(), buffer.size(), pattern, first, second);
  return buffer.data();
}

/// Writes the legend line by line, from the top of the map down.
class Writer {
 public:
  explicit Writer(const MapExtent& map)
      : scale_(legendScale(map)),
        x_m_(map.corner.x + map.cols * map.cell_size_m + kMarginM * scale_),
        y_m_(map.corner.y + map.rows * map.cell_size_m - 0.5 * kLineM * scale_) {}

  void line(const std::string& words, const std_msgs::ColorRGBA& color,
            double letter_m = kLetterM) {
    write(words, 0.0, color, letter_m);
    advance(1.0);
  }

  void gap() { advance(0.5); }

  /// A sign, made of markers around the origin, and its meaning.
  void sign(const Markers& parts, const std::string& words) {
    const double middle_m = 0.6 * kSignM;
    for (const Marker& part : parts) {
      Marker marker = scaled(part, scale_);
      marker.ns = "signs";
      marker.id = next_id_++;
      marker.pose.position.x += x_m_ + middle_m * scale_;
      marker.pose.position.y += y_m_;
      markers_.push_back(std::move(marker));
    }
    write(words, middle_m + kSignM, white(), kLetterM);
    advance(1.0);
  }

  Markers take() { return std::move(markers_); }

 private:
  void write(const std::string& words, double indent_m, const std_msgs::ColorRGBA& color,
             double letter_m) {
    const sylph::Point start{x_m_ + indent_m * scale_, y_m_};
    markers_.push_back(
        textFrom({"words", next_id_++}, start, height::kText, letter_m * scale_, words, color));
  }

  void advance(double lines) { y_m_ -= lines * kLineM * scale_; }

  double scale_;
  double x_m_;
  double y_m_;
  int next_id_ = 0;
  Markers markers_;
};

void writeMission(const Scene& scene, Writer& writer) {
  if (!scene.state) {
    writer.line("waiting for the central node", white(), kTitleM);
    return;
  }
  const AdgState& state = *scene.state;
  std::string title = phaseName(state.phase);
  if (state.mode != AdgState::RUN) {
    title += state.mode == AdgState::PAUSE ? ", PAUSED" : ", STOPPED";
  }
  writer.line(title, state.mode == AdgState::RUN ? white() : yellow(), kTitleM);
  for (const std::string& words : wrapped(state.message, kColumns)) {
    writer.line(words, yellow());
  }
  double arrived = 0.0;
  for (const sylph_msgs::RobotExecution& robot : state.robots) {
    arrived += statusOf(state, robot) == RobotStatus::Done ? 1.0 : 0.0;
  }
  writer.line(format("%.0f of %.0f arrived", arrived, static_cast<double>(state.robots.size())),
              white());
  writer.line(format("%.1f s, plan of %.0f steps", state.elapsed_s, state.steps), white());
  if (scene.separation && std::isfinite(scene.separation->separation_m)) {
    writer.line(format("gap %.0f mm, smallest %.0f mm", 1e3 * scene.separation->separation_m,
                       1e3 * scene.separation->min_separation_m),
                scene.separation->violated != 0 ? vermillion() : white());
  }
}

Markers robotSign() {
  return {box({}, {0.0, 0.0}, 0.20, 0.17, height::kBody, robotColor(0)),
          lineList({}, {{0.085, 0.06}, {0.085, -0.06}}, height::kBody + 0.01, 0.02,
                   withAlpha(black(), 0.6)),
          text({}, {0.0, 0.0}, height::kText, 0.12, "0", black())};
}

Markers arrowSign(bool wait) {
  const std_msgs::ColorRGBA color = wait ? orange() : svoColor(45.0);
  const std::vector<sylph::Point> line = wait ? dashes({-0.14, 0.0}, {0.14, 0.0}, 0.0, 0.04)
                                              : bentLine({-0.14, 0.0}, {0.14, 0.0}, 0.0);
  Marker stroke = wait ? lineList({}, line, height::kWait, 0.03, color)
                       : lineStrip({}, line, height::kWait, 0.025, color);
  return {std::move(stroke),
          triangles({}, arrowHead({-0.14, 0.0}, {0.14, 0.0}, 0.10), height::kWait, color)};
}

void writeSigns(Writer& writer) {
  using sylph_msgs::AgentAction;
  const auto badge = [&](RobotStatus status, const std::string& words) {
    writer.sign(statusBadge("", 0, status, AgentAction::EAST), words);
  };
  writer.sign(robotSign(), "robot, its front marked");
  writer.sign({ring({}, {0.0, 0.0}, 0.09, height::kGoal, 0.025, robotColor(0)),
               text({}, {0.0, 0.0}, height::kText, 0.12, "0", robotColor(0))},
              "its goal");
  writer.sign({lineStrip({}, {{-0.14, 0.0}, {0.14, 0.0}}, height::kPath, 0.018, robotColor(0))},
              "its way still to go");
  writer.gap();
  writer.sign(arrowSign(false), "to its partner");
  writer.sign(svoGauge("", 0, 0.0, 0.18), "SVO 0 deg: selfish");
  writer.sign(svoGauge("", 0, 20.0, 0.18), "SVO 20 deg");
  writer.sign(svoGauge("", 0, 45.0, 0.18), "SVO 45 deg: prosocial");
  writer.sign({text({}, {0.0, 0.0}, height::kText, kLetterM, "-", white())},
              "no SVO from this planner");
  writer.gap();
  badge(RobotStatus::Enqueued, "task ENQUEUED: drives");
  badge(RobotStatus::Staged, "task STAGED: waits");
  badge(RobotStatus::Done, "all DONE: arrived");
  badge(RobotStatus::Held, "held: paused or stopped");
  badge(RobotStatus::Fault, "fault");
  writer.gap();
  writer.sign(arrowSign(true), "waits for, and for which cell");
  writer.sign({ring({}, {0.0, 0.0}, 0.09, height::kWait, 0.03, vermillion())},
              "root cause of waits");
}

}  // namespace

Markers legendMarkers(const Scene& scene) {
  if (!scene.map) {
    return {};
  }
  Writer writer(*scene.map);
  writeMission(scene, writer);
  writer.gap();
  writeSigns(writer);
  if (scene.robots.size() > kCrowd) {
    writer.gap();
    writer.line("faint: neither selected nor waiting", white());
  }
  return writer.take();
}

}  // namespace sylph_rviz
