#pragma once

#include <qwt_plot.h>

#include <QString>
#include <vector>

#include "../plots/plot_data.hpp"

class QwtPlotCurve;
class QwtPlotLegendItem;
class QwtPlotTextLabel;

namespace viz {

/// Draws one PlotData. Axes hold all points and the value 0.
class PlotSheet : public QwtPlot {
 public:
  explicit PlotSheet(QWidget* parent = nullptr);

  /// Shows this instead of what was shown.
  void show(const PlotData& plot);
  const PlotData& shown() const { return shown_; }

  /// Both return what went wrong, empty if nothing did. The picture is 1200 x 750 whatever the size on the screen.
  QString writePng(const QString& path);
  QString writeCsv(const QString& path) const;

 private:
  void resizeEvent(QResizeEvent* event) override;
  void makeItems();
  void scaleAxes(const QSize& size);

  PlotData shown_;
  std::vector<QwtPlotCurve*> items_;  ///< owned by the plot
  QwtPlotTextLabel* remark_;          ///< likewise
  QwtPlotLegendItem* legend_;         ///< likewise
};

}  // namespace viz
