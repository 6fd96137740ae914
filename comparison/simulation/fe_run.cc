#include "comparison/simulation/fe_run.h"

#include <fmt/format.h>

#include <future>
#include <map>
#include <mutex>

#include "comparison/support/groups.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

using Indices = std::vector<std::size_t>;

struct NormalAnswer {
  std::shared_ptr<const NormalSimulation> simulation;
  std::string failure;
};

/// The contact problems of a body for every slack that is asked for.
class Problems {
 public:
  Problems(const CondensedBody& body, const std::vector<Probe>& probes, const Indices& members) : body_(body) {
    for (const std::size_t i : members) {
      const double slack = probes[i].fem.resolution.active_set_slack;
      if (slack == Resolution{}.active_set_slack || others_.count(slack) > 0) continue;
      auto& pair = others_[slack];
      pair.normal = std::make_unique<fem::ContactProblem>(body.normal.compliance, slack);
      if (body.tangential) pair.tangential = std::make_unique<fem::ContactProblem>(body.tangential->compliance, slack);
    }
  }

  [[nodiscard]] ContactProblems of(const FemCase& scene) const {
    const auto found = others_.find(scene.resolution.active_set_slack);
    if (found != others_.end()) return {*found->second.normal, found->second.tangential.get()};
    return {body_.normal, body_.tangential ? &*body_.tangential : nullptr};
  }

 private:
  struct Pair {
    std::unique_ptr<fem::ContactProblem> normal, tangential;
  };
  const CondensedBody& body_;
  std::map<double, Pair> others_;
};

/// failure of the numerics; anything else is not caught.
template <class Work>
std::string failure_of(const Work& work) {
  try {
    work();
    return "";
  } catch (const fem::SolverError& error) {
    return error.what();
  } catch (const meshes::MeshError& error) {
    return error.what();
  }
}

void run_on_body(const CondensedBody& body, const std::vector<Probe>& probes, const Indices& members,
                 const std::function<void(std::size_t, ProbeAnswer&&)>& take) {
  const Problems problems(body, probes, members);
  const auto groups = groups_of(members, [&](std::size_t a, std::size_t b) {
    return same_normal_problem(probes[a].fem, *probes[a].scene, probes[b].fem, *probes[b].scene);
  });
  std::vector<NormalAnswer> normal(groups.size());
  for_each_in_parallel(groups.size(), [&](std::size_t g) {
    const auto& scene = probes[groups[g].front()].fem;
    normal[g].failure = failure_of([&] {
      normal[g].simulation =
          std::make_shared<const NormalSimulation>(simulate_normal(problems.of(scene).normal, scene));
    });
  });
  std::vector<std::pair<std::size_t, std::size_t>> jobs;  // group, probe
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::size_t i : groups[g]) jobs.emplace_back(g, i);
  std::mutex mutex;
  for_each_in_parallel(jobs.size(), [&](std::size_t j) {
    const auto [g, i] = jobs[j];
    ProbeAnswer answer;
    answer.normal = normal[g].simulation;
    answer.body = body.summary;
    answer.failure = normal[g].failure;
    const auto& scene = probes[i].fem;
    if (answer.failure.empty())
      answer.failure = failure_of([&] { answer.fe = simulate(problems.of(scene), scene, *answer.normal); });
    const std::lock_guard<std::mutex> lock(mutex);
    take(i, std::move(answer));
  });
}

}  // namespace

std::shared_ptr<const CondensedBody> condensed(Body&& body) {
  const auto summary = std::make_shared<const BodySummary>(BodySummary{body.mesh_quality, body.cost, body.n_dofs(),
                                                                       body.normal.space.contact_line().dofs.size(),
                                                                       body.normal.contact.compliance.radii});
  std::optional<fem::ContactProblem> tangential;
  if (body.tangential) tangential = std::move(body.tangential->contact);
  return std::make_shared<const CondensedBody>(
      CondensedBody{std::move(body.normal.contact), std::move(tangential), summary});
}

std::shared_ptr<const CondensedBody> BodyStore::operator()(const BodySpecification& specification) {
  std::promise<std::shared_ptr<const CondensedBody>> promise;
  Future body;
  bool is_new = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto [entry, inserted] = bodies_.try_emplace(specification);
    if (inserted) entry->second = promise.get_future().share();
    body = entry->second;
    is_new = inserted;
  }
  if (!is_new) return body.get();
  try {
    auto made = condensed(make_body_(specification));
    log::info(fmt::format("body: {} dofs, {} rings", made->summary->n_dofs, made->normal.n_rings()));
    promise.set_value(std::move(made));
  } catch (...) {
    promise.set_exception(std::current_exception());
  }
  return body.get();
}

void run_probes(const std::vector<Probe>& probes, const BodySource& body_of,
                const std::function<void(std::size_t, ProbeAnswer&&)>& take, Schedule schedule) {
  std::map<BodySpecification, Indices> bodies;
  for (std::size_t i = 0; i < probes.size(); ++i) bodies[probes[i].fem.body].push_back(i);
  std::future<void> histories;  // of the body before
  for (const auto& [specification, members] : bodies) {
    std::shared_ptr<const CondensedBody> body;
    const std::string failure = failure_of([&, &s = specification] { body = body_of(s); });
    if (histories.valid()) histories.get();
    if (!body) {
      for (const std::size_t i : members) {
        ProbeAnswer answer;
        answer.failure = failure;
        take(i, std::move(answer));
      }
      continue;
    }
    const auto run = [body, &probes, &members = members, &take] { run_on_body(*body, probes, members, take); };
    if (schedule == Schedule::exclusive)
      run();
    else
      histories = std::async(std::launch::async, run);
  }
  if (histories.valid()) histories.get();
}

}  // namespace fretval
