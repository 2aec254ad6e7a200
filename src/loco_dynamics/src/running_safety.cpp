#include "loco_dynamics/running_safety.hpp"

#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace loco {

namespace {

std::string placed(const std::string& wheelset, const char* wheel, double location_m, const char* what) {
  return wheelset + wheel + " at " + rail::fixedNumber(location_m / rail::kMetresPerKilometre, 6) + " km: " + what;
}

}  // namespace

std::string RunningSafety::check(const std::string& wheelset, double location_m, double wheel_radius_m, double pose_z_m,
                                 double h, const WheelsetContact::Contacts& contacts, double* time_in_air_s) const {
  static const char* const kWheels[2] = {", left wheel,", ", right wheel,"};
  if (pose_z_m < -drop_m) return placed(wheelset, ",", location_m, "loss of contact, it fell between the rails");
  std::size_t first = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t count = contacts.of_wheel[side];
    bool loaded = false, climbs = true;
    for (std::size_t i = first; i < first + count; ++i) {
      const WheelsetContact::Contact& c = contacts.list[i];
      if (!(c.normal_N > 0.0)) continue;
      loaded = true;
      climbs = climbs && c.region.rolling_radius_m > wheel_radius_m + climb_rise_m;
    }
    first += count;
    time_in_air_s[side] = loaded ? 0.0 : time_in_air_s[side] + h;
    if (loaded && climbs)
      return placed(wheelset, kWheels[side], location_m, "flange climb, it runs beyond the flange's largest angle");
  }
  const bool up[2] = {time_in_air_s[0] > lift_time_s, time_in_air_s[1] > lift_time_s};
  if (up[0] && up[1]) return placed(wheelset, ",", location_m, "loss of contact, both wheels have left their rails");
  for (std::size_t side = 0; side < 2; ++side)
    if (up[side]) return placed(wheelset, kWheels[side], location_m, "wheel lift, no contact with its rail");
  return {};
}

}  // namespace loco
