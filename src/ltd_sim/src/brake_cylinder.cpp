#include "ltd_sim/brake_cylinder.hpp"

#include <algorithm>
#include <string>

#include "ltd_sim/driver_command.hpp"

namespace ltd {

namespace {

constexpr double kFilledShare = 0.95;                  // UIC 540: a cylinder counts as filled
constexpr double kReleased_Pa = 0.4 * kPascalsPerBar;  // UIC 540: a cylinder counts as released

/// UIC 540's ranges of fill and release times.
struct Position {
  double fill_low_s, fill_high_s, release_low_s, release_high_s;
};
constexpr Position kGoods{18.0, 30.0, 45.0, 60.0};
constexpr Position kPassenger{3.0, 5.0, 15.0, 20.0};
constexpr Position kOther{0.1, 120.0, 0.1, 300.0};  // chosen: wider than any air brake

}  // namespace

BrakeCylinder::BrakeCylinder(const Parameters& p)
    : full_Pa_(p.full_Pa),
      fill_Pa_per_s_(kFilledShare * p.full_Pa / p.fill_time_s),
      emergency_fill_Pa_per_s_(kFilledShare * p.full_Pa / p.emergency_fill_time_s),
      release_Pa_per_s_((p.full_Pa - kReleased_Pa) / p.release_time_s) {}

BrakeCylinder BrakeCylinder::read(rail::YamlReader reader) {
  Parameters p;
  const std::string name = reader.choice("position", {"G", "P", "other"});
  const Position& position = name == "G" ? kGoods : name == "P" ? kPassenger : kOther;
  // From 1 bar, so that it is above the released pressure; to 7 bar, chosen: pascals given for bars are noticed.
  p.full_Pa = kPascalsPerBar * reader.number("full_bar", rail::between(1.0, 7.0));
  p.fill_time_s = reader.number("fill_time_s", rail::between(position.fill_low_s, position.fill_high_s));
  p.emergency_fill_time_s =
      reader.number("emergency_fill_time_s", rail::between(position.fill_low_s, position.fill_high_s));
  p.release_time_s = reader.number("release_time_s", rail::between(position.release_low_s, position.release_high_s));
  if (p.emergency_fill_time_s > p.fill_time_s)
    reader.refuse("emergency_fill_time_s", "must not be longer than fill_time_s");
  reader.finish();
  return BrakeCylinder(p);
}

double BrakeCylinder::next(double pressure_Pa, double asked_Pa, bool emergency, double step_s) const {
  if (asked_Pa > pressure_Pa)
    return std::min(asked_Pa, pressure_Pa + step_s * (emergency ? emergency_fill_Pa_per_s_ : fill_Pa_per_s_));
  return std::max(asked_Pa, pressure_Pa - step_s * release_Pa_per_s_);
}

}  // namespace ltd
