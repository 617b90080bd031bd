#include "sylph_rviz/operator_panel.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QProxyStyle>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <pluginlib/class_list_macros.hpp>

#include "sylph_core/planners/planner.hpp"
#include "sylph_ros/topics.hpp"
#include "sylph_rviz/robot_table.hpp"
#include "sylph_rviz/svo_chart.hpp"

namespace sylph_rviz {
namespace {

constexpr int kRefreshPeriodMs = 100;
constexpr double kReplayStepS = 0.1;  // of the slider

/// A slider of this style goes to where it is clicked, not a page in that direction.
class ClickedPlaceStyle : public QProxyStyle {
 public:
  explicit ClickedPlaceStyle(QObject* owner) { setParent(owner); }
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* answer) const override {
    return hint == SH_Slider_AbsoluteSetButtons
               ? static_cast<int>(Qt::LeftButton)
               : QProxyStyle::styleHint(hint, option, widget, answer);
  }
};

QString fromText(const std::string& text) {
  return QString::fromStdString(text);
}

/// Greyed out with the reason as its tool tip, or free.
void setRefusal(QPushButton* button, const Refusal& refusal) {
  button->setEnabled(refusal.empty());
  button->setToolTip(fromText(refusal));
}

}  // namespace

OperatorPanel::OperatorPanel(QWidget* parent)
    : rviz::Panel(parent),
      link_(std::make_unique<OperatorLink>(ros::NodeHandle(sylph_ros::kSuiteNamespace))) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 6, 6, 6);
  column->setSpacing(4);
  buildMission(column);
  buildCommands(column);
  buildTable(column);
  buildGoals(column);
  // What was said to this process before is not said again.
  for (const QWidget* widget : QApplication::allWidgets()) {
    const auto* other = qobject_cast<const OperatorPanel*>(widget);
    if (other != nullptr && other != this) {
      link_->select(other->link_->view().selected);
    }
  }
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &OperatorPanel::refresh);
  timer->start(kRefreshPeriodMs);
  refresh();
}

OperatorPanel::~OperatorPanel() = default;

void OperatorPanel::buildMission(QVBoxLayout* column) {
  headline_ = new QLabel;
  headline_->setObjectName("headline");
  QFont font = headline_->font();
  font.setBold(true);
  font.setPointSizeF(1.15 * font.pointSizeF());
  headline_->setFont(font);
  progress_ = new QProgressBar;
  progress_->setObjectName("progress");
  times_ = new QLabel;
  message_ = new QLabel;
  message_->setObjectName("message");
  message_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->addWidget(progress_, 1);
  row->addWidget(times_);
  column->addWidget(headline_);
  column->addLayout(row);
  buildReplay(column);
}

void OperatorPanel::buildReplay(QVBoxLayout* column) {
  replay_ = new QWidget;
  replay_place_ = new QSlider(Qt::Horizontal);
  replay_place_->setObjectName("replay");
  replay_place_->setStyle(new ClickedPlaceStyle(replay_place_));
  replay_place_->setTracking(false);  // while it is dragged the bag would begin anew all the time
  replay_time_ = new QLabel;
  replay_time_->setObjectName("replay_time");
  auto* row = new QHBoxLayout(replay_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel("Replay"));
  row->addWidget(replay_place_, 1);
  row->addWidget(replay_time_);
  column->addWidget(replay_);
  connect(replay_place_, &QSlider::valueChanged, this,
          [this](int steps) { link_->seek(kReplayStepS * steps); });
  connect(replay_place_, &QSlider::sliderMoved, this,
          [this](int steps) { showReplayTime(kReplayStepS * steps); });
}

QPushButton* OperatorPanel::makeButton(const char* name, const QString& text) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  return button;
}

void OperatorPanel::buildCommands(QVBoxLayout* column) {
  experiment_ = new QComboBox;
  experiment_->setObjectName("experiment");
  planner_ = new QComboBox;
  planner_->setObjectName("planner");
  planner_->addItem("its own planner", "");
  for (const std::string& name : sylph::plannerNames()) {
    planner_->addItem(fromText(name), fromText(name));
  }
  seed_ = new QSpinBox;
  seed_->setObjectName("seed");
  seed_->setRange(-1, std::numeric_limits<int>::max());
  seed_->setValue(-1);
  seed_->setSpecialValueText("its own seed");
  seed_->setPrefix("seed ");
  seed_->setToolTip("redraws the goals of an experiment that calls them random");
  auto* choices = new QHBoxLayout;
  choices->addWidget(experiment_, 2);
  choices->addWidget(planner_, 2);
  choices->addWidget(seed_, 1);
  column->addLayout(choices);

  start_ = makeButton("start", "Start");
  pause_ = makeButton("pause", "Pause");
  resume_ = makeButton("resume", "Resume");
  stop_ = makeButton("stop", "STOP");
  cancel_ = makeButton("cancel", "Cancel mission");
  auto* buttons = new QHBoxLayout;
  confirm_pose_ = makeButton("confirm_pose", "Confirm pose");
  for (QPushButton* button : {start_, pause_, resume_, stop_, cancel_, confirm_pose_}) {
    buttons->addWidget(button);
  }
  column->addLayout(buttons);
  // What comes and goes is below the buttons, so that STOP stays under the mouse.
  column->addWidget(message_);
  connect(start_, &QPushButton::clicked, this, &OperatorPanel::start);
  connect(pause_, &QPushButton::clicked, this, [this] { link_->pause(); });
  connect(resume_, &QPushButton::clicked, this, [this] { link_->resume(); });
  connect(stop_, &QPushButton::clicked, this, [this] { link_->stop(); });
  connect(cancel_, &QPushButton::clicked, this, [this] { link_->cancel(); });
  connect(confirm_pose_, &QPushButton::clicked, this,
          [this] { link_->confirmPose(link_->view().selected); });
  outcome_ = new QLabel;
  outcome_->setObjectName("outcome");
  outcome_->setWordWrap(true);
  column->addWidget(outcome_);
}

void OperatorPanel::buildTable(QVBoxLayout* column) {
  table_ = new RobotTable;
  table_->setObjectName("robots");
  table_->setToolTip(
      "Select a robot: the scene shows its plan and way, its cells, its partner and "
      "for whom it waits. Ctrl+click ends that.");
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { link_->select(table_->selectedRobot()); });
  column->addWidget(table_, 1);
  signs_ = new QLabel;
  signs_->setObjectName("signs");
  signs_->setWordWrap(true);
  column->addWidget(signs_);
  svo_ = new SvoChart;
  svo_->setObjectName("svo");
  column->addWidget(svo_);
  reasons_ = new QLabel;
  reasons_->setObjectName("reasons");
  reasons_->setWordWrap(true);
  column->addWidget(reasons_);
}

void OperatorPanel::buildGoals(QVBoxLayout* column) {
  goals_ = new QLabel;
  goals_->setObjectName("goals");
  goals_->setWordWrap(true);
  column->addWidget(goals_);
  plan_ = makeButton("plan", "Plan");
  go_ = makeButton("go", "Go");
  clear_goals_ = makeButton("clear_goals", "Clear");
  save_ = makeButton("save", "Save...");
  others_give_way_ = new QCheckBox("others give way");
  others_give_way_->setObjectName("others_give_way");
  others_give_way_->setToolTip(
      "robots without a goal may step aside and come back; "
      "otherwise they stay and are obstacles");
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel("Goals by mouse"));
  for (QPushButton* button : {plan_, go_, clear_goals_, save_}) {
    row->addWidget(button);
  }
  row->addWidget(others_give_way_);
  column->addLayout(row);
  connect(plan_, &QPushButton::clicked, this, [this] { link_->plan(); });
  connect(go_, &QPushButton::clicked, this, [this] { link_->go(); });
  connect(clear_goals_, &QPushButton::clicked, this, [this] { link_->clearGoals(); });
  connect(save_, &QPushButton::clicked, this, &OperatorPanel::askWhereToSave);
  connect(others_give_way_, &QCheckBox::toggled, this,
          [this](bool give_way) { link_->setOthersGiveWay(give_way); });
}

void OperatorPanel::askWhereToSave() {
  auto* dialog =
      new QFileDialog(this, "Save the mission as an experiment", QString(), "Experiments (*.yaml)");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("yaml");
  // A file that is there is left alone in any case, with a line that says so.
  dialog->setOption(QFileDialog::DontConfirmOverwrite);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& path) { link_->save(path.toStdString()); });
  dialog->open();
}

void OperatorPanel::start() {
  MissionChoice choice;
  choice.experiment_path = experiment_->currentData().toString().toStdString();
  choice.planner = planner_->currentData().toString().toStdString();
  if (seed_->value() >= 0) {
    choice.seed = static_cast<std::uint32_t>(seed_->value());
  }
  link_->start(choice);
}

void OperatorPanel::refresh() {
  const OperatorView view = link_->view();
  showExperiments();
  showMission(view);
  showReplay(view);
  showCommands(view);
  showGoals(view);
  table_->setRows(view.rows);
  showSelection(view);
  showReasons(view);
  if (const std::string outcome = link_->takeOutcome(); !outcome.empty()) {
    outcome_->setText(fromText(outcome));
  }
}

void OperatorPanel::showExperiments() {
  std::vector<ExperimentChoice> choices = link_->experiments();
  if (choices == experiments_) {
    return;
  }
  experiments_ = std::move(choices);
  experiment_->clear();
  for (const ExperimentChoice& choice : experiments_) {
    experiment_->addItem(fromText(choice.name), fromText(choice.path));
    const int row = experiment_->count() - 1;
    const std::string tip = choice.refusal.empty() ? choice.path : choice.refusal;
    experiment_->setItemData(row, fromText(tip), Qt::ToolTipRole);
    if (!choice.refusal.empty()) {
      qobject_cast<QStandardItemModel*>(experiment_->model())->item(row)->setEnabled(false);
    }
  }
}

void OperatorPanel::showMission(const OperatorView& view) {
  headline_->setText(fromText(view.headline));
  progress_->setMaximum(std::max(1, view.tasks_total));
  progress_->setValue(view.tasks_done);
  progress_->setFormat(QString("%1 of %2 tasks").arg(view.tasks_done).arg(view.tasks_total));
  QString times;
  if (view.elapsed_s) {
    times = fromText(durationText(*view.elapsed_s));
  }
  if (view.left_s) {
    times += ", about " + fromText(durationText(std::round(*view.left_s))) + " left";
  }
  times_->setText(times);
  message_->setText(fromText(view.message));
  message_->setVisible(!view.message.empty());
  message_->setStyleSheet(view.is_alarm ? "color: rgb(190, 60, 0); font-weight: bold" : "");
}

void OperatorPanel::showReplay(const OperatorView& view) {
  replay_->setVisible(view.replay.has_value());
  if (!view.replay || replay_place_->isSliderDown()) {
    return;
  }
  const QSignalBlocker blocker(replay_place_);
  replay_place_->setMaximum(static_cast<int>(view.replay->length_s / kReplayStepS));
  replay_place_->setValue(static_cast<int>(view.replay->at_s / kReplayStepS));
  replay_place_->setPageStep(std::max(1, replay_place_->maximum() / 10));
  showReplayTime(view.replay->at_s);
}

void OperatorPanel::showReplayTime(double at_s) {
  replay_time_->setText(fromText(durationText(at_s) + " of " +
                                 durationText(kReplayStepS * replay_place_->maximum())));
}

void OperatorPanel::showCommands(const OperatorView& view) {
  Refusal start = view.start;
  if (start.empty() && experiment_->currentIndex() < 0) {
    start = "the lab's experiment is not known here";
  }
  setRefusal(start_, start);
  setRefusal(pause_, view.pause);
  setRefusal(resume_, view.resume);
  setRefusal(stop_, view.stop);
  setRefusal(cancel_, view.cancel);
  const std::string& robot = view.selected;
  setRefusal(confirm_pose_, !view.confirm_pose.empty() ? view.confirm_pose
                            : robot.empty()            ? "select the robot's row"
                                                       : "");
  confirm_pose_->setText(robot.empty() ? "Confirm pose" : "Confirm pose of " + fromText(robot));
  stop_->setStyleSheet(
      view.stop.empty() ? "background: rgb(213, 94, 0); color: white; font-weight: bold" : "");
  if (!view.stop.empty() && view.stop == view.pause) {
    outcome_->setText("commands are off: " + fromText(view.stop));
  }
}

void OperatorPanel::showGoals(const OperatorView& view) {
  setRefusal(plan_, view.plan);
  setRefusal(go_, view.go);
  setRefusal(clear_goals_, view.clear_goals);
  setRefusal(save_, view.save);
  others_give_way_->setEnabled(view.set_goal.empty());
  goals_->setText(fromText(view.goals));
  goals_->setVisible(!view.goals.empty());
}

void OperatorPanel::showSelection(const OperatorView& view) {
  signs_->setVisible(!view.selected.empty());
  signs_->setText(fromText(view.selected) +
                  ": band = its plan, white = driven, squares = cells it holds, dashes = its "
                  "partner's way, 1 2 3 = who waits for whom");
  svo_->setSeries(view.svo, view.svo_step);
  table_->selectRobot(view.selected);
}

void OperatorPanel::showReasons(const OperatorView& view) {
  constexpr int kLines = 8;
  QStringList lines;
  for (const RobotRow& row : view.rows) {
    if (row.name == view.selected) {
      for (const std::string& line : row.chain) {
        lines.append(fromText(line));
      }
    }
  }
  const bool is_of_selected = !lines.isEmpty();
  for (const RobotRow& row : view.rows) {
    if (!row.reason.empty() && !is_of_selected) {
      lines.append(fromText(row.name + " " + row.reason));
    }
  }
  const auto more = lines.size() - kLines;
  if (more > 0) {
    lines = lines.mid(0, kLines);
    lines.append(QString("and %1 more").arg(more));
  }
  reasons_->setText(lines.join("\n"));
  reasons_->setVisible(!lines.isEmpty());
}

}  // namespace sylph_rviz

PLUGINLIB_EXPORT_CLASS(sylph_rviz::OperatorPanel, rviz::Panel)
