#include "sylph_rviz/svo_chart.hpp"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "sylph_rviz/palette.hpp"
#include "sylph_rviz/qt_color.hpp"

namespace sylph_rviz {
namespace {

constexpr int kHeight = 110;
constexpr int kMargin = 3;
constexpr double kLargestDeg = 45.0;
constexpr int kGridDeg = 15;

/// Turns timesteps and degrees into pixels.
struct Axes {
  QRectF area;
  std::size_t steps;

  double x(std::size_t step) const {
    return area.left() + area.width() * static_cast<double>(step) / static_cast<double>(steps);
  }
  double y(double svo_deg) const { return area.bottom() - area.height() * svo_deg / kLargestDeg; }
};

void drawGrid(QPainter& painter, const Axes& axes) {
  const QColor text = painter.pen().color();
  QColor line = text;
  line.setAlphaF(0.25);
  for (int deg = 0; deg <= kLargestDeg; deg += kGridDeg) {
    const double y = axes.y(deg);
    painter.setPen(line);
    painter.drawLine(QPointF(axes.area.left(), y), QPointF(axes.area.right(), y));
    painter.setPen(text);
    painter.drawText(QRectF(0, y - 10, axes.area.left() - 4, 20), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(deg));
  }
}

void drawColumns(QPainter& painter, const Axes& axes, const std::vector<float>& svo_deg) {
  for (std::size_t step = 0; step < svo_deg.size(); ++step) {
    const auto deg = static_cast<double>(svo_deg[step]);
    if (std::isfinite(deg)) {
      painter.fillRect(QRectF(QPointF(axes.x(step), axes.y(deg)),
                              QPointF(axes.x(step + 1), axes.area.bottom() + 1)),
                       toQColor(svoColor(deg)));
    }
  }
}

void drawSteps(QPainter& painter, const Axes& axes, const std::vector<float>& svo_deg) {
  QPainterPath path;
  bool is_begun = false;
  for (std::size_t step = 0; step < svo_deg.size(); ++step) {
    const auto deg = static_cast<double>(svo_deg[step]);
    if (std::isfinite(deg)) {
      const QPointF begin(axes.x(step), axes.y(deg));
      is_begun ? path.lineTo(begin) : path.moveTo(begin);
      path.lineTo(axes.x(step + 1), axes.y(deg));
    }
    is_begun = std::isfinite(deg);
  }
  painter.drawPath(path);
}

}  // namespace

SvoChart::SvoChart(QWidget* parent) : QWidget(parent) {
  setFixedHeight(kHeight);
  hide();
}

void SvoChart::setSeries(const std::vector<SvoSeries>& series, std::uint32_t step) {
  series_ = series;
  step_ = step;
  setVisible(!series_.empty());
  update();
}

void SvoChart::paintEvent(QPaintEvent* /*event*/) {
  if (series_.empty() || series_.front().svo_deg.empty()) {
    return;
  }
  QPainter painter(this);
  const QPen text(palette().color(QPalette::WindowText));
  const QPen dashed(text.color(), 1.5, Qt::DashLine);
  painter.setPen(text);
  const int line_px = painter.fontMetrics().height();
  const int left_px = painter.fontMetrics().horizontalAdvance("45") + 6;
  const SvoSeries& own = series_.front();
  const Axes axes{QRectF(left_px, line_px + 2 * kMargin, width() - left_px - kMargin,
                         height() - 2 * line_px - 3 * kMargin),
                  own.svo_deg.size()};
  drawColumns(painter, axes, own.svo_deg);
  drawGrid(painter, axes);
  QString title = "SVO [deg] of " + QString::fromStdString(own.robot);
  if (series_.size() > 1) {
    painter.setPen(dashed);
    drawSteps(painter, axes, series_[1].svo_deg);
    title += ", dashed: of its partner " + QString::fromStdString(series_[1].robot);
  }
  painter.setPen(text);
  painter.drawText(QRectF(kMargin, kMargin, width(), line_px), Qt::AlignLeft, title);
  const double now = axes.x(std::min<std::size_t>(step_, axes.steps));
  painter.setPen(QPen(text.color(), 2));
  painter.drawLine(QPointF(now, axes.area.top()), QPointF(now, axes.area.bottom()));
  painter.setPen(text);
  const QString where = QString("step %1 of %2").arg(step_).arg(axes.steps);
  const double half_px = 0.5 * painter.fontMetrics().horizontalAdvance(where) + 1;
  const double middle = std::clamp(now, half_px, std::max(half_px, width() - half_px));
  painter.drawText(QRectF(middle - half_px, axes.area.bottom() + kMargin, 2 * half_px, line_px),
                   Qt::AlignCenter, where);
}

}  // namespace sylph_rviz
