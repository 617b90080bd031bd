#include "sylph_rviz/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sylph_rviz {
namespace {

struct Rgb {
  int red;
  int green;
  int blue;
};

// Okabe and Ito's black is not seen on a dark floor: light grey takes its place.
constexpr std::array<Rgb, 8> kRobotColors = {{{86, 180, 233},
                                              {230, 159, 0},
                                              {0, 158, 115},
                                              {204, 121, 167},
                                              {240, 228, 66},
                                              {0, 114, 178},
                                              {213, 94, 0},
                                              {200, 200, 200}}};

// Cividis (Nunez, Anderton and Renslow 2018) from 0.3 to 1, evenly spaced.
constexpr std::array<Rgb, 10> kSvoColors = {{{79, 87, 108},
                                             {97, 101, 111},
                                             {114, 115, 116},
                                             {132, 130, 121},
                                             {151, 145, 119},
                                             {171, 160, 114},
                                             {192, 177, 106},
                                             {213, 194, 94},
                                             {235, 212, 75},
                                             {254, 232, 56}}};

std_msgs::ColorRGBA fromRgb(const Rgb& rgb) {
  return makeColor(rgb.red, rgb.green, rgb.blue);
}

}  // namespace

std_msgs::ColorRGBA makeColor(int red, int green, int blue, double alpha) {
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(red) / 255.0F;
  color.g = static_cast<float>(green) / 255.0F;
  color.b = static_cast<float>(blue) / 255.0F;
  color.a = static_cast<float>(alpha);
  return color;
}

std_msgs::ColorRGBA withAlpha(std_msgs::ColorRGBA color, double alpha) {
  color.a = static_cast<float>(alpha);
  return color;
}

std_msgs::ColorRGBA robotColor(std::size_t index) {
  return fromRgb(kRobotColors.at(index % kRobotColors.size()));
}

std_msgs::ColorRGBA textColorOn(const std_msgs::ColorRGBA& background) {
  // Relative luminance of ITU-R BT.709.
  const float luminance = 0.2126F * background.r + 0.7152F * background.g + 0.0722F * background.b;
  return luminance > 0.45F ? black() : white();
}

std_msgs::ColorRGBA svoColor(double svo_deg) {
  const double position = std::clamp(svo_deg, 0.0, 45.0) / 45.0 * (kSvoColors.size() - 1);
  return fromRgb(kSvoColors.at(static_cast<std::size_t>(std::lround(position))));
}

std_msgs::ColorRGBA white() {
  return makeColor(255, 255, 255);
}
std_msgs::ColorRGBA grey() {
  return makeColor(180, 180, 180);
}
std_msgs::ColorRGBA black() {
  return makeColor(0, 0, 0);
}
std_msgs::ColorRGBA orange() {
  return makeColor(230, 159, 0);
}
std_msgs::ColorRGBA skyBlue() {
  return makeColor(86, 180, 233);
}
std_msgs::ColorRGBA bluishGreen() {
  return makeColor(0, 158, 115);
}
std_msgs::ColorRGBA yellow() {
  return makeColor(240, 228, 66);
}
std_msgs::ColorRGBA vermillion() {
  return makeColor(213, 94, 0);
}

}  // namespace sylph_rviz
