#include "panels/plot_board.hpp"

#include <gtest/gtest.h>
#include <qwt_plot_curve.h>

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTemporaryDir>

#include "panels/lock_view.hpp"
#include "panels/messages.hpp"

namespace viz {
namespace {

/// Widgets need an application; on no screen at all.
class PanelViewTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    static int count = 1;
    static char name[] = "plot_board_test";
    static char* arguments[] = {name, nullptr};
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (qApp == nullptr) new QApplication(count, arguments);  // stays until the end
  }
};

train_msgs::TrainState stateAt(int i) {
  train_msgs::TrainState msg;
  msg.header.stamp = ros::Time(1.0 + 0.02 * i);
  msg.location = 3000.0 + i;
  msg.speed = 5.0 + 0.1 * i;
  msg.speed_limit = 22.0;
  msg.notch = {double(i / 20), 8.0};
  msg.brake_notch = {0.0, 0.0};
  msg.traction = {4e3 * i, 3e3 * i};
  msg.coupler_force = {1e3 * i, -5e2 * i};
  return msg;
}

void feed(RunData& run, int count) {
  for (int i = 0; i < count; ++i) {
    run.add(fromMsg(stateAt(i)));
    train_msgs::TrainEnergy energy;
    energy.header.stamp = stateAt(i).header.stamp;
    energy.loco_energy_rail = {1e5 * i, 1e5 * i};
    energy.loco_energy_rim = {1.1e5 * i, 1.1e5 * i};
    energy.loco_recovered_rim = {0.0, 0.0};
    run.add(fromMsg(energy));
    train_msgs::Adhesion adhesion;
    adhesion.header.stamp = energy.header.stamp;
    adhesion.speed = 5.0;
    adhesion.axles.resize(6);
    for (std::size_t axle = 0; axle < 6; ++axle) {
      adhesion.axles[axle].creep = 1e-4 * i;
      adhesion.axles[axle].adhesion = 1e-3 * i;
      adhesion.axles[axle].normal_force = 219e3;
    }
    run.add(fromMsg(adhesion));
  }
}

std::size_t pointsDrawn(const PlotSheet& sheet) {
  std::size_t points = 0;
  for (const QwtPlotItem* item : sheet.itemList(QwtPlotItem::Rtti_PlotCurve))
    points += static_cast<const QwtPlotCurve*>(item)->dataSize();
  return points;
}

/// Pixels that are neither white nor grey.
int colouredPixels(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor colour = image.pixelColor(x, y);
      if (colour.saturation() > 100) ++count;
    }
  }
  return count;
}

TEST_F(PanelViewTest, MessagesBecomeCurvesInEveryPlot) {
  PlotBoard board;
  PlotSettings settings;
  settings.grid = true;
  board.setSettings(settings);
  board.resize(1200, 800);
  board.show();
  feed(board.data(), 100);
  board.refresh();
  EXPECT_EQ(pointsDrawn(*board.sheet(PlotKind::kTraction)), 200u);
  EXPECT_EQ(pointsDrawn(*board.sheet(PlotKind::kEnergy)), 300u);
  EXPECT_EQ(pointsDrawn(*board.sheet(PlotKind::kAdhesion)), 606u);
  EXPECT_EQ(pointsDrawn(*board.sheet(PlotKind::kCouplers)), 6u);
  EXPECT_GT(pointsDrawn(*board.sheet(PlotKind::kSpeed)), 400u);
  for (const PlotKind kind : allPlots())
    EXPECT_GT(colouredPixels(board.sheet(kind)->grab().toImage()), 150) << nameOf(kind);
}

TEST_F(PanelViewTest, OnlyTheTabThatIsSeenIsDrawn) {
  PlotBoard board;
  board.resize(800, 600);
  board.show();
  feed(board.data(), 10);
  board.refresh();
  EXPECT_EQ(pointsDrawn(*board.sheet(PlotKind::kTraction)), 20u);
  EXPECT_EQ(pointsDrawn(*board.sheet(PlotKind::kEnergy)), 0u);
  board.findChild<QTabWidget*>()->setCurrentIndex(1);
  board.refresh();
  EXPECT_EQ(pointsDrawn(*board.sheet(PlotKind::kEnergy)), 30u);
}

TEST_F(PanelViewTest, ANewRunClearsThePicture) {
  PlotBoard board;
  board.show();
  feed(board.data(), 50);
  board.refresh();
  feed(board.data(), 3);
  board.refresh();
  EXPECT_EQ(pointsDrawn(*board.sheet(PlotKind::kTraction)), 6u);
}

TEST_F(PanelViewTest, ExportWritesPicturesAndTablesOfAllPlots) {
  const QTemporaryDir folder;
  PlotBoard board;  // never shown: what no one looks at is exported all the same
  feed(board.data(), 100);
  ASSERT_EQ(board.exportAll(folder.filePath("run/plots")), QString());
  for (const PlotKind kind : allPlots()) {
    const QString path = folder.filePath("run/plots/") + QString::fromStdString(nameOf(kind));
    const QImage image(path + ".png");
    EXPECT_EQ(image.width(), 1200) << nameOf(kind);
    EXPECT_GT(colouredPixels(image), 500) << nameOf(kind);
    QFile csv(path + ".csv");
    ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
    EXPECT_EQ(csv.readAll().toStdString(), toCsv(computePlot(kind, board.data())));
  }
}

TEST_F(PanelViewTest, ExportSaysWhatItCannotWrite) {
  PlotBoard board;
  EXPECT_NE(board.exportAll("/proc/no/such/folder"), QString());
  PlotSheet sheet;
  EXPECT_NE(sheet.writePng("/proc/no.png"), QString());
  EXPECT_NE(sheet.writeCsv("/proc/no.csv"), QString());
}

TEST_F(PanelViewTest, SettingsDecideOnPlots) {
  PlotBoard board;
  PlotSettings settings;
  settings.plots = {PlotKind::kSpeed};
  board.setSettings(settings);
  EXPECT_NE(board.sheet(PlotKind::kSpeed), nullptr);
  EXPECT_EQ(board.sheet(PlotKind::kTraction), nullptr);
}

TEST_F(PanelViewTest, ALocomotiveChosenElsewhereIsShownOneChosenHereIsTold) {
  PlotBoard board;
  int told = 0;
  QObject::connect(&board, &PlotBoard::settingsChanged, [&told] { ++told; });
  auto* number = board.findChild<QSpinBox*>("locomotive");
  board.setLocomotive(2);
  EXPECT_EQ(number->value(), 2);
  EXPECT_EQ(board.data().locomotive(), 2);
  EXPECT_EQ(told, 0) << "an echo would never end";
  number->setValue(3);
  EXPECT_EQ(told, 1);
  EXPECT_EQ(board.settings().locomotive, 3);
  EXPECT_EQ(adhesionTopicOf(board.settings()), "/loco_3/adhesion");
}

TEST_F(PanelViewTest, LockButtonsFollowTheTrain) {
  LockView view;
  const auto enabled = [&view](const char* name) { return view.findChild<QPushButton*>(name)->isEnabled(); };
  for (const char* name : {"hold", "run", "step", "to_place", "to_time", "set_pace", "stop"})
    EXPECT_FALSE(enabled(name)) << name;
  EXPECT_EQ(view.findChild<QLabel*>("reason")->text(), kNoTrain);
  TrainStatus status;
  status.phase = TrainStatus::Phase::kHeld;
  status.place_m = 3456.0;
  status.reason = "reached 3.456 km";
  status.notes = {"loco_2 came late"};
  view.show(status);
  EXPECT_FALSE(enabled("hold"));
  for (const char* name : {"run", "step", "to_place", "to_time", "set_pace", "stop"})
    EXPECT_TRUE(enabled(name)) << name;
  EXPECT_EQ(view.findChild<QLabel*>("reason")->text(), "reached 3.456 km");
  view.setBusy(true);
  EXPECT_FALSE(enabled("run"));
}

TEST_F(PanelViewTest, LockButtonsAskForWhatTheySay) {
  LockView view;
  TrainStatus status;
  status.phase = TrainStatus::Phase::kHeld;
  status.place_m = 3456.0;
  view.show(status);
  QStringList asked;
  QObject::connect(&view, &LockView::requested, [&asked](const QString& command, double value) {
    asked << QString("%1 %2").arg(command).arg(value);
  });
  for (const char* name : {"run", "step", "to_place", "set_pace"}) view.findChild<QPushButton*>(name)->click();
  EXPECT_EQ(asked, (QStringList{"RUN 0", "STEP 1", "RUN_UNTIL_PLACE 3.6", "PACE 0"}));
  view.findChild<QPushButton*>("stop")->click();
  EXPECT_EQ(asked.size(), 4) << "STOP must be confirmed first";
}

}  // namespace
}  // namespace viz
