#include "sylph_rviz/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "sylph_ros/conversions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_rviz {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kThinM = 0.002;  // thickness of what is flat

geometry_msgs::Point at(const sylph::Point& point, double height_m) {
  geometry_msgs::Point result = sylph_ros::toMessage(point);
  result.z = height_m;
  return result;
}

std::vector<geometry_msgs::Point> at(const std::vector<sylph::Point>& points, double height_m) {
  std::vector<geometry_msgs::Point> result;
  result.reserve(points.size());
  for (const sylph::Point& point : points) {
    result.push_back(at(point, height_m));
  }
  return result;
}

Marker line(const MarkerId& id, int type, const std::vector<sylph::Point>& points, double height_m,
            double line_width_m, const std_msgs::ColorRGBA& color) {
  Marker marker = makeMarker(id, type, color);
  marker.scale.x = line_width_m;
  marker.points = at(points, height_m);
  return marker;
}

Marker solid(const MarkerId& id, int type, const sylph::Point& center, double length_m,
             double width_m, double height_m, const std_msgs::ColorRGBA& color) {
  Marker marker = makeMarker(id, type, color);
  marker.pose.position = at(center, height_m);
  marker.scale.x = length_m;
  marker.scale.y = width_m;
  marker.scale.z = kThinM;
  return marker;
}

bool isClockwise(const sylph::Point& a, const sylph::Point& b, const sylph::Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0.0;
}

sylph::Point between(const sylph::Point& a, const sylph::Point& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

// Advance widths of the printable ASCII characters of Liberation Sans, in thousandths of the em.
constexpr std::array<int, 95> kAdvances = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr double kEm = 1000.0;

}  // namespace

Marker makeMarker(const MarkerId& id, int type, const std_msgs::ColorRGBA& color) {
  Marker marker;
  marker.header.frame_id = sylph_ros::kMapFrame;
  marker.ns = id.ns;
  marker.id = id.id;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = 1.0;
  marker.scale.y = 1.0;
  marker.scale.z = 1.0;
  marker.color = color;
  return marker;
}

Marker lineStrip(const MarkerId& id, const std::vector<sylph::Point>& points, double height_m,
                 double line_width_m, const std_msgs::ColorRGBA& color) {
  return line(id, Marker::LINE_STRIP, points, height_m, line_width_m, color);
}

Marker lineList(const MarkerId& id, const std::vector<sylph::Point>& points, double height_m,
                double line_width_m, const std_msgs::ColorRGBA& color) {
  return line(id, Marker::LINE_LIST, points, height_m, line_width_m, color);
}

std::vector<sylph::Point> pieces(const std::vector<sylph::Point>& line) {
  std::vector<sylph::Point> ends;
  for (std::size_t k = 1; k < line.size(); ++k) {
    ends.push_back(line[k - 1]);
    ends.push_back(line[k]);
  }
  return ends;
}

Marker triangles(const MarkerId& id, std::vector<sylph::Point> corners, double height_m,
                 const std_msgs::ColorRGBA& color) {
  // RViz lights the front of a triangle only, and the front is where it runs counterclockwise.
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    if (isClockwise(corners[i], corners[i + 1], corners[i + 2])) {
      std::swap(corners[i + 1], corners[i + 2]);
    }
  }
  Marker marker = makeMarker(id, Marker::TRIANGLE_LIST, color);
  marker.points = at(corners, height_m);
  return marker;
}

Marker disc(const MarkerId& id, const sylph::Point& center, double radius_m, double height_m,
            const std_msgs::ColorRGBA& color) {
  return solid(id, Marker::CYLINDER, center, 2.0 * radius_m, 2.0 * radius_m, height_m, color);
}

Marker ring(const MarkerId& id, const sylph::Point& center, double radius_m, double height_m,
            double line_width_m, const std_msgs::ColorRGBA& color) {
  constexpr int kSides = 32;
  std::vector<sylph::Point> points;
  for (int side = 0; side <= kSides; ++side) {
    const double angle_rad = 2.0 * kPi * side / kSides;
    points.push_back(
        {center.x + radius_m * std::cos(angle_rad), center.y + radius_m * std::sin(angle_rad)});
  }
  return lineStrip(id, points, height_m, line_width_m, color);
}

Marker box(const MarkerId& id, const sylph::Point& center, double length_m, double width_m,
           double height_m, const std_msgs::ColorRGBA& color) {
  return solid(id, Marker::CUBE, center, length_m, width_m, height_m, color);
}

Marker text(const MarkerId& id, const sylph::Point& center, double height_m, double letter_m,
            const std::string& words, const std_msgs::ColorRGBA& color) {
  Marker marker = makeMarker(id, Marker::TEXT_VIEW_FACING, color);
  marker.pose.position = at(center, height_m);
  marker.scale.z = letter_m;
  marker.text = words;
  return marker;
}

Marker textFrom(const MarkerId& id, const sylph::Point& start, double height_m, double letter_m,
                const std::string& words, const std_msgs::ColorRGBA& color) {
  const sylph::Point center{start.x + 0.5 * letter_m * textWidth(words), start.y};
  return text(id, center, height_m, letter_m, words, color);
}

double textWidth(const std::string& words) {
  double width = 0.0;
  for (const char letter : words) {
    const bool printable = letter >= ' ' && letter <= '~';
    width += kAdvances.at(static_cast<std::size_t>((printable ? letter : ' ') - ' '));
  }
  return width / kEm;
}

std::vector<std::string> wrapped(const std::string& words, std::size_t columns) {
  std::vector<std::string> lines;
  std::istringstream stream(words);
  std::string word;
  while (stream >> word) {
    if (!lines.empty() && lines.back().size() + 1 + word.size() <= columns) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::vector<sylph::Point> arrowHead(const sylph::Point& from, const sylph::Point& tip,
                                    double size_m) {
  const double angle_rad = std::atan2(tip.y - from.y, tip.x - from.x);
  const double cosine = std::cos(angle_rad) * size_m;
  const double sine = std::sin(angle_rad) * size_m;
  return {tip,
          {tip.x - cosine - 0.5 * sine, tip.y - sine + 0.5 * cosine},
          {tip.x - cosine + 0.5 * sine, tip.y - sine - 0.5 * cosine}};
}

std::vector<sylph::Point> bentLine(const sylph::Point& from, const sylph::Point& to, double gap_m) {
  constexpr int kPieces = 12;
  constexpr double kBend = 0.15;  // of the distance
  const double length_m = sylph::distance(from, to);
  // Never more than a third from each end: something of the line stays.
  const double cut = length_m > 0.0 ? std::min(gap_m / length_m, 1.0 / 3.0) : 0.0;
  std::vector<sylph::Point> points;
  for (int piece = 0; piece <= kPieces; ++piece) {
    const double part = cut + (1.0 - 2.0 * cut) * piece / kPieces;
    const double aside = 4.0 * kBend * part * (1.0 - part);
    const sylph::Point straight = between(from, to, part);
    points.push_back({straight.x - aside * (to.y - from.y), straight.y + aside * (to.x - from.x)});
  }
  return points;
}

std::vector<sylph::Point> dashes(const sylph::Point& from, const sylph::Point& to, double gap_m,
                                 double dash_m) {
  const double length_m = sylph::distance(from, to);
  const double cut_m = std::min(gap_m, length_m / 3.0);
  std::vector<sylph::Point> points;
  for (double start_m = cut_m; start_m < length_m - cut_m; start_m += 2.0 * dash_m) {
    const double end_m = std::min(start_m + dash_m, length_m - cut_m);
    points.push_back(between(from, to, start_m / length_m));
    points.push_back(between(from, to, end_m / length_m));
  }
  return points;
}

std::vector<sylph::Point> dashesAlong(const std::vector<sylph::Point>& ends, double dash_m) {
  std::vector<sylph::Point> points;
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    const std::vector<sylph::Point> piece = dashes(ends[k], ends[k + 1], 0.0, dash_m);
    points.insert(points.end(), piece.begin(), piece.end());
  }
  return points;
}

Marker attach(Marker marker, const RobotView& robot, bool turn) {
  marker.header.frame_id = robot.name;
  marker.frame_locked = 1;
  if (turn || !robot.pose) {
    return marker;
  }
  const double back_rad = -robot.pose->yaw_rad;
  const sylph::Vector2 offset =
      sylph::rotate({marker.pose.position.x, marker.pose.position.y}, back_rad);
  marker.pose.position.x = offset.x;
  marker.pose.position.y = offset.y;
  marker.pose.orientation = sylph_ros::quaternionFromYaw(back_rad);
  return marker;
}

}  // namespace sylph_rviz
