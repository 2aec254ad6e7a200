#include "plot_sheet.hpp"

#include <qwt_legend.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_renderer.h>
#include <qwt_plot_textlabel.h>
#include <qwt_scale_engine.h>
#include <qwt_symbol.h>

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPen>
#include <algorithm>
#include <cmath>

namespace viz {

namespace {

constexpr int kPngWidth = 1200, kPngHeight = 750;        // chosen: a page's width with readable letters
constexpr int kTitlePoints = 11, kTextPoints = 10;       // chosen: readable at 1600 x 900
constexpr double kLeastRightAxis = 8.0;                  // chosen: notches, of which there are mostly eight

/// Okabe and Ito's colours, which colour-blind people tell apart; the black one last.
QColor colourOf(int number) {
  static const QColor colours[] = {QColor(0x00, 0x72, 0xB2), QColor(0xD5, 0x5E, 0x00), QColor(0x00, 0x9E, 0x73),
                                   QColor(0xCC, 0x79, 0xA7), QColor(0xE6, 0x9F, 0x00), QColor(0x56, 0xB4, 0xE9),
                                   QColor(0x00, 0x00, 0x00)};
  constexpr int kColours = sizeof colours / sizeof colours[0];
  return colours[((number % kColours) + kColours) % kColours];
}

QwtText textOf(const std::string& text, int points, bool bold) {
  QwtText label(QString::fromStdString(text), QwtText::PlainText);
  QFont font;
  font.setPointSize(points);
  font.setBold(bold);
  label.setFont(font);
  return label;
}

QVector<QPointF> pointsOf(const Curve& curve) {
  QVector<QPointF> points;
  points.reserve(static_cast<int>(2 * curve.points.size()));
  for (const Point& point : curve.points) {
    if (curve.style == CurveStyle::kSteps && !points.empty()) points.push_back({point.x, points.back().y()});
    points.push_back({point.x, point.y});
  }
  return points;
}

struct Bounds {
  double low = 0.0, high = 0.0;
};

Bounds boundsOf(int axis, const PlotData& plot) {
  const bool along = axis == QwtPlot::xBottom, right = axis == QwtPlot::yRight;
  Bounds bounds;
  bool first = along;  // 0 belongs to the axes of values
  for (const Curve& curve : plot.curves) {
    if (!along && curve.right_axis != right) continue;
    for (const Point& point : curve.points) {
      const double value = along ? point.x : point.y;
      bounds.low = first ? value : std::min(bounds.low, value);
      bounds.high = first ? value : std::max(bounds.high, value);
      first = false;
    }
  }
  return bounds;
}

}  // namespace

PlotSheet::PlotSheet(QWidget* parent) : QwtPlot(parent), remark_(new QwtPlotTextLabel) {
  setCanvasBackground(Qt::white);
  plotLayout()->setAlignCanvasToScales(true);
  QFont font;
  font.setPointSize(kTextPoints);
  for (const int axis : {xBottom, yLeft, yRight}) setAxisFont(axis, font);
  auto* grid = new QwtPlotGrid;
  grid->setPen(QColor(0xDD, 0xDD, 0xDD), 0.0, Qt::SolidLine);
  grid->attach(this);
  auto* legend = new QwtLegend;
  legend->setFont(font);
  insertLegend(legend, BottomLegend);
  remark_->attach(this);
  setMinimumSize(260, 200);
}

void PlotSheet::show(const PlotData& plot) {
  shown_ = plot;
  setTitle(textOf(plot.title, kTitlePoints, true));
  setAxisTitle(xBottom, textOf(plot.x_title, kTextPoints, false));
  setAxisTitle(yLeft, textOf(plot.y_title, kTextPoints, false));
  enableAxis(yRight, !plot.right_title.empty());
  setAxisTitle(yRight, textOf(plot.right_title, kTextPoints, false));
  while (items_.size() > plot.curves.size()) {
    delete items_.back();  // which detaches it
    items_.pop_back();
  }
  while (items_.size() < plot.curves.size()) {
    items_.push_back(new QwtPlotCurve);
    items_.back()->attach(this);
  }
  for (std::size_t i = 0; i < items_.size(); ++i) setCurve(*items_[i], plot.curves[i]);
  for (const int axis : {xBottom, yLeft, yRight}) scaleAxis(axis, plot);
  QwtText remark = textOf(plot.remark, kTextPoints, false);
  remark.setColor(Qt::darkGray);
  remark.setRenderFlags(plot.empty() ? Qt::AlignCenter : Qt::AlignLeft | Qt::AlignTop);
  remark_->setText(remark);
  replot();
}

void PlotSheet::setCurve(QwtPlotCurve& item, const Curve& curve) {
  const QColor colour = colourOf(curve.colour);
  item.setTitle(textOf(curve.name, kTextPoints, false));
  item.setYAxis(curve.right_axis ? yRight : yLeft);
  item.setItemAttribute(QwtPlotItem::Legend, curve.in_legend);
  item.setLegendAttribute(QwtPlotCurve::LegendShowLine, true);
  item.setSymbol(nullptr);
  item.setStyle(QwtPlotCurve::Lines);
  QPen pen(colour, 2.0);
  switch (curve.style) {
    case CurveStyle::kLine:
    case CurveStyle::kSteps:
      break;
    case CurveStyle::kDashes:
      pen.setDashPattern({4.0, 3.0});
      break;
    case CurveStyle::kBackground:
      pen = QPen(QColor(0xA0, 0xA0, 0xA0), 4.0);
      break;
    case CurveStyle::kDots:
      pen.setColor(QColor(colour.red(), colour.green(), colour.blue(), 90));
      item.setStyle(QwtPlotCurve::Dots);
      break;
    case CurveStyle::kMarks:
      item.setStyle(QwtPlotCurve::NoCurve);
      item.setSymbol(new QwtSymbol(QwtSymbol::Ellipse, colour, QPen(Qt::black, 1.0), QSize(10, 10)));
      item.setLegendAttribute(QwtPlotCurve::LegendShowLine, false);
      item.setLegendAttribute(QwtPlotCurve::LegendShowSymbol, true);
      break;
    case CurveStyle::kBars:
      pen.setWidthF(3.0);
      pen.setCapStyle(Qt::FlatCap);
      item.setStyle(QwtPlotCurve::Sticks);
      break;
  }
  item.setPen(pen);
  item.setSamples(pointsOf(curve));
}

void PlotSheet::scaleAxis(int axis, const PlotData& plot) {
  Bounds bounds = boundsOf(axis, plot);
  const double least = axis == xBottom ? plot.least_x_span : axis == yRight ? kLeastRightAxis : plot.least_y_span;
  if (bounds.high - bounds.low < least) bounds.high = bounds.low + least;
  double step = 0.0;
  QwtLinearScaleEngine().autoScale(8, bounds.low, bounds.high, step);
  setAxisScale(axis, bounds.low, bounds.high, step);
}

QString PlotSheet::writePng(const QString& path) {
  QImage image(kPngWidth, kPngHeight, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
  renderer.render(this, &painter, QRectF(10, 10, kPngWidth - 20, kPngHeight - 20));
  painter.end();
  return image.save(path, "PNG") ? QString() : "cannot write " + path;
}

QString PlotSheet::writeCsv(const QString& path) const {
  QFile file(path);
  const QByteArray text = QByteArray::fromStdString(toCsv(shown_));
  const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.flush();
  return written ? QString() : "cannot write " + path + ": " + file.errorString();
}

}  // namespace viz
