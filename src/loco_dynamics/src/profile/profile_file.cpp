#include "loco_dynamics/profile/profile_file.hpp"

#include "profile_check.hpp"
#include "rail_core/csv_table.hpp"

namespace loco {

ProfilePoints readProfileCsv(ProfileKind kind, const std::string& text, const std::string& file,
                             rail::Problems& problems) {
  constexpr double kMetresPerMillimetre = 1e-3;
  const std::size_t before = problems.count();
  const rail::CsvTable table = rail::readCsv(text, file, {"y_mm", "z_mm"}, problems);
  if (problems.count() != before) return {};
  ProfilePoints points;
  for (const std::vector<double>& row : table.rows) {
    points.push_back({row[0] * kMetresPerMillimetre, row[1] * kMetresPerMillimetre});
  }
  ProfileCheck(points, table.line_of_row, file, problems).check(kind);
  return problems.count() == before ? points : ProfilePoints{};
}

}  // namespace loco
