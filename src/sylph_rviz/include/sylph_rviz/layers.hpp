#pragma once

#include <array>

#include "sylph_rviz/scene.hpp"
#include "sylph_rviz/shapes.hpp"

/// The layers of the picture, each from the scene alone. A robot without a pose is left out; what
/// is drawn of one that is not in front, see inFront(), is faint.
namespace sylph_rviz {

/// Footprints with the front marked, and short names. Move with the robots' transforms.
Markers robotMarkers(const Scene& scene);

/// Where each robot goes in the end: a ring with its name, in the robot's colour.
Markers goalMarkers(const Scene& scene);

/// The way still to go: a line in the robot's colour, each robot in a lane of its own.
Markers pathMarkers(const Scene& scene);

/// From each robot to its partner, in the colour of its SVO.
Markers partnerMarkers(const Scene& scene);

/// The SVO as a number in degrees, "-" where the planner gives none, and as a gauge: a sector that
/// opens from the map's x axis by the SVO itself.
Markers svoMarkers(const Scene& scene);

/// What each robot is about, by a badge of its own shape and colour.
Markers statusMarkers(const Scene& scene);

/// Who waits for whom, by which cell, and which robot is the root cause.
Markers waitMarkers(const Scene& scene);

/// Of the selected robot: its planned and its driven path, the cells that it holds, its partner's
/// way, and who waits for whom, from it to the one that holds it up.
Markers selectionMarkers(const Scene& scene);

/// The plan that is shown before anybody moves: each robot's way, dashed, in a lane of its own, and
/// its goal. Not while a mission is carried out.
Markers shownPlanMarkers(const Scene& scene);

/// What the signs mean, and how the mission stands. Beside the map, on its right.
Markers legendMarkers(const Scene& scene);

/// A badge around the origin: a disc, and on it the sign of the status.
/// @param action  AgentAction constant: the way that an enqueued task drives
Markers statusBadge(const std::string& ns, int first_id, RobotStatus status, std::uint8_t action);
/// Markers that one badge has at most: ids of badges are this far apart.
constexpr int kBadgeMarkers = 3;

/// A gauge around the origin; without an SVO only its outline.
Markers svoGauge(const std::string& ns, int first_id, double svo_deg, double radius_m);
/// Markers that one gauge has at most.
constexpr int kGaugeMarkers = 3;

/// One layer: its topic, below the suite's namespace, and what draws it.
struct Layer {
  const char* topic;  ///< relative
  /// The whole layer, anew each time.
  Markers (*draw)(const Scene&);
};

/// All layers. One topic each: a display that is switched on again subscribes again and gets the
/// latched picture.
constexpr std::array<Layer, 10> kLayers = {{{"markers/robots", robotMarkers},
                                            {"markers/goals", goalMarkers},
                                            {"markers/paths", pathMarkers},
                                            {"markers/partners", partnerMarkers},
                                            {"markers/svo", svoMarkers},
                                            {"markers/status", statusMarkers},
                                            {"markers/waits", waitMarkers},
                                            {"markers/selection", selectionMarkers},
                                            {"markers/shown_plan", shownPlanMarkers},
                                            {"markers/legend", legendMarkers}}};

/// Of the goals that are set by hand, which the operator's panel draws.
constexpr char kGoalLayerTopic[] = "markers/goals_set";

/// Opacity of ways, goals and partners of robots that are not in front, see inFront().
constexpr double kBehindAlpha = 0.25;

/// Heights that order what overlaps [m].
namespace height {
/// Of the sign that the name says, from the floor up.
///@{
constexpr double kHeldCell = 0.005;
constexpr double kPlanned = 0.01;
constexpr double kPath = 0.02;
constexpr double kGoal = 0.03;
constexpr double kGauge = 0.04;
constexpr double kDriven = 0.05;
constexpr double kBody = 0.06;
constexpr double kWait = 0.08;
constexpr double kPartner = 0.10;
constexpr double kBadge = 0.12;
constexpr double kText = 0.20;
///@}
}  // namespace height

}  // namespace sylph_rviz
