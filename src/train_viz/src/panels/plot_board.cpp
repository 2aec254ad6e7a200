#include "plot_board.hpp"

#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QSpinBox>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <limits>

#include "settings_dialog.hpp"

namespace viz {

namespace {

constexpr int kRedraw_ms = 100;        // chosen: the eye does not follow figures faster
constexpr int kMostLocomotives = 999;  // of the spin box
constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

}  // namespace

PlotBoard::PlotBoard(QWidget* parent)
    : QWidget(parent),
      column_(new QVBoxLayout(this)),
      locomotive_(new QSpinBox),
      exports_(new QMenu(this)),
      line_(new QLabel),
      timer_(new QTimer(this)) {
  locomotive_->setRange(1, kMostLocomotives);
  locomotive_->setObjectName("locomotive");
  locomotive_->setKeyboardTracking(false);  // "12" is not first 1, then 12
  locomotive_->setToolTip("From the head: of which energy, adhesion and notch are shown");
  auto* export_button = new QToolButton;
  export_button->setText("Export");
  export_button->setMenu(exports_);
  export_button->setPopupMode(QToolButton::InstantPopup);
  auto* settings_button = new QToolButton;
  settings_button->setText("Topics and plots ...");
  auto* bar = new QHBoxLayout;
  bar->addWidget(new QLabel("Locomotive"));
  bar->addWidget(locomotive_);
  bar->addStretch();
  bar->addWidget(export_button);
  bar->addWidget(settings_button);
  line_->setWordWrap(true);
  line_->hide();
  column_->setContentsMargins(2, 2, 2, 2);
  column_->addLayout(bar);
  column_->addWidget(line_);
  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, [this] {
    refresh();
    timer_->start(kRedraw_ms);  // counted from the end, so that a slow screen leaves time for the rest
  });
  connect(locomotive_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int number) {
    settings_.locomotive = number;
    data_.setLocomotive(number);
    Q_EMIT settingsChanged();
  });
  connect(settings_button, &QToolButton::clicked, this, &PlotBoard::askSettings);
  build();
  timer_->start(kRedraw_ms);
}

void PlotBoard::setSettings(const PlotSettings& settings) {
  if (settings.state_topic != settings_.state_topic || settings.energy_topic != settings_.energy_topic) data_.clear();
  settings_ = settings;
  setLocomotive(settings.locomotive);
  build();
}

void PlotBoard::setLocomotive(int locomotive) {
  settings_.locomotive = locomotive;
  data_.setLocomotive(locomotive);
  locomotive_->blockSignals(true);
  locomotive_->setValue(locomotive);
  locomotive_->blockSignals(false);
}

void PlotBoard::build() {
  delete plots_;  // and the sheets in it
  pages_.clear();
  exports_->clear();
  for (const PlotKind kind : settings_.plots) {
    pages_.push_back({kind, new PlotSheet, kNever});
    const QString title = QString::fromStdString(titleOf(kind));
    connect(exports_->addAction(title + " ..."), &QAction::triggered, this, [this, kind] { exportOne(kind); });
  }
  connect(exports_->addAction("All into a folder ..."), &QAction::triggered, this, &PlotBoard::askExportAll);
  plots_ = settings_.grid ? buildGrid() : buildTabs();
  column_->insertWidget(1, plots_, 1);
}

QWidget* PlotBoard::buildTabs() {
  auto* tabs = new QTabWidget;
  for (const Page& page : pages_) tabs->addTab(page.sheet, QString::fromStdString(titleOf(page.kind)));
  connect(tabs, &QTabWidget::currentChanged, this, &PlotBoard::refresh);
  return tabs;
}

QWidget* PlotBoard::buildGrid() {
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 0);
  const int count = static_cast<int>(pages_.size());
  const int columns = count > 1 ? 2 : 1;
  for (int i = 0; i < count; ++i) {
    const bool alone = i == count - 1 && i % columns == 0;  // the last one has its row to itself
    grid->addWidget(pages_[static_cast<std::size_t>(i)].sheet, i / columns, i % columns, 1, alone ? columns : 1);
  }
  return widget;
}

void PlotBoard::draw(Page& page) {
  if (page.drawn == data_.revision()) return;
  page.sheet->show(computePlot(page.kind, data_));
  page.drawn = data_.revision();
}

void PlotBoard::refresh() {
  for (Page& page : pages_)
    if (page.sheet->isVisible()) draw(page);
}

PlotSheet* PlotBoard::sheet(PlotKind kind) {
  for (Page& page : pages_)
    if (page.kind == kind) return page.sheet;
  return nullptr;
}

void PlotBoard::tell(const QString& text) {
  line_->setText(text);
  line_->setVisible(!text.isEmpty());
}

QString PlotBoard::exportAll(const QString& folder) {
  if (!QDir().mkpath(folder)) return "cannot make the folder " + folder;
  for (Page& page : pages_) {
    draw(page);
    const QString path = folder + '/' + QString::fromStdString(nameOf(page.kind));
    QString wrong = page.sheet->writePng(path + ".png");
    if (wrong.isEmpty()) wrong = page.sheet->writeCsv(path + ".csv");
    if (!wrong.isEmpty()) return wrong;
  }
  return QString();
}

void PlotBoard::exportOne(PlotKind kind) {
  QString filter;
  const QString name = QString::fromStdString(nameOf(kind));
  QString path = QFileDialog::getSaveFileName(this, "Export", name, "Picture (*.png);;Table (*.csv)", &filter);
  PlotSheet* plot = sheet(kind);
  if (path.isEmpty() || plot == nullptr) return;
  const QString ending = filter.contains("csv") ? ".csv" : ".png";
  if (!path.endsWith(".png") && !path.endsWith(".csv")) path += ending;
  plot->show(computePlot(kind, data_));
  const QString wrong = path.endsWith(".csv") ? plot->writeCsv(path) : plot->writePng(path);
  tell(wrong.isEmpty() ? "wrote " + path : wrong);
}

void PlotBoard::askExportAll() {
  const QString folder = QFileDialog::getExistingDirectory(this, "Export all plots into");
  if (folder.isEmpty()) return;
  const QString wrong = exportAll(folder);
  tell(wrong.isEmpty() ? "wrote all plots into " + folder : wrong);
}

void PlotBoard::askSettings() {
  auto* dialog = new SettingsDialog(settings_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    setSettings(dialog->settings());
    Q_EMIT settingsChanged();
  });
  dialog->open();  // returns at once
}

}  // namespace viz
