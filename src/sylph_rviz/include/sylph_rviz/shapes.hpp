#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>

#include <string>
#include <vector>

#include "sylph_core/grid/cell_frame.hpp"
#include "sylph_rviz/scene.hpp"

/// Markers of simple forms. All lie in the plane of the floor at a height that only orders them:
/// what is higher is drawn over what is lower. Lengths in metres.
namespace sylph_rviz {

using visualization_msgs::Marker;
using Markers = std::vector<Marker>;  ///< What a layer sends at once

/// Which of a layer's markers one is. RViz keeps a marker as long as its namespace and id stay.
struct MarkerId {
  std::string ns;  ///< the kind of sign, within its layer
  int id = 0;      ///< counts the signs of a kind
};

/// A marker in the frame `map` with stamp 0, so that it is drawn at the latest transform.
Marker makeMarker(const MarkerId& id, int type, const std_msgs::ColorRGBA& color);

/// A line through `points`.
Marker lineStrip(const MarkerId& id, const std::vector<sylph::Point>& points, double height_m,
                 double line_width_m, const std_msgs::ColorRGBA& color);
/// Lines between points 0 and 1, 2 and 3, ...
Marker lineList(const MarkerId& id, const std::vector<sylph::Point>& points, double height_m,
                double line_width_m, const std_msgs::ColorRGBA& color);
/// The pieces of a line one by one, as lineList() takes them: RViz draws a spike where a strip
/// turns back on itself.
std::vector<sylph::Point> pieces(const std::vector<sylph::Point>& line);
/// Filled triangles, three points each, in either orientation.
Marker triangles(const MarkerId& id, std::vector<sylph::Point> corners, double height_m,
                 const std_msgs::ColorRGBA& color);
/// A filled circle.
Marker disc(const MarkerId& id, const sylph::Point& center, double radius_m, double height_m,
            const std_msgs::ColorRGBA& color);
/// The outline of a circle.
Marker ring(const MarkerId& id, const sylph::Point& center, double radius_m, double height_m,
            double line_width_m, const std_msgs::ColorRGBA& color);
/// A flat box, `length_m` along x.
Marker box(const MarkerId& id, const sylph::Point& center, double length_m, double width_m,
           double height_m, const std_msgs::ColorRGBA& color);
/// Text that faces the camera, its middle at `center`. RViz's font has ASCII only.
/// @param letter_m  size of the font, its em
Marker text(const MarkerId& id, const sylph::Point& center, double height_m, double letter_m,
            const std::string& words, const std_msgs::ColorRGBA& color);
/// Text that begins at `start`.
Marker textFrom(const MarkerId& id, const sylph::Point& start, double height_m, double letter_m,
                const std::string& words, const std_msgs::ColorRGBA& color);

/// Width of one line of text in RViz's font, Liberation Sans, at a size of 1 m.
double textWidth(const std::string& words);

/// The words in lines of at most `columns` letters, broken at spaces; a longer word stays whole.
std::vector<std::string> wrapped(const std::string& words, std::size_t columns);

/// Corners of the triangle at the end of an arrow that arrives at `tip` from `from`.
std::vector<sylph::Point> arrowHead(const sylph::Point& from, const sylph::Point& tip,
                                    double size_m);

/// A line from `from` to `to` that bends to its left, so that arrows of two that point at each
/// other do not lie on each other. Both ends are cut by `gap_m` along the way.
/// @return at least two points
std::vector<sylph::Point> bentLine(const sylph::Point& from, const sylph::Point& to, double gap_m);

/// Dashes along a straight line, as lineList() takes them. Both ends are cut by `gap_m`.
std::vector<sylph::Point> dashes(const sylph::Point& from, const sylph::Point& to, double gap_m,
                                 double dash_m);

/// Dashes along each of the lines that pieces() gives.
std::vector<sylph::Point> dashesAlong(const std::vector<sylph::Point>& ends, double dash_m);

/// Ties a marker that was made around the origin to a robot, so that it moves with the robot's
/// transform between two messages.
/// @param turn  whether it turns with the robot; otherwise it keeps the directions of the map
Marker attach(Marker marker, const RobotView& robot, bool turn = false);

}  // namespace sylph_rviz
