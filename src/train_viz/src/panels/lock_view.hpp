#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <optional>

#include "lock_state.hpp"

class QDoubleSpinBox;
class QLabel;
class QLayout;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace viz {

/// Buttons for the lock and what the train says of itself. Knows no ROS.
class LockView : public QWidget {
  Q_OBJECT

 public:
  explicit LockView(QWidget* parent = nullptr);

  void show(const TrainStatus& status);
  /// A command waits for its answer; its buttons are off meanwhile.
  void setBusy(bool busy);
  /// What became of the last command.
  void tell(const QString& text, bool good);
  /// Looks at the clock: a train that is silent has its buttons off.
  void refresh();

 Q_SIGNALS:
  /// As train_msgs/StepLock names it. STOP has been confirmed.
  void requested(const QString& command, double value);

 private:
  QPushButton* addButton(const QString& name, const QString& text, const QString& tip);
  QLayout* buildStatus();
  QLayout* buildControls();
  void askStop();

  std::optional<TrainStatus> status_;
  QElapsedTimer since_status_;
  bool busy_ = false;
  QLabel *phase_, *reason_, *time_, *place_, *factor_, *left_, *joined_, *answer_;
  QPlainTextEdit* notes_;
  QPushButton *hold_, *run_, *step_, *to_place_, *to_time_, *set_pace_, *stop_;
  QSpinBox* steps_;
  QDoubleSpinBox *place_km_, *time_s_, *pace_;
};

}  // namespace viz
