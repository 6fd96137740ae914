#include "comparison/model_error/interpolated.h"

#include <algorithm>
#include <cmath>

namespace fretval {
namespace {

constexpr std::size_t most_nodes = 4;
constexpr double of_second_order = 3;  // 2² - 1: twice the distance, as in Richardson's extrapolation

/// Lagrange's polynomial through the nodes about a place, with the bars of the nodes times the size of their weights.
Interpolated through_nodes(const std::vector<Node>& nodes, double at) {
  const std::size_t n = std::min(most_nodes, nodes.size());
  const auto above =
      std::upper_bound(nodes.begin(), nodes.end(), at, [](double place, const Node& node) { return place < node.at; });
  const auto next = static_cast<std::size_t>(above - nodes.begin()), half = n / 2;
  const std::size_t first = std::min(next > half ? next - half : 0, nodes.size() - n);
  Interpolated sum{0, 0};
  for (std::size_t i = first; i < first + n; ++i) {
    double weight = 1;
    for (std::size_t j = first; j < first + n; ++j)
      if (j != i) weight *= (at - nodes[j].at) / (nodes[i].at - nodes[j].at);
    sum.value += weight * nodes[i].value;
    sum.uncertainty += std::abs(weight) * nodes[i].bar;
  }
  return sum;
}

/// Every other node, and the last one, so that the ends are the same.
std::vector<Node> every_other(const std::vector<Node>& nodes) {
  std::vector<Node> some;
  for (std::size_t i = 0; i < nodes.size(); i += 2) some.push_back(nodes[i]);
  if (nodes.size() % 2 == 0) some.back() = nodes.back();
  return some;
}

}  // namespace

std::optional<Interpolated> interpolated(const std::vector<Node>& nodes, double at) {
  constexpr double slack = 3e-3;  // what amplitudes are set to, and the last digits of a table
  if (nodes.size() < 2 || at < nodes.front().at - slack || at > nodes.back().at + slack) return std::nullopt;
  auto fine = through_nodes(nodes, at);
  const auto is_here = [&](const Node& node) { return std::abs(node.at - at) < slack; };
  if (std::none_of(nodes.begin(), nodes.end(), is_here))
    fine.uncertainty += std::abs(fine.value - through_nodes(every_other(nodes), at).value) / of_second_order;
  return fine;
}

}  // namespace fretval
