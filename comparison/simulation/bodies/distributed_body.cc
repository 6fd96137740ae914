#include "comparison/simulation/bodies/distributed_body.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "comparison/simulation/bodies/kept_body.h"
#include "comparison/simulation/bodies/operator_key.h"
#include "comparison/support/stopwatch.h"
#include "fem/condensation/distributed_condensation.h"
#include "fem/condensation/far_field.h"
#include "fem/operators/stiffness.h"
#include "fem/support/solver_error.h"

namespace fretval {
namespace {

using nlohmann::json;

/// A message as bytes in CBOR, which keeps every bit of a number.
std::string bytes_of(const json& message) {
  std::string bytes;
  json::to_cbor(message, bytes);
  return bytes;
}

BodyDescription description_in(const std::string& message) {
  const auto fields = json::from_cbor(message);
  BodyDescription body{};
  std::size_t k = 0;
  std::apply([&](auto&... field) { ((fields.at(k++).get_to(field)), ...); }, BodyDescription::fields(body));
  return body;
}

/// A harmonic on the contact line.
struct Condensed {
  std::string key;
  fem::ContactLine line;
  Eigen::MatrixXd schur;  ///< on the first process; elsewhere empty
  std::map<std::string, double> figures;
};

Condensed condensed_together(const BodyDescription& body, const meshes::Mesh& mesh, const fem::FourierOrder& order,
                             const fem::Share& share) {
  const fem::HarmonicSpace space(grid_of(mesh, body), order, body.degree);
  if (fem::lacks_far_field(space))
    throw fem::SolverError(
        "a compressible half-space is not made by several processes together: its far field needs "
        "the factor of the whole");
  const auto name = std::string("stiffness of the ") + (order == fem::axisymmetric ? "normal" : "tangential") +
                    " harmonic, distributed";
  return {operator_key(body, order, static_cast<int>(share.count)), space.contact_line(),
          fem::distributed_schur_complement(fem::assemble_skeleton_stiffness(space, share), space.contact_line().dofs,
                                            name),
          figures_of(meshes::quality(mesh), space)};
}

}  // namespace

std::string text_of(const BodyDescription& body) {
  json fields = json::array();
  std::apply([&](const auto&... field) { (fields.push_back(field), ...); }, BodyDescription::fields(body));
  return bytes_of(fields);
}

std::string operators_made_together(const std::string& description, const fem::Share& share) {
  const auto body = description_in(description);
  const auto mesh = mesh_of(body);
  const bool is_first = share.number == 0;
  json answer{{"failure", ""}, {"operators", json::array()}};
  try {
    // All work of all processes together comes first: where one process gives up after it, the others do not wait for
    // it.
    std::vector<Condensed> harmonics;
    for (const auto order : harmonics_of(body)) harmonics.push_back(condensed_together(body, mesh, order, share));
    for (const auto& [key, line, schur, figures] : harmonics) {
      if (!is_first) break;
      const auto bytes = fem::operator_file({key, fem::contact_compliance(line, schur), figures});
      answer["operators"].push_back(json::binary({bytes.begin(), bytes.end()}));
    }
  } catch (const fem::SolverError& error) {
    answer["failure"] = error.what();
  }
  return is_first ? bytes_of(answer) : "";
}

ContactBody distributed_body(const BodyDescription& description, const RingEdges& edges,
                             const Distribution& distribution, OperatorStore* kept) {
  if (kept)
    if (auto body = kept_body(description, edges, *kept, distribution.n_processes)) return *std::move(body);
  Stopwatch watch;
  const auto answer = json::from_cbor(distribution.make_together(text_of(description)));
  if (const std::string failure = answer.at("failure"); !failure.empty()) throw fem::SolverError(failure);
  std::vector<fem::StoredOperator> harmonics;
  for (const auto& bytes : answer.at("operators")) {
    const auto& file = bytes.get_binary();
    harmonics.push_back(fem::operator_in({file.begin(), file.end()}));
    if (kept) kept->keep(harmonics.back());
  }
  return body_of(std::move(harmonics), edges, false, watch);
}

}  // namespace fretval
