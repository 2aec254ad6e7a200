#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creep_curve.hpp"
#include "decimated_series.hpp"

namespace viz {

// What the plots need of the messages of train_msgs, in SI units and with their signs.
struct TrainSample {
  double time_s = 0.0;  ///< the message's stamp
  double place_m = 0.0, speed_mps = 0.0, speed_limit_mps = 0.0;
  bool sanding = false;
  std::vector<double> notch, brake_notch, traction_N;  ///< per locomotive
  std::vector<double> coupler_N;                       ///< per coupler, > 0 in draft
};
struct EnergySample {
  double time_s = 0.0;
  std::vector<double> rail_J, rim_J, recovered_J;  ///< per locomotive
};
struct AxleSample {
  double creep = 0.0, adhesion = 0.0, normal_N = 0.0;
};
struct AdhesionSample {
  double time_s = 0.0, place_m = 0.0, speed_mps = 0.0;
  std::vector<AxleSample> axles;
};

/// What one locomotive did, over the place of the leading one [m].
struct LocoSeries {
  DecimatedSeries traction_N, notch, brake_notch, rail_J, rim_J, recovered_J;
};

/// Largest draft and buff of a coupler since the start of what was seen.
struct CouplerRange {
  double least_N = 0.0, largest_N = 0.0;
};

/// Everything that the plots show of one run, in bounded memory. A new run starts it afresh: another run id in the
/// configuration, or a train whose time goes back. Knows no ROS and no Qt.
class RunData {
 public:
  void add(const TrainSample& sample);
  /// Energies come without a place: they wait for the train's sample of their time, for as long as memory allows.
  void add(const EnergySample& sample);
  /// Of the chosen locomotive.
  void add(const AdhesionSample& sample);
  /// A run's configuration: its id and the resolved scenario.
  void setRun(std::uint64_t run_id, const std::string& resolved);

  /// Which locomotive the adhesion is of, from 1; another one forgets the adhesion of the old one.
  void setLocomotive(int locomotive);
  int locomotive() const { return locomotive_; }
  /// Forgets all samples; the configuration stays.
  void clear();

  const std::vector<LocoSeries>& locomotives() const { return locomotives_; }
  const DecimatedSeries& speed() const { return speed_; }
  const DecimatedSeries& speedLimit() const { return speed_limit_; }
  const std::optional<TrainSample>& train() const { return train_; }  ///< the newest
  const std::vector<CouplerRange>& couplers() const { return couplers_; }
  const std::vector<DecimatedSeries>& axles() const { return axles_; }  ///< adhesion over creep
  const std::optional<AdhesionSample>& adhesion() const { return adhesion_; }
  const std::optional<CreepCurve>& creepCurve() const { return creep_curve_; }
  /// Why there is no creep curve; empty if there is one.
  const std::string& whyNoCurve() const { return why_no_curve_; }
  /// Counts changes, so that nobody draws what he has drawn already.
  std::uint64_t revision() const { return revision_; }

 private:
  void placeEnergies();
  void book(const EnergySample& sample, double place_m);
  std::optional<double> placeAt(double time_s) const;
  void readCurve();
  void clearAdhesion();

  int locomotive_ = 1;
  std::uint64_t run_id_ = 0;
  bool run_known_ = false;  ///< the samples belong to run_id_
  std::string resolved_;
  std::uint64_t revision_ = 0;
  std::vector<LocoSeries> locomotives_;
  DecimatedSeries speed_, speed_limit_;
  std::optional<TrainSample> train_;
  std::vector<CouplerRange> couplers_;
  std::deque<Point> places_;  ///< place over time of the last samples
  std::deque<EnergySample> waiting_;
  std::vector<DecimatedSeries> axles_;
  std::optional<AdhesionSample> adhesion_;
  std::optional<CreepCurve> creep_curve_;
  std::string why_no_curve_;
};

}  // namespace viz
