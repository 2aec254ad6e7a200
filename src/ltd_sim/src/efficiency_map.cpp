#include "ltd_sim/efficiency_map.hpp"

#include <vector>

namespace ltd {

EfficiencyMap EfficiencyMap::read(rail::YamlReader& reader, const std::string& key) {
  EfficiencyMap map;
  const std::size_t problems_before = reader.problems().count();
  const std::vector<std::vector<double>> rows = reader.rows(key, 2);
  std::vector<double> share, efficiency;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string at = key + "." + std::to_string(i);
    const double last = i == 0 ? 0.0 : share.back();
    if (rows[i][0] <= last) reader.refuse(at + ".0", "must be a share above 0 and above the one before it");
    if (rows[i][1] <= 0.0 || rows[i][1] > 1.0) reader.refuse(at + ".1", "must be an efficiency > 0 and <= 1");
    if (i > 0 && rows[i][0] * efficiency.back() <= last * rows[i][1])
      reader.refuse(at + ".1",
                    "must not be so much higher that more power burns less fuel (share / efficiency must rise)");
    share.push_back(rows[i][0]);
    efficiency.push_back(rows[i][1]);
  }
  if (reader.problems().count() == problems_before && (share.empty() || share.back() != 1.0))
    reader.refuse(key, "must end at the rated power, share 1");
  if (reader.problems().count() == problems_before && !share.empty())  // empty: the map around it is missing
    map.efficiency_of_share_ = rail::LookupTable(share, efficiency);
  return map;
}

}  // namespace ltd
