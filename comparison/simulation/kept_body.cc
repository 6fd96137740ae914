#include "comparison/simulation/kept_body.h"

#include <utility>

#include "comparison/simulation/operator_key.h"
#include "comparison/support/stopwatch.h"

namespace fretval {
namespace {

using fem::Harmonic;
using Figures = std::map<std::string, double>;

Figures figures_of(const Body& body, const HarmonicBody& harmonic) {
  const auto& q = body.mesh_quality;
  return {{"dofs", harmonic.space.n_dofs()},
          {"contact nodes", static_cast<double>(harmonic.space.contact_line().dofs.size())},
          {"cells", static_cast<double>(q.n_cells)},
          {"nodes", static_cast<double>(q.n_nodes)},
          {"smallest scaled Jacobian", q.min_scaled_jacobian},
          {"mean scaled Jacobian", q.mean_scaled_jacobian},
          {"largest aspect ratio", q.max_aspect_ratio},
          {"area", q.area},
          {"smallest edge", q.smallest_edge},
          {"largest edge", q.largest_edge}};
}

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

std::optional<ContactBody> kept_body(const BodySpecification& specification, const OperatorStore& operators) {
  Stopwatch watch;
  auto normal = operators.find(operator_key(specification, Harmonic::normal));
  if (!normal) return std::nullopt;
  BodySummary summary{quality_in(normal->figures),
                      {},
                      static_cast<unsigned>(normal->figures.at("dofs")),
                      static_cast<std::size_t>(normal->figures.at("contact nodes")),
                      normal->compliance.radii,
                      true};
  std::optional<fem::ContactProblem> tangential;
  if (specification.tangential) {
    auto found = operators.find(operator_key(specification, Harmonic::tangential));
    if (!found) return std::nullopt;
    summary.n_dofs += static_cast<unsigned>(found->figures.at("dofs"));
    tangential.emplace(std::move(found->compliance));
  }
  fem::ContactProblem problem(std::move(normal->compliance));
  summary.cost.reading = watch.lap();
  return ContactBody{std::move(problem), std::move(tangential),
                     std::make_shared<const BodySummary>(std::move(summary))};
}

void keep_body(const BodySpecification& specification, const Body& body, OperatorStore& operators) {
  const auto keep = [&](Harmonic harmonic, const HarmonicBody& part) {
    operators.keep({operator_key(specification, harmonic), part.contact.compliance, figures_of(body, part)});
  };
  keep(Harmonic::normal, body.normal);
  if (body.tangential) keep(Harmonic::tangential, *body.tangential);
}

}  // namespace fretval
