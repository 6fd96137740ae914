#include "comparison/report/drawing/zone_map.h"

#include <cmath>

namespace fretval {

std::vector<double> outer_edges(const std::vector<double>& radii, double unit) {
  std::vector<double> edges;
  double square = 0;
  for (const double r : radii) edges.push_back(std::sqrt(square = 2 * r * r / (unit * unit) - square));
  return edges;
}

Filling zone_map(const std::string& title, const std::string& label, const std::vector<double>& edges,
                 const std::vector<std::string>& zones) {
  return {{"kind", "map"},    {"title", title}, {"x_label", "time over the period"},
          {"y_label", label}, {"edges", edges}, {"zones", zones}};
}

}  // namespace fretval
