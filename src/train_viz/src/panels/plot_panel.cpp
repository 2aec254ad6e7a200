#include "plot_panel.hpp"

#include <QTimer>
#include <QVBoxLayout>

#include "messages.hpp"

namespace viz {

namespace {

// Chosen: at 30 times real time 50 Hz of simulation time are 50 messages a picture of rviz; room for a slow picture.
constexpr int kQueue = 1000;

void readText(const rviz::Config& config, const char* key, std::string& value) {
  QString text;
  if (config.mapGetString(key, &text)) value = text.toStdString();
}

}  // namespace

PlotPanel::PlotPanel(QWidget* parent) : rviz::Panel(parent), board_(new PlotBoard) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(board_);
  connect(board_, &PlotBoard::settingsChanged, this, [this] {
    subscribe();
    tellChoice();
    Q_EMIT configChanged();
  });
}

void PlotPanel::onInitialize() {
  QTimer::singleShot(0, this, [this] { subscribe(); });  // after load(), if there is a layout to load
}

void PlotPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  PlotSettings settings;
  readText(config, "State Topic", settings.state_topic);
  readText(config, "Energy Topic", settings.energy_topic);
  readText(config, "Adhesion Topic", settings.adhesion_topic);
  readText(config, "Configuration Topic", settings.configuration_topic);
  readText(config, "Locomotive Topic", settings.locomotive_topic);
  readText(config, "Choice Topic", settings.choice_topic);
  readText(config, "Export Topic", settings.export_topic);
  config.mapGetInt("Locomotive", &settings.locomotive);
  config.mapGetBool("Grid", &settings.grid);
  std::string names = namesOf(settings.plots), problem;
  readText(config, "Plots", names);
  settings.plots = plotsOf(names, problem);
  if (settings.locomotive < 1) {
    problem = "Locomotive = " + std::to_string(settings.locomotive) + ": must be at least 1, from the head";
    settings.locomotive = 1;
  }
  board_->setSettings(settings);
  known_choice_ = settings.locomotive;  // a layout asks nobody to follow it
  board_->tell(QString::fromStdString(problem));
  if (!problem.empty()) ROS_ERROR("train_viz/PlotPanel: layout: %s", problem.c_str());
  subscribe();
}

void PlotPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  const PlotSettings& settings = board_->settings();
  config.mapSetValue("State Topic", QString::fromStdString(settings.state_topic));
  config.mapSetValue("Energy Topic", QString::fromStdString(settings.energy_topic));
  config.mapSetValue("Adhesion Topic", QString::fromStdString(settings.adhesion_topic));
  config.mapSetValue("Configuration Topic", QString::fromStdString(settings.configuration_topic));
  config.mapSetValue("Locomotive Topic", QString::fromStdString(settings.locomotive_topic));
  config.mapSetValue("Choice Topic", QString::fromStdString(settings.choice_topic));
  config.mapSetValue("Export Topic", QString::fromStdString(settings.export_topic));
  config.mapSetValue("Locomotive", settings.locomotive);
  config.mapSetValue("Grid", settings.grid);
  config.mapSetValue("Plots", QString::fromStdString(namesOf(settings.plots)));
}

void PlotPanel::subscribe() {
  const PlotSettings& settings = board_->settings();
  const auto follow = [this](ros::Subscriber& subscriber, const std::string& topic, auto callback) {
    if (topic.empty()) {
      subscriber.shutdown();
      return;
    }
    try {
      if (subscriber && subscriber.getTopic() == node_.resolveName(topic)) return;
      subscriber.shutdown();
      subscriber = node_.subscribe(topic, kQueue, callback, this, ros::TransportHints().tcpNoDelay());
    } catch (const ros::InvalidNameException& error) {
      board_->tell(error.what());
    }
  };
  follow(configuration_, settings.configuration_topic, &PlotPanel::onConfiguration);
  follow(state_, settings.state_topic, &PlotPanel::onState);
  follow(energy_, settings.energy_topic, &PlotPanel::onEnergy);
  follow(adhesion_, adhesionTopicOf(settings), &PlotPanel::onAdhesion);
  follow(locomotive_, settings.locomotive_topic, &PlotPanel::onLocomotive);
  follow(export_, settings.export_topic, &PlotPanel::onExport);
  advertiseChoice();
}

void PlotPanel::advertiseChoice() {
  const std::string& topic = board_->settings().choice_topic;
  try {
    if (choice_ && !topic.empty() && choice_.getTopic() == node_.resolveName(topic)) return;
    choice_.shutdown();
    if (!topic.empty()) choice_ = node_.advertise<std_msgs::Int32>(topic, 1);
  } catch (const ros::InvalidNameException& error) {
    board_->tell(error.what());
  }
}

/// Asks whoever keeps the choice for the locomotive that the user has set here.
void PlotPanel::tellChoice() {
  const int locomotive = board_->settings().locomotive;
  if (locomotive == known_choice_) return;
  known_choice_ = locomotive;
  if (!choice_) return;
  std_msgs::Int32 msg;
  msg.data = locomotive;
  choice_.publish(msg);
}

void PlotPanel::onState(const train_msgs::TrainState& msg) { board_->data().add(fromMsg(msg)); }

void PlotPanel::onEnergy(const train_msgs::TrainEnergy& msg) { board_->data().add(fromMsg(msg)); }

void PlotPanel::onAdhesion(const train_msgs::Adhesion& msg) { board_->data().add(fromMsg(msg)); }

void PlotPanel::onConfiguration(const train_msgs::RunConfiguration& msg) {
  board_->data().setRun(msg.run_id, msg.resolved);
}

void PlotPanel::onLocomotive(const std_msgs::Int32& msg) {
  if (msg.data < 1) {
    board_->tell(QString("%1: %2: must be at least 1, from the head")
                     .arg(QString::fromStdString(board_->settings().locomotive_topic))
                     .arg(msg.data));
    return;
  }
  known_choice_ = msg.data;
  if (msg.data == board_->settings().locomotive) return;
  board_->setLocomotive(msg.data);
  subscribe();
}

void PlotPanel::onExport(const std_msgs::String& msg) {
  const QString folder = QString::fromStdString(msg.data);
  const QString wrong = board_->exportAll(folder);
  board_->tell(wrong.isEmpty() ? "wrote all plots into " + folder : wrong);
  if (!wrong.isEmpty()) ROS_WARN("train_viz/PlotPanel: %s", qPrintable(wrong));
}

}  // namespace viz
