#pragma once

#include <std_msgs/ColorRGBA.h>

#include <cstddef>

/// Colours of all layers, for a dark background. Hues are those of Okabe and Ito (2008), which
/// readers with any kind of colour vision tell apart; no meaning hangs on red against green.
namespace sylph_rviz {

/// @param red, green, blue  0 ... 255.
std_msgs::ColorRGBA makeColor(int red, int green, int blue, double alpha = 1.0);
/// @param alpha  0 ... 1, invisible ... opaque.
std_msgs::ColorRGBA withAlpha(std_msgs::ColorRGBA color, double alpha);

/// Colour of the index-th robot, of its goal and of its path. Eight colours, then they repeat.
std_msgs::ColorRGBA robotColor(std::size_t index);

/// Black or white, whichever is easier to read on `background`.
std_msgs::ColorRGBA textColorOn(const std_msgs::ColorRGBA& background);

/// Colour of an SVO: the upper part of the cividis scale, grey blue at 0 and yellow at 45 degrees.
/// Angles outside are clamped.
std_msgs::ColorRGBA svoColor(double svo_deg);

/// Colours by name, opaque.
///@{
std_msgs::ColorRGBA white();
std_msgs::ColorRGBA grey();
std_msgs::ColorRGBA black();
std_msgs::ColorRGBA orange();
std_msgs::ColorRGBA skyBlue();
std_msgs::ColorRGBA bluishGreen();
std_msgs::ColorRGBA yellow();
std_msgs::ColorRGBA vermillion();
///@}

}  // namespace sylph_rviz
