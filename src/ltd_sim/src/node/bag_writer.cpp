#include "bag_writer.hpp"

#include <stdexcept>

#include "conversions.hpp"
#include "ltd_sim/csv_file.hpp"

namespace ltd {

BagWriter::BagWriter(const Scenario& scenario, const std::string& folder, std::uint64_t run_id)
    : scenario_(scenario), run_id_(run_id), frames_(scenario), bag_(std::make_unique<rosbag::Bag>()) {
  const std::string path = folder + "/" + scenario.name + ".bag";
  makeDirectories(folder);
  try {
    bag_->open(path, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path + ": cannot be written: " + error.what());
  }
  bag_->setCompression(rosbag::compression::LZ4);
  for (std::size_t i = 1; i <= scenario.train.locomotives.size(); ++i) {
    force_topics_.push_back("/loco_" + std::to_string(i) + "/force");
    traction_topics_.push_back("/loco_" + std::to_string(i) + "/traction");
    adhesion_topics_.push_back("/loco_" + std::to_string(i) + "/adhesion");
  }
}

BagWriter::~BagWriter() {
  try {
    bag_->close();
  } catch (const std::exception&) {
    // Told already by the write that failed. The bag's own destructor would throw again, which ends the program: leave
    // it.
    static_cast<void>(bag_.release());
  }
}

void BagWriter::onStart(const TrainState& state) {
  bag_->write("/train/configuration", toStamp(0), toMsg(scenario_, run_id_));
  writeTelemetry(state, forcesAtStart(scenario_, state));
}

void BagWriter::onStep(const StepRecord& record) {
  forces_ = &record.forces;
  if (scenario_.output.record_exchange) writeExchange(record);
  const rail::Nanoseconds t = static_cast<rail::Nanoseconds>(record.after.step) * scenario_.macro_step;
  if (t % scenario_.output.timeseries_interval == 0) bag_->write("/tf", toStamp(t), frames_.compute(record));
  if (t % scenario_.output.telemetry_interval != 0) return;
  writeTelemetry(record.after, record.forces);
  writeAdhesion(t, record.answers);
}

void BagWriter::onEnd(const TrainState& state, const Outcome&) {
  if (forces_ != nullptr && toStamp(static_cast<rail::Nanoseconds>(state.step) * scenario_.macro_step) != written_)
    writeTelemetry(state, *forces_);
  bag_->close();
}

void BagWriter::writeTelemetry(const TrainState& state, const TrainForces& forces) {
  toMsg(scenario_, state, forces, state_msg_);
  toMsg(scenario_, state, energy_msg_);
  bag_->write("/train/state", state_msg_.header.stamp, state_msg_);
  bag_->write("/train/energy", energy_msg_.header.stamp, energy_msg_);
  written_ = state_msg_.header.stamp;
}

void BagWriter::writeAdhesion(rail::Nanoseconds t, const std::vector<const loco::LocoTraction*>& answers) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i]->adhesion.axles.empty()) continue;
    toMsg(t, *answers[i], adhesion_msg_);
    bag_->write(adhesion_topics_[i], adhesion_msg_.header.stamp, adhesion_msg_);
  }
}

void BagWriter::writeExchange(const StepRecord& record) {
  const rail::Nanoseconds end = static_cast<rail::Nanoseconds>(record.after.step) * scenario_.macro_step;
  for (std::size_t i = 0; i < record.answers.size(); ++i) {
    loco::ForceMessage force;
    force.id.run_id = run_id_;
    force.id.locomotive = static_cast<std::uint32_t>(i + 1);
    force.force = record.loco_forces[i];
    toMsg(force, force_msg_);
    bag_->write(force_topics_[i], force_msg_.header.stamp, force_msg_);
    toMsg(force.id, *record.answers[i], traction_msg_);
    traction_msg_.header.stamp = toStamp(end);
    traction_msg_.state.clear();
    traction_msg_.axles.clear();
    traction_msg_.contacts.clear();
    bag_->write(traction_topics_[i], traction_msg_.header.stamp, traction_msg_);
  }
}

}  // namespace ltd
