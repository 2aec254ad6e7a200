#pragma once

namespace ltd {

/// How a train's air brake follows the driver's valve, as a driver knows it of his train. The share of full service
/// that presses follows what is asked for after a delay and at a limited rate, the mean over all vehicles:
///   dx/dt = fill or -release, until x = what was asked for `delay` before                              (V9)
/// so a share x that is asked for now is worth as much as one that is there after delay + x/(2 fill).
/// Not modelled: that the head brakes before the tail; that direct-release brakes give less as long as their reservoirs
/// are not full again.
struct BrakeResponse {
  double delay_s = 0.0;
  double fill_per_s = 1.0;  ///< default chosen: as good as at once
  double release_delay_s = 0.0;
  double release_per_s = 1.0;
  double free_from_first_s = 0.0;  ///< from the command to release until the last brake is off, after a first reduction
  double free_from_full_s = 0.0;   ///< likewise, after full service

  /// Until a change of the share from x to y is worth as much as if it were there.
  double equivalentDelay(double from, double to) const {
    return to > from ? delay_s + (to - from) / (2.0 * fill_per_s)
                     : release_delay_s + (from - to) / (2.0 * release_per_s);
  }
};

class AirBrake;
struct TrainModel;

/// Tried out on the train's own brake, each time with full reservoirs: full service from released and back, a first
/// reduction and back. Delay and rate are those of the ramp with the same area and the same slope from 10 to 90 %.
BrakeResponse computeBrakeResponse(const TrainModel& train, const AirBrake& air_brake);

}  // namespace ltd
