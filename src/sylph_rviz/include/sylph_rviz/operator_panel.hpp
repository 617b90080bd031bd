#pragma once

#include <rviz/panel.h>

#include <memory>
#include <string>

#include "sylph_rviz/operator_link.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;
class QSpinBox;
class QVBoxLayout;

namespace sylph_rviz {

class RobotTable;
class SvoChart;

/// RViz panel `sylph_rviz/OperatorPanel`: where the mission stands, a line for each robot, and the
/// operator's commands.
class OperatorPanel : public rviz::Panel {
  Q_OBJECT

 public:
  /// @param parent  as Qt wants it; takes the panel over
  explicit OperatorPanel(QWidget* parent = nullptr);
  ~OperatorPanel() override;

  /// Brings what is shown up to date. Called by a timer.
  void refresh();

 private:
  void buildMission(QVBoxLayout* column);
  void buildReplay(QVBoxLayout* column);
  void buildCommands(QVBoxLayout* column);
  void buildGoals(QVBoxLayout* column);
  void buildTable(QVBoxLayout* column);
  static QPushButton* makeButton(const char* name, const QString& text);
  void start();
  void askWhereToSave();
  void showExperiments();
  void showMission(const OperatorView& view);
  void showReplay(const OperatorView& view);
  void showReplayTime(double at_s);
  void showGoals(const OperatorView& view);
  void showCommands(const OperatorView& view);
  void showSelection(const OperatorView& view);
  void showReasons(const OperatorView& view);

  std::unique_ptr<OperatorLink> link_;
  std::vector<ExperimentChoice> experiments_;
  QComboBox* experiment_ = nullptr;
  QComboBox* planner_ = nullptr;
  QSpinBox* seed_ = nullptr;
  QLabel* headline_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* times_ = nullptr;
  QLabel* message_ = nullptr;
  QWidget* replay_ = nullptr;  ///< the row with the slider
  QSlider* replay_place_ = nullptr;
  QLabel* replay_time_ = nullptr;
  QLabel* outcome_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* pause_ = nullptr;
  QPushButton* resume_ = nullptr;
  QPushButton* stop_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* confirm_pose_ = nullptr;
  QLabel* goals_ = nullptr;
  QCheckBox* others_give_way_ = nullptr;
  QPushButton* plan_ = nullptr;
  QPushButton* go_ = nullptr;
  QPushButton* clear_goals_ = nullptr;
  QPushButton* save_ = nullptr;
  RobotTable* table_ = nullptr;
  QLabel* signs_ = nullptr;
  SvoChart* svo_ = nullptr;
  QLabel* reasons_ = nullptr;
};

}  // namespace sylph_rviz
