#include "plot_sheet.hpp"

#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_legenditem.h>
#include <qwt_plot_renderer.h>
#include <qwt_plot_textlabel.h>
#include <qwt_symbol.h>

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPen>
#include <algorithm>

#include "../plots/legend_corner.hpp"

namespace viz {

namespace {

constexpr int kPngWidth = 1200, kPngHeight = 750;   // chosen: a page's width with readable letters
constexpr int kTextPoints = 10, kLegendPoints = 9;  // chosen: readable at 1280 x 800
constexpr int kLowSheet = 230, kLowPoints = 8,
              kTitleLine = 20;           // below that height the longest axis title would be cut
constexpr int kPixelsANumber = 90;       // chosen: between numbers at an axis
constexpr int kLegendRows = 4;           // chosen: more in two columns
constexpr double kBehind = 15.0;         // between Qwt's grid, 10, and its curves, 20
constexpr double kLeastRightAxis = 8.0;  // chosen: notches, of which there are mostly eight

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

/// With the remark below it if there are curves, which it would lie on.
QwtText titleOf(const PlotData& plot) {
  QwtText title = textOf(plot.title, kTextPoints, true);
  if (!plot.remark.empty() && !plot.empty()) {
    const auto escaped = [](const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); };
    const QString text =
        QString("<b>%1</b><br><font color=\"#777777\">%2</font>").arg(escaped(plot.title), escaped(plot.remark));
    title.setText(text, QwtText::RichText);
    QFont font = title.font();
    font.setBold(false);
    title.setFont(font);
  }
  title.setRenderFlags(Qt::AlignHCenter | Qt::TextWordWrap);
  return title;
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

/// Curves that differ in nothing but points need no new items.
bool alike(const PlotData& a, const PlotData& b) {
  return std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
                    [](const Curve& x, const Curve& y) {
                      return x.name == y.name && x.style == y.style && x.colour == y.colour && x.width == y.width &&
                             x.right_axis == y.right_axis && x.in_legend == y.in_legend;
                    });
}

QPen penOf(const Curve& curve) {
  QPen pen(colourOf(curve.colour), curve.width);
  if (curve.style == CurveStyle::kDashes) pen.setDashPattern({4.0, 3.0});
  if (curve.style == CurveStyle::kBackground) pen.setColor(QColor(0xBB, 0xBB, 0xBB));
  if (curve.style == CurveStyle::kBars) pen.setCapStyle(Qt::FlatCap);
  if (curve.style == CurveStyle::kDots) {
    QColor pale = pen.color();
    pale.setAlpha(150);
    pen.setColor(pale);
  }
  return pen;
}

QwtPlotCurve* newItem(const Curve& curve) {
  auto* item = new QwtPlotCurve(textOf(curve.name, kLegendPoints, false));
  item->setItemAttribute(QwtPlotItem::Legend, curve.in_legend);
  item->setYAxis(curve.right_axis ? QwtPlot::yRight : QwtPlot::yLeft);
  item->setPen(penOf(curve));
  item->setPaintAttribute(QwtPlotCurve::FilterPoints);  // no pixel twice: wide lines are slow
  item->setLegendAttribute(QwtPlotCurve::LegendShowLine, true);
  if (curve.style == CurveStyle::kBackground) item->setZ(kBehind);
  if (curve.style == CurveStyle::kDots) item->setStyle(QwtPlotCurve::Dots);
  if (curve.style == CurveStyle::kBars) item->setStyle(QwtPlotCurve::Sticks);
  if (curve.style == CurveStyle::kMarks) {
    item->setStyle(QwtPlotCurve::NoCurve);
    item->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, colourOf(curve.colour), QPen(Qt::black, 1.0), QSize(9, 9)));
    item->setLegendAttribute(QwtPlotCurve::LegendShowLine, false);
    item->setLegendAttribute(QwtPlotCurve::LegendShowSymbol, true);
  }
  return item;
}

Qt::Alignment alignmentOf(LegendCorner corner) {
  switch (corner) {
    case LegendCorner::kTopLeft:
      return Qt::AlignLeft | Qt::AlignTop;
    case LegendCorner::kTopRight:
      return Qt::AlignRight | Qt::AlignTop;
    case LegendCorner::kBottomLeft:
      return Qt::AlignLeft | Qt::AlignBottom;
    case LegendCorner::kBottomRight:
      break;
  }
  return Qt::AlignRight | Qt::AlignBottom;
}

}  // namespace

PlotSheet::PlotSheet(QWidget* parent) : QwtPlot(parent), remark_(new QwtPlotTextLabel), legend_(new QwtPlotLegendItem) {
  setCanvasBackground(Qt::white);
  plotLayout()->setAlignCanvasToScales(true);
  QFont font;
  font.setPointSize(kTextPoints);
  for (const int axis : {xBottom, yLeft, yRight}) setAxisFont(axis, font);
  auto* grid = new QwtPlotGrid;
  grid->setPen(QColor(0xDD, 0xDD, 0xDD), 0.0, Qt::SolidLine);
  grid->attach(this);
  legend_->setRenderHint(QwtPlotItem::RenderAntialiased);
  legend_->setBackgroundBrush(QColor(255, 255, 255, 200));
  legend_->setBackgroundMode(QwtPlotLegendItem::LegendBackground);
  legend_->setMaxColumns(1);
  legend_->setMargin(2);
  legend_->setItemMargin(1);
  legend_->setSpacing(0);
  legend_->attach(this);
  remark_->attach(this);
  setMinimumSize(240, 150);
}

void PlotSheet::makeItems() {
  for (QwtPlotCurve* item : items_) delete item;  // which detaches it
  items_.clear();
  int named = 0;
  for (const Curve& curve : shown_.curves) {
    items_.push_back(newItem(curve));
    items_.back()->attach(this);
    if (curve.in_legend) ++named;
  }
  legend_->setMaxColumns(named > kLegendRows ? 2 : 1);
}

void PlotSheet::show(const PlotData& plot) {
  const bool same_items = alike(shown_, plot);
  shown_ = plot;
  if (!same_items) makeItems();
  legend_->setAlignment(alignmentOf(emptiestCorner(plot)));
  setTitle(titleOf(plot));
  enableAxis(yRight, !plot.right_title.empty());
  for (std::size_t i = 0; i < items_.size(); ++i) items_[i]->setSamples(pointsOf(plot.curves[i]));
  scaleAxes(size());
  QwtText remark = textOf(plot.empty() ? plot.remark : "", kTextPoints, false);
  remark.setColor(Qt::darkGray);
  remark.setRenderFlags(Qt::TextWordWrap | Qt::AlignCenter);
  remark_->setText(remark);
  replot();
}

/// Titles that fit, a margin around the points, and no more numbers at the axes than there is room for.
void PlotSheet::scaleAxes(const QSize& size) {
  const bool two_lines = !shown_.remark.empty() && !shown_.empty();  // of the title
  const int points = size.height() < kLowSheet + (two_lines ? kTitleLine : 0) ? kLowPoints : kTextPoints;
  setAxisTitle(xBottom, textOf(shown_.x_title, points, false));
  setAxisTitle(yLeft, textOf(shown_.y_title, points, false));
  setAxisTitle(yRight, textOf(shown_.right_title, points, false));
  for (const int axis : {xBottom, yLeft, yRight}) {
    const bool along = axis == xBottom;
    Bounds bounds = boundsOf(axis, shown_);
    const double least = along ? shown_.least_x_span : axis == yRight ? kLeastRightAxis : shown_.least_y_span;
    if (bounds.high - bounds.low < least) bounds.high = bounds.low + least;
    const double margin = (along ? 0.015 : axis == yRight ? 0.15 : 0.05) * (bounds.high - bounds.low);
    if (along || bounds.low < 0.0) bounds.low -= margin;
    if (along || bounds.high > 0.0) bounds.high += margin;
    setAxisMaxMajor(axis,
                    std::clamp(along ? size.width() / kPixelsANumber : 2 * size.height() / kPixelsANumber, 2, 10));
    setAxisScale(axis, bounds.low, bounds.high);
  }
}

void PlotSheet::resizeEvent(QResizeEvent* event) {
  QwtPlot::resizeEvent(event);
  scaleAxes(size());
  replot();
}

QString PlotSheet::writePng(const QString& path) {
  QImage image(kPngWidth, kPngHeight, QImage::Format_RGB32);
  image.fill(Qt::white);
  scaleAxes(image.size());
  updateAxes();
  QPainter painter(&image);
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
  renderer.render(this, &painter, QRectF(10, 10, kPngWidth - 20, kPngHeight - 20));
  painter.end();
  scaleAxes(size());
  replot();
  return image.save(path, "PNG") ? QString() : "cannot write " + path;
}

QString PlotSheet::writeCsv(const QString& path) const {
  QFile file(path);
  const QByteArray text = QByteArray::fromStdString(toCsv(shown_));
  const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.flush();
  return written ? QString() : "cannot write " + path + ": " + file.errorString();
}

}  // namespace viz
