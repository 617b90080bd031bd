#pragma once

#include <QWidget>
#include <cstdint>
#include <vector>

#include "sylph_rviz/operator_model.hpp"

namespace sylph_rviz {

/// Draws a robot's SVO over the timesteps of its plan as columns in the colours of the scale, its
/// partner's as a dashed line over them, and a mark where the robot is now.
class SvoChart : public QWidget {
 public:
  /// @param parent  as Qt wants it
  explicit SvoChart(QWidget* parent = nullptr);

  /// @param series  the robot's, then its partner's if there is one; empty: hides the chart
  /// @param step    at which the robot is
  void setSeries(const std::vector<SvoSeries>& series, std::uint32_t step);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<SvoSeries> series_;
  std::uint32_t step_ = 0;
};

}  // namespace sylph_rviz
