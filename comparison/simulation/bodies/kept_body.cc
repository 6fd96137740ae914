#include "comparison/simulation/bodies/kept_body.h"

#include <utility>

#include "comparison/simulation/bodies/operator_key.h"

namespace fretval {
namespace {

using fem::axisymmetric;
using fem::FourierOrder;
using fem::lateral;
using Figures = std::map<std::string, double>;

meshes::MeshQuality quality_in(const Figures& figures) {
  return {static_cast<std::size_t>(figures.at("cells")),
          static_cast<std::size_t>(figures.at("nodes")),
          figures.at("smallest scaled Jacobian"),
          figures.at("mean scaled Jacobian"),
          figures.at("largest aspect ratio"),
          figures.at("area"),
          figures.at("smallest edge"),
          figures.at("largest edge")};
}

}  // namespace

Figures figures_of(const meshes::MeshQuality& q, const fem::HarmonicSpace& space) {
  return {{"dofs", space.n_dofs()},
          {"contact nodes", static_cast<double>(space.contact_line().dofs.size())},
          {"cells", static_cast<double>(q.n_cells)},
          {"nodes", static_cast<double>(q.n_nodes)},
          {"smallest scaled Jacobian", q.min_scaled_jacobian},
          {"mean scaled Jacobian", q.mean_scaled_jacobian},
          {"largest aspect ratio", q.max_aspect_ratio},
          {"area", q.area},
          {"smallest edge", q.smallest_edge},
          {"largest edge", q.largest_edge}};
}

std::vector<FourierOrder> harmonics_of(const BodyDescription& description) {
  if (description.tangential) return {axisymmetric, lateral};
  return {axisymmetric};
}

ContactBody body_of(std::vector<fem::StoredOperator> harmonics, const RingEdges& edges, bool from_store,
                    Stopwatch& watch) {
  const auto& figures = harmonics[0].figures;
  BodySummary summary{
      quality_in(figures),           {},        0, static_cast<std::size_t>(figures.at("contact nodes")),
      harmonics[0].compliance.radii, from_store};
  for (const auto& harmonic : harmonics) summary.n_dofs += static_cast<unsigned>(harmonic.figures.at("dofs"));
  harmonics[0].compliance.half_space = edges.normal;
  if (harmonics.size() > 1) harmonics[1].compliance.half_space = edges.tangential;
  fem::ContactProblem normal(std::move(harmonics[0].compliance));
  std::optional<fem::ContactProblem> tangential;
  if (harmonics.size() > 1) tangential.emplace(std::move(harmonics[1].compliance));
  (from_store ? summary.cost.reading : summary.cost.factorisation) = watch.lap();
  return {std::move(normal), std::move(tangential), std::make_shared<const BodySummary>(std::move(summary))};
}

std::optional<ContactBody> kept_body(const BodyDescription& description, const RingEdges& edges,
                                     const OperatorStore& operators, int n_processes) {
  Stopwatch watch;
  std::vector<fem::StoredOperator> harmonics;
  for (const auto order : harmonics_of(description)) {
    auto found = operators.find(operator_key(description, order, n_processes));
    if (!found) return std::nullopt;
    harmonics.push_back(*std::move(found));
  }
  return body_of(std::move(harmonics), edges, true, watch);
}

void keep_body(const BodyDescription& description, const Body& body, OperatorStore& operators) {
  const auto keep = [&](const FourierOrder& order, const HarmonicBody& part) {
    operators.keep(
        {operator_key(description, order), part.contact.compliance, figures_of(body.mesh_quality, part.space)});
  };
  keep(axisymmetric, body.normal);
  if (body.tangential) keep(lateral, *body.tangential);
}

}  // namespace fretval
