#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "comparison/body.h"
#include "comparison/simulation.h"

namespace fretval {

/// What stays of a body once its cases are computed.
struct BodySummary {
  meshes::MeshQuality mesh_quality;
  BodyCost cost;
  unsigned n_dofs;
  std::size_t n_contact_nodes;
  std::vector<double> radii;  ///< of the rings
};

/// A scene to be computed by finite elements.
struct Probe {
  const Case* scene;
  FemScene fem;
};

/// Its answer, or why there is none.
struct ProbeAnswer {
  FeAnswer fe;
  std::shared_ptr<const NormalSimulation> normal;
  std::shared_ptr<const BodySummary> body;
  std::string failure;
};

/// overlapped: the next body is made while the histories of one run. exclusive: one after another, for seconds that
/// nothing else disturbs.
enum class Schedule { overlapped, exclusive };

/// Computes probes. Work is shared: one body per specification, one normal history per normal problem (at nu = 1/2 it
/// does not see the tangential motion); then the friction histories run on all cores. take is called once for each
/// probe, one call at a time, in no particular order. Failures of the numerics are answers, not exceptions.
void run_probes(const std::vector<Probe>& probes, const std::function<Body(const BodySpecification&)>& make_body,
                const std::function<void(std::size_t probe, ProbeAnswer&& answer)>& take,
                Schedule schedule = Schedule::overlapped);

}  // namespace fretval
