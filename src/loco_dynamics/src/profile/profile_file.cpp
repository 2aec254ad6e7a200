#include "loco_dynamics/profile/profile_file.hpp"

#include "profile_check.hpp"
#include "rail_core/csv_table.hpp"
#include "rail_core/message_number.hpp"

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

std::string profileCsv(ProfileKind kind, const ProfilePoints& points) {
  constexpr double kMillimetresPerMetre = 1e3;
  constexpr char kWheel[] =
      "# y: from the taping line (70 mm from the flange's back) to the field side; z: down, 0 at the taping line.\n"
      "# First the flange's back, last the field side.\n";
  constexpr char kRail[] =
      "# The rail upright. y: from the middle of the head to the field side; z: down from the top.\n"
      "# First the gauge face, last the field side.\n";
  std::string text = std::string(kind == ProfileKind::kWheel ? kWheel : kRail) + "y_mm,z_mm\n";
  for (const ProfilePoint& point : points) {
    text += rail::exactNumber(point.y_m * kMillimetresPerMetre) + "," +
            rail::exactNumber(point.z_m * kMillimetresPerMetre) + "\n";
  }
  return text;
}

}  // namespace loco
