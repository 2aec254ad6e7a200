#pragma once

#include <QWidget>
#include <cstdint>
#include <vector>

#include "../plots/run_data.hpp"
#include "plot_settings.hpp"
#include "plot_sheet.hpp"

class QLabel;
class QMenu;
class QSpinBox;
class QTimer;
class QVBoxLayout;

namespace viz {

/// The plots of a run in tabs or all at once, with their controls. Knows no ROS: whoever has the messages puts them
/// into data(); what is seen is drawn at most ten times a second, however often that is.
class PlotBoard : public QWidget {
  Q_OBJECT

 public:
  explicit PlotBoard(QWidget* parent = nullptr);

  RunData& data() { return data_; }
  const PlotSettings& settings() const { return settings_; }
  /// Takes settings over without telling of it.
  void setSettings(const PlotSettings& settings);
  /// Shows another locomotive, without telling of it.
  void setLocomotive(int locomotive);
  /// Says something in the line below the plots.
  void tell(const QString& text);

  /// Draws what has changed and can be seen.
  void refresh();
  /// Writes NAME.png and NAME.csv of every plot shown into a folder that it makes. @return what went wrong, or empty
  QString exportAll(const QString& folder);
  /// Null if it is not shown.
  PlotSheet* sheet(PlotKind kind);

 Q_SIGNALS:
  void settingsChanged();  ///< by the user

 private:
  struct Page {
    PlotKind kind;
    PlotSheet* sheet;
    std::uint64_t drawn;  ///< revision of the data
  };
  void build();
  QWidget* buildTabs();
  QWidget* buildGrid();
  void draw(Page& page);
  void exportOne(PlotKind kind);
  void askExportAll();
  void askSettings();

  RunData data_;
  PlotSettings settings_;
  std::vector<Page> pages_;
  QVBoxLayout* column_;
  QWidget* plots_ = nullptr;  ///< tabs or grid
  QSpinBox* locomotive_;
  QMenu* exports_;
  QLabel* line_;
  QTimer* timer_;
};

}  // namespace viz
