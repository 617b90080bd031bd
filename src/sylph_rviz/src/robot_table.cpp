#include "sylph_rviz/robot_table.hpp"

#include <QHeaderView>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <algorithm>
#include <optional>

#include "sylph_rviz/palette.hpp"
#include "sylph_rviz/qt_color.hpp"

namespace sylph_rviz {
namespace {

constexpr int kUpdatesPerFit = 10;  // of the columns' widths
// Columns of the table.
constexpr int kRobot = 0;
constexpr int kState = 1;
constexpr int kCell = 2;
constexpr int kPartner = 3;
constexpr int kSvo = 4;
constexpr int kPoseAge = 5;
constexpr int kError = 6;
constexpr int kWaits = 7;
constexpr int kColumns = 8;

/// Colour of a status, as its badge in the scene has it.
QColor statusColor(RobotStatus status) {
  switch (status) {
    case RobotStatus::Enqueued:
      return toQColor(bluishGreen());
    case RobotStatus::Staged:
      return toQColor(orange());
    case RobotStatus::Done:
      return toQColor(skyBlue());
    case RobotStatus::Held:
      return toQColor(yellow());
    case RobotStatus::Fault:
      return toQColor(vermillion());
    default:
      return toQColor(grey());
  }
}

/// Draws the SVO as a bar from 0 to 45 degrees with the number on it.
class SvoDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, QModelIndex());
    const QVariant value = index.data(Qt::UserRole);
    if (!value.isValid()) {
      return;
    }
    constexpr double kLargestDeg = 45.0;
    QRect bar = option.rect.adjusted(3, 4, -3, -4);
    painter->setPen(QColor(120, 120, 120));
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(bar);
    bar.setWidth(static_cast<int>(bar.width() * std::min(1.0, value.toDouble() / kLargestDeg)));
    painter->fillRect(bar, toQColor(svoColor(value.toDouble())));
    painter->setPen(option.palette.color(QPalette::Text));
    painter->drawText(option.rect, Qt::AlignCenter, index.data().toString());
  }
};

QString number(const std::optional<double>& value, double factor, int digits, const char* unit) {
  return value ? QString::number(factor * *value, 'f', digits) + unit : QString();
}

/// A cell of the table that is set is drawn and measured anew, also if it holds the same.
void setData(QTableWidgetItem* item, int role, const QVariant& value) {
  if (item->data(role) != value) {
    item->setData(role, value);
  }
}

void setText(QTableWidgetItem* item, const QString& text) {
  setData(item, Qt::DisplayRole, text);
}

/// The colour of a status, before its word.
void setStatus(QTableWidgetItem* item, RobotStatus status) {
  const QVariant value(static_cast<int>(status));
  if (item->data(Qt::UserRole) != value) {
    QPixmap square(10, 16);
    square.fill(statusColor(status));
    item->setData(Qt::DecorationRole, square);
    item->setData(Qt::UserRole, value);
  }
}

}  // namespace

RobotTable::RobotTable(QWidget* parent) : QTableWidget(0, kColumns, parent) {
  setHorizontalHeaderLabels(
      {"Robot", "State", "Cell", "Partner", "SVO [deg]", "Pose age", "Off path", "Waits for"});
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(24);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setItemDelegateForColumn(kSvo, new SvoDelegate(this));
  horizontalHeader()->setStretchLastSection(true);
}

void RobotTable::setRows(const std::vector<RobotRow>& rows) {
  setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < rowCount(); ++i) {
    for (int column = 0; column < kColumns; ++column) {
      if (item(i, column) == nullptr) {
        setItem(i, column, new QTableWidgetItem);
      }
    }
    const RobotRow& row = rows[static_cast<std::size_t>(i)];
    setText(item(i, kRobot), QString::fromStdString(row.name));
    setText(item(i, kState), QString::fromStdString(row.state));
    setStatus(item(i, kState), row.status);
    setText(item(i, kCell), QString::fromStdString(row.cell));
    setText(item(i, kPartner), QString::fromStdString(row.partner));
    setText(item(i, kSvo), number(row.svo_deg, 1.0, 0, ""));
    setData(item(i, kSvo), Qt::UserRole, row.svo_deg ? QVariant(*row.svo_deg) : QVariant());
    setText(item(i, kPoseAge), number(row.pose_age_s, 1.0, 2, " s"));
    setText(item(i, kError), number(row.tracking_error_m, 1000.0, 0, " mm"));
    setText(item(i, kWaits), QString::fromStdString(row.waits));
    setData(item(i, kWaits), Qt::ToolTipRole, QString::fromStdString(row.reason));
  }
  // Left to the header, each change of a cell would measure all others.
  if (updates_++ % kUpdatesPerFit == 0) {
    resizeColumnsToContents();
  }
}

std::string RobotTable::selectedRobot() const {
  const QList<QTableWidgetItem*> items = selectedItems();
  return items.isEmpty() ? "" : item(items.front()->row(), kRobot)->text().toStdString();
}

void RobotTable::selectRobot(const std::string& robot) {
  if (robot == selectedRobot()) {
    return;
  }
  const QSignalBlocker blocker(this);
  clearSelection();
  for (int i = 0; i < rowCount(); ++i) {
    if (item(i, kRobot)->text().toStdString() == robot) {
      selectRow(i);
    }
  }
}

}  // namespace sylph_rviz
