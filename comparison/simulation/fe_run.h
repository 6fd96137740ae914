#pragma once

#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "comparison/simulation/body.h"
#include "comparison/simulation/simulation.h"

namespace fretval {

/// Figures of a body.
struct BodySummary {
  meshes::MeshQuality mesh_quality;
  BodyCost cost;
  unsigned n_dofs;
  std::size_t n_contact_nodes;
  std::vector<double> radii;  ///< of the rings
};

/// What histories need of a body: a thousandth of its memory.
struct CondensedBody {
  fem::ContactProblem normal;
  std::optional<fem::ContactProblem> tangential;  ///< only if the indenter moves tangentially
  std::shared_ptr<const BodySummary> summary;
};
std::shared_ptr<const CondensedBody> condensed(Body&& body);

using MakeBody = std::function<Body(const BodySpecification&)>;
using BodySource = std::function<std::shared_ptr<const CondensedBody>(const BodySpecification&)>;

/// Makes every body once, for all threads.
class BodyStore {
 public:
  explicit BodyStore(MakeBody make_body) : make_body_(std::move(make_body)) {}
  /// Throws what make_body throws. Waits where another thread is making this body.
  std::shared_ptr<const CondensedBody> operator()(const BodySpecification& specification);

 private:
  using Future = std::shared_future<std::shared_ptr<const CondensedBody>>;
  MakeBody make_body_;
  std::map<BodySpecification, Future> bodies_;
  std::mutex mutex_;
};

/// A scene to be computed by finite elements.
struct Probe {
  const Case* scene;
  FemCase fem;
};

/// Its answer, or why there is none.
struct ProbeAnswer {
  FeAnswer fe = {};
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
void run_probes(const std::vector<Probe>& probes, const BodySource& body_of,
                const std::function<void(std::size_t probe, ProbeAnswer&& answer)>& take,
                Schedule schedule = Schedule::overlapped);

}  // namespace fretval
