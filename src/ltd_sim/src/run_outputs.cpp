#include "ltd_sim/run_outputs.hpp"

#include <yaml-cpp/yaml.h>

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "ltd_sim/coupler_writer.hpp"
#include "ltd_sim/csv_file.hpp"
#include "ltd_sim/section_writer.hpp"
#include "ltd_sim/summary_writer.hpp"
#include "ltd_sim/timeseries_writer.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

void writeText(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

RunOutputs::RunOutputs(const Scenario& scenario, const std::string& folder) : scenario_(scenario), folder_(folder) {
  makeDirectories(folder);
  removeOutputs(folder);
  writeText(folder + "/scenario.resolved.yaml", scenario.document.text());
  writers_.push_back(std::make_unique<SummaryWriter>(scenario, folder + "/summary.csv"));
  writers_.push_back(std::make_unique<TimeseriesWriter>(scenario, folder + "/timeseries.csv"));
  writers_.push_back(std::make_unique<SectionWriter>(scenario, folder + "/energy_sections.csv"));
  writers_.push_back(std::make_unique<CouplerWriter>(scenario, folder + "/couplers.csv"));
}

void removeOutputs(const std::string& folder) {
  for (const char* name : {"outcome.yaml", "outcome.before.yaml", "scenario.resolved.yaml", "summary.csv",
                           "timeseries.csv", "energy_sections.csv", "couplers.csv"})
    std::remove((folder + "/" + name).c_str());
}

void writeRefusal(const std::string& folder, Outcome::Kind kind, const std::string& reason) {
  makeDirectories(folder);
  std::rename((folder + "/outcome.yaml").c_str(), (folder + "/outcome.before.yaml").c_str());
  Outcome outcome;
  outcome.kind = kind;
  outcome.reason = reason;
  writeOutcome(folder, outcome, 0.0, 0.0, 0);
}

void RunOutputs::onStart(const TrainState& state) {
  for (const auto& writer : writers_) writer->onStart(state);
}

void RunOutputs::onStep(const StepRecord& record) {
  for (const auto& writer : writers_) writer->onStep(record);
}

void RunOutputs::onEnd(const TrainState& state, const Outcome& outcome) {
  Outcome told = outcome;
  for (const auto& writer : writers_) {
    try {
      writer->onEnd(state, outcome);
    } catch (const std::exception& error) {
      told.kind = Outcome::Kind::kFailed;
      told.reason = error.what();
    }
  }
  writeOutcome(folder_, told, static_cast<double>(state.step) * rail::toSeconds(scenario_.macro_step),
               state.s_m[scenario_.train.locomotives.front().vehicle] / rail::kMetresPerKilometre, state.step);
  if (told.kind != outcome.kind) throw std::runtime_error(told.reason);
}

void writeOutcome(const std::string& folder, const Outcome& outcome, double time_s, double location_km,
                  std::uint64_t step) {
  char digest[24];
  std::snprintf(digest, sizeof digest, "%016" PRIx64, outcome.exchange_digest);
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "outcome" << YAML::Value << toString(outcome.kind);
  yaml << YAML::Key << "reason" << YAML::Value << YAML::DoubleQuoted << outcome.reason;
  if (!outcome.notes.empty()) {
    yaml << YAML::Key << "notes" << YAML::Value << YAML::BeginSeq;
    for (const std::string& note : outcome.notes) yaml << YAML::DoubleQuoted << note;
    yaml << YAML::EndSeq;
  }
  yaml << YAML::Key << "step" << YAML::Value << step;
  yaml << YAML::Key << "time_s" << YAML::Value << allDigits(time_s);
  yaml << YAML::Key << "location_km" << YAML::Value << allDigits(location_km);
  yaml << YAML::Key << "exchange_digest" << YAML::Value << YAML::DoubleQuoted << digest;
  yaml << YAML::EndMap;
  const std::string path = folder + "/outcome.yaml";
  writeText(path + ".new", std::string(yaml.c_str()) + "\n");
  if (std::rename((path + ".new").c_str(), path.c_str()) != 0) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace ltd
