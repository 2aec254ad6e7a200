#pragma once

#include <QDialog>
#include <map>

#include "plot_settings.hpp"

class QCheckBox;
class QLineEdit;

namespace viz {

/// Asks for topics and plots. Has no signals of its own: QDialog::accepted() says that settings() hold.
class SettingsDialog : public QDialog {
 public:
  SettingsDialog(const PlotSettings& settings, QWidget* parent);
  PlotSettings settings() const;

 private:
  PlotSettings before_;
  QLineEdit *state_, *energy_, *adhesion_, *configuration_, *locomotive_, *choice_, *export_;
  QCheckBox* grid_;
  std::map<PlotKind, QCheckBox*> plots_;
};

}  // namespace viz
