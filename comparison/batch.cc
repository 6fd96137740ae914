#include "comparison/batch.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <map>
#include <mutex>
#include <set>

#include "comparison/parallel.h"
#include "fem/solver_error.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

/// Cases that share their normal problem, by index.
struct NormalGroup {
  std::vector<std::size_t> members;
};

std::vector<NormalGroup> group_by_normal_problem(const std::vector<PreparedCase>& cases,
                                                 const std::vector<std::size_t>& indices) {
  std::vector<NormalGroup> groups;
  for (const std::size_t i : indices) {
    auto group = groups.begin();
    while (group != groups.end()) {
      const auto& first = cases[group->members.front()];
      if (same_normal_problem(first.fem, first.scene, cases[i].fem, cases[i].scene)) break;
      ++group;
    }
    if (group == groups.end()) group = groups.insert(group, NormalGroup{});
    group->members.push_back(i);
  }
  return groups;
}

/// The normal problem of a group, computed both ways; failed: with the message instead.
struct NormalAnswers {
  NormalSimulation simulation;
  mdr::NormalResponse reference;
  std::string failure;
};

NormalAnswers answer_normal(const Body& body, const PreparedCase& first) {
  NormalAnswers answers;
  try {
    answers.reference = mdr_normal_response(first.mdr);
    answers.simulation = simulate_normal(body, first.fem);
  } catch (const std::runtime_error& error) {
    answers.failure = error.what();
  }
  return answers;
}

class Batch {
 public:
  Batch(const std::vector<PreparedCase>& cases, const fs::path& output, const BatchHooks& hooks)
      : cases_(cases), output_(output), hooks_(hooks), lines_(cases.size()) {}

  void run_body(const BodySpecification& specification, const std::vector<std::size_t>& indices) {
    const Body body = hooks_.make_body(specification);
    spdlog::info("body: {} cells, {} dofs, {} rings; mesh {:.2f} s, assembly {:.2f} s, condensation {:.2f} s",
                 body.mesh_quality.n_cells, body.n_dofs(), body.normal.contact.n_rings(), body.cost.mesh,
                 body.cost.assembly, body.cost.factorisation);
    const auto groups = group_by_normal_problem(cases_, indices);
    std::vector<NormalAnswers> normals(groups.size());
    for_each_in_parallel(groups.size(),
                         [&](std::size_t g) { normals[g] = answer_normal(body, cases_[groups[g].members.front()]); });
    std::vector<std::pair<std::size_t, std::size_t>> jobs;  // group, case
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const std::size_t i : groups[g].members) jobs.emplace_back(g, i);
    for_each_in_parallel(jobs.size(), [&](std::size_t j) { run_case(body, normals[jobs[j].first], jobs[j].second); });
  }

  std::vector<BatchLine> take_lines() { return std::move(lines_); }

 private:
  void run_case(const Body& body, const NormalAnswers& normal, std::size_t index) {
    const auto& prepared = cases_[index];
    BatchLine line;
    line.name = prepared.scene.name;
    line.failure = normal.failure;
    if (line.failure.empty()) {
      try {
        const auto mdr = mdr_answer(prepared.mdr, normal.reference);
        auto fe = simulate(body, prepared.fem, normal.simulation);
        auto verdict = compare(mdr, fe, prepared.fem.units.length, prepared.tolerances);
        line.pass = passes(verdict);
        line.verdict = verdict;
        const Outcome outcome{prepared.scene, prepared.mdr, prepared.fem, mdr, std::move(fe), std::move(verdict)};
        const std::lock_guard<std::mutex> lock(mutex_);  // PETSc, which fields need, is not thread-safe
        if (!output_.empty()) write_outcome(outcome, body, normal.simulation, normal.reference, output_ / line.name);
      } catch (const fem::SolverError& error) {
        line.failure = error.what();
      }
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    hooks_.progress(line, ++n_done_, cases_.size());
    lines_[index] = std::move(line);
  }

  const std::vector<PreparedCase>& cases_;
  const fs::path& output_;
  const BatchHooks& hooks_;
  std::vector<BatchLine> lines_;
  std::mutex mutex_;
  std::size_t n_done_ = 0;
};

}  // namespace

std::vector<PreparedCase> prepare(const std::vector<Case>& cases) {
  std::vector<PreparedCase> prepared;
  std::set<std::string> names;
  for (const auto& scene : cases) {
    if (!names.insert(scene.name).second)
      throw InputError(
          fmt::format("{}: a case named {} is already there; case files need different names", scene.file, scene.name));
    try {
      const auto mdr = mdr_scene(scene);
      prepared.push_back({scene, mdr, fem_scene(scene, mdr), tolerances_of(scene.tolerance)});
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}: {}", scene.file, error.what()));
    }
  }
  return prepared;
}

std::vector<BatchLine> run_batch(const std::vector<PreparedCase>& cases, const fs::path& output,
                                 const BatchHooks& hooks) {
  std::map<BodySpecification, std::vector<std::size_t>> bodies;
  for (std::size_t i = 0; i < cases.size(); ++i) bodies[cases[i].fem.body].push_back(i);
  Batch batch(cases, output, hooks);
  for (const auto& [specification, indices] : bodies) batch.run_body(specification, indices);
  return batch.take_lines();
}

}  // namespace fretval
