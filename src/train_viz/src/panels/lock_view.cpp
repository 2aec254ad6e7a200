#include "lock_view.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>

namespace viz {

namespace {

constexpr int kMostSteps = 1000000000;
constexpr double kFarthest_km = 1e5, kLongest_s = 1e7, kFastest = 1e5;  // chosen: beyond any run
constexpr int kNoteLines = 4;

QDoubleSpinBox* spinBox(const QString& name, double low, double high, int decimals, double step, const QString& unit) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(low, high);
  box->setDecimals(decimals);
  box->setSingleStep(step);
  box->setSuffix(unit);
  return box;
}

QLabel* wrappedLabel() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

const char* colourOf(TrainStatus::Phase phase) {
  switch (phase) {
    case TrainStatus::Phase::kRunning:
      return "#006B3C";
    case TrainStatus::Phase::kFailed:
      return "#B00020";
    default:
      return "#1A1A1A";
  }
}

}  // namespace

LockView::LockView(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->addLayout(buildStatus());
  column->addWidget(answer_ = wrappedLabel());  // above the buttons: below them it would be scrolled out of sight
  column->addLayout(buildControls());
  column->addStretch();
  answer_->setObjectName("answer");
  answer_->setMinimumHeight(2 * answer_->fontMetrics().lineSpacing());  // so that buttons do not move when it comes
  refresh();
}

QLayout* LockView::buildStatus() {
  auto* grid = new QGridLayout;
  grid->setVerticalSpacing(2);
  const auto add = [grid](int row, int column, int span, const QString& label, const char* name) {
    QLabel* value = wrappedLabel();
    value->setObjectName(name);
    grid->addWidget(new QLabel(label), row, column, Qt::AlignTop);
    grid->addWidget(value, row, column + 1, 1, span, Qt::AlignTop);
    return value;
  };
  phase_ = add(0, 0, 1, "Train", "phase");
  joined_ = add(0, 2, 1, "Locomotives", "joined");
  reason_ = add(1, 0, 3, "", "reason");
  time_ = add(2, 0, 1, "Time", "time");
  place_ = add(2, 2, 1, "Place", "place");
  factor_ = add(3, 0, 1, "Runs at", "real_time_factor");
  left_ = add(3, 2, 1, "Time left", "time_left");
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  notes_ = new QPlainTextEdit;
  notes_->setObjectName("notes");
  notes_->setReadOnly(true);
  notes_->setToolTip("What a reader of the results should know");
  notes_->setMaximumHeight(notes_->fontMetrics().lineSpacing() * kNoteLines + 12);
  notes_->hide();  // until there are some
  grid->addWidget(notes_, 4, 0, 1, 4);
  return grid;
}

QPushButton* LockView::addButton(const QString& name, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  return button;
}

QLayout* LockView::buildControls() {
  hold_ = addButton("hold", "Hold", "At the end of the step under way");
  run_ = addButton("run", "Run", "To the scenario's end");
  step_ = addButton("step", "Step", "So many macro steps, then hold");
  to_place_ = addButton("to_place", "Run to place", "Until the leading locomotive is there, then hold");
  to_time_ = addButton("to_time", "Run to time", "Of simulation, since the run's start; then hold");
  set_pace_ = addButton("set_pace", "Set pace", "At most so many times real time; 0: as fast as it goes");
  stop_ = addButton("stop", "Stop ...", "Ends the run in good order; it cannot be resumed");
  steps_ = new QSpinBox;
  steps_->setObjectName("steps");
  steps_->setRange(1, kMostSteps);
  place_km_ = spinBox("place_km", -kFarthest_km, kFarthest_km, 3, 0.1, " km");
  time_s_ = spinBox("time_s", 0.0, kLongest_s, 2, 10.0, " s");
  pace_ = spinBox("pace", 0.0, kFastest, 1, 1.0, " x real time");
  pace_->setSpecialValueText("as fast as it goes");
  auto* grid = new QGridLayout;  // of six columns: three buttons, or a number and its button
  grid->setVerticalSpacing(3);   // a laptop's screen is low
  int column = 0;
  for (QPushButton* button : {hold_, run_, stop_}) grid->addWidget(button, 0, 2 * column++, 1, 2);
  QWidget* const rows[][2] = {{steps_, step_}, {place_km_, to_place_}, {time_s_, to_time_}, {pace_, set_pace_}};
  int row = 1;
  for (const auto& pair : rows) {
    grid->addWidget(pair[0], row, 0, 1, 3);
    grid->addWidget(pair[1], row++, 3, 1, 3);
  }
  connect(hold_, &QPushButton::clicked, this, [this] { Q_EMIT requested("HOLD", 0.0); });
  connect(run_, &QPushButton::clicked, this, [this] { Q_EMIT requested("RUN", 0.0); });
  connect(step_, &QPushButton::clicked, this, [this] { Q_EMIT requested("STEP", steps_->value()); });
  connect(to_place_, &QPushButton::clicked, this, [this] { Q_EMIT requested("RUN_UNTIL_PLACE", place_km_->value()); });
  connect(to_time_, &QPushButton::clicked, this, [this] { Q_EMIT requested("RUN_UNTIL_TIME", time_s_->value()); });
  connect(set_pace_, &QPushButton::clicked, this, [this] { Q_EMIT requested("PACE", pace_->value()); });
  connect(stop_, &QPushButton::clicked, this, &LockView::askStop);
  return grid;
}

void LockView::askStop() {
  auto* box = new QMessageBox(QMessageBox::Question, "Stop the run", "Stop the run? It cannot be resumed.",
                              QMessageBox::Yes | QMessageBox::No, this);
  box->setDefaultButton(QMessageBox::No);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QMessageBox::finished, this, [this](int answer) {
    if (answer == QMessageBox::Yes) Q_EMIT requested("STOP", 0.0);
  });
  box->open();  // returns at once
}

void LockView::show(const TrainStatus& status) {
  if (!status_) {  // something that lies ahead to begin with
    place_km_->setValue(std::ceil(1e-2 * status.place_m + 0.5) / 10.0);
    time_s_->setValue(10.0 * std::ceil(0.1 * status.time_s + 0.5));
  }
  status_ = status;
  since_status_.start();
  const StatusWords words = describe(status);
  time_->setText(QString::fromStdString(words.time));
  place_->setText(QString::fromStdString(words.place));
  factor_->setText(QString::fromStdString(words.real_time_factor));
  left_->setText(QString::fromStdString(words.time_left));
  joined_->setText(QString::fromStdString(words.joined));
  QStringList notes;
  for (const std::string& note : status.notes) notes << QString::fromStdString(note);
  const QString text = notes.join('\n');
  if (text != notes_->toPlainText()) notes_->setPlainText(text);
  notes_->setVisible(!text.isEmpty());
  refresh();
}

void LockView::setBusy(bool busy) {
  busy_ = busy;
  refresh();
}

void LockView::tell(const QString& text, bool good) {
  answer_->setStyleSheet(good ? "" : "color: #B00020");
  answer_->setText(text);
}

void LockView::refresh() {
  const double silence_s = status_ ? 1e-3 * static_cast<double>(since_status_.elapsed()) : 0.0;
  const AllowedCommands allowed = allowedCommands(status_, silence_s, busy_);
  hold_->setEnabled(allowed.hold);
  for (QPushButton* button : {run_, step_, to_place_, to_time_}) button->setEnabled(allowed.run);
  set_pace_->setEnabled(allowed.pace);
  stop_->setEnabled(allowed.stop);
  phase_->setText(QString::fromStdString(phaseWords(status_, silence_s)));
  reason_->setText(QString::fromStdString(status_ ? status_->reason : kNoTrain));
  phase_->setStyleSheet(QString("font-weight: bold; color: %1").arg(status_ ? colourOf(status_->phase) : "#1A1A1A"));
}

}  // namespace viz
