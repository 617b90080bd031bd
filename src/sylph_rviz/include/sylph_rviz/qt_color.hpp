#pragma once

#include <std_msgs/ColorRGBA.h>

#include <QColor>

namespace sylph_rviz {

/// A colour of the scene in the panel; opaque.
inline QColor toQColor(const std_msgs::ColorRGBA& color) {
  return QColor::fromRgbF(color.r, color.g, color.b);
}

}  // namespace sylph_rviz
