#pragma once

#include <QTableWidget>
#include <string>
#include <vector>

#include "sylph_rviz/operator_model.hpp"

namespace sylph_rviz {

/// A line for each robot, of which one may be selected: the SVO as a bar, the state with the colour
/// of its badge in the scene.
class RobotTable : public QTableWidget {
 public:
  /// @param parent  as Qt wants it
  explicit RobotTable(QWidget* parent = nullptr);

  /// Brings the lines up to date. Meant to be called many times a second: only cells that have
  /// changed are set.
  void setRows(const std::vector<RobotRow>& rows);
  /// The robot of the selected line; empty: none.
  std::string selectedRobot() const;
  /// Selects a robot's line, without a signal; empty: none.
  void selectRobot(const std::string& robot);

 private:
  long updates_ = 0;
};

}  // namespace sylph_rviz
