#include "settings_dialog.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>

namespace viz {

SettingsDialog::SettingsDialog(const PlotSettings& settings, QWidget* parent) : QDialog(parent), before_(settings) {
  setWindowTitle("Plot panel");
  auto* form = new QFormLayout(this);
  const auto addLine = [form](const QString& label, const std::string& value, const QString& tip) {
    auto* line = new QLineEdit(QString::fromStdString(value));
    line->setMinimumWidth(280);
    line->setToolTip(tip);
    form->addRow(label, line);
    return line;
  };
  state_ = addLine("State", settings.state_topic, "train_msgs/TrainState");
  energy_ = addLine("Energy", settings.energy_topic, "train_msgs/TrainEnergy");
  adhesion_ =
      addLine("Adhesion", settings.adhesion_topic, "train_msgs/Adhesion; {} stands for the locomotive's number");
  configuration_ = addLine("Configuration", settings.configuration_topic, "train_msgs/RunConfiguration");
  locomotive_ =
      addLine("Chosen locomotive", settings.locomotive_topic,
              "std_msgs/Int32: the locomotive that all who look have chosen; empty: this panel chooses alone");
  choice_ = addLine("Choose it by", settings.choice_topic,
                    "std_msgs/Int32: where this panel's choice is sent; empty: it is not");
  export_ = addLine("Export to", settings.export_topic,
                    "std_msgs/String: a folder's name has all plots written into it; empty: off");
  for (const PlotKind kind : allPlots()) {
    auto* box = new QCheckBox(QString::fromStdString(titleOf(kind)));
    for (const PlotKind wanted : settings.plots) box->setChecked(box->isChecked() || wanted == kind);
    form->addRow(plots_.empty() ? "Plots" : "", box);
    plots_[kind] = box;
  }
  grid_ = new QCheckBox("all at once");
  grid_->setChecked(settings.grid);
  form->addRow("Show", grid_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

PlotSettings SettingsDialog::settings() const {
  PlotSettings settings = before_;
  settings.state_topic = state_->text().trimmed().toStdString();
  settings.energy_topic = energy_->text().trimmed().toStdString();
  settings.adhesion_topic = adhesion_->text().trimmed().toStdString();
  settings.configuration_topic = configuration_->text().trimmed().toStdString();
  settings.locomotive_topic = locomotive_->text().trimmed().toStdString();
  settings.choice_topic = choice_->text().trimmed().toStdString();
  settings.export_topic = export_->text().trimmed().toStdString();
  settings.grid = grid_->isChecked();
  settings.plots.clear();
  for (const PlotKind kind : allPlots())
    if (plots_.at(kind)->isChecked()) settings.plots.push_back(kind);
  return settings;
}

}  // namespace viz
