#include "comparison/accuracy/refinement.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace fretval {
namespace {

CaseNeeds unlocked() {
  CaseNeeds needs;
  needs.creep = needs.without_period = true;
  return needs;
}

/// What stands for how fine a resolution is in the respect of a source, and may be set.
double entry_of(ErrorSource source, const Resolution& r) {
  switch (source) {
    case ErrorSource::element_order:
      return r.degree;
    case ErrorSource::grading:
      return r.growth;
    case ErrorSource::far_field:
      return r.far_radius;
    case ErrorSource::time_step:
      return r.steps_per_cycle;
    case ErrorSource::start:
      return r.n_ramp_cycles;
    case ErrorSource::creep:
      return r.n_creep_cycles;
    case ErrorSource::cycles:
      return r.periodicity;
    case ErrorSource::edge:
      return r.edge_before_node;
    default:
      return r.elements_per_radius;
  }
}

/// Whether two resolutions differ in the respect of a source, and in no other.
bool differ_only_in(ErrorSource source, Resolution a, const Resolution& b) {
  if (entry_of(source, a) == entry_of(source, b)) return false;
  switch (source) {
    case ErrorSource::element_order:
      a.degree = b.degree;
      break;
    case ErrorSource::grading:
      a.growth = b.growth;
      break;
    case ErrorSource::far_field:
      a.far_radius = b.far_radius;
      break;
    case ErrorSource::time_step:
      a.steps_per_cycle = b.steps_per_cycle;
      break;
    case ErrorSource::start:
      a.n_ramp_cycles = b.n_ramp_cycles;
      break;
    case ErrorSource::creep:
      a.n_creep_cycles = b.n_creep_cycles;
      break;
    case ErrorSource::cycles:
      a.periodicity = b.periodicity;
      break;
    case ErrorSource::edge:
      a.edge_before_node = b.edge_before_node;
      break;
    default:
      a.elements_per_radius = b.elements_per_radius;
      a.worn_edge_ring = b.worn_edge_ring;
      a.surface_growth = b.surface_growth;
      a.focus = b.focus;
  }
  return a == b;
}

TEST(Variants, DifferFromTheirReferencesInTheirOwnRespectAlone) {
  for (const double accuracy : {1e-2, 1e-3, 1e-4})
    for (const bool focused : {false, true}) {
      auto resolution = resolution_for(accuracy);
      if (focused) resolution.focus = Focus{0, 0.25, 0.01};
      for (const auto& [source, varied, reference] : variants_of(resolution, unlocked()))
        EXPECT_TRUE(differ_only_in(source, varied, reference)) << name_of(source) << ": " << text_of(varied);
    }
}

// Richardson's estimate takes them for twice and four times as coarse.
TEST(Variants, OfTwoOfASourceTheSecondIsTwiceAsCoarse) {
  const auto variants = variants_of(resolution_for(1e-4), unlocked());
  std::map<ErrorSource, int> n;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const auto& [source, varied, reference] = variants[i];
    ++n[source];
    if (n[source] == 1) continue;
    EXPECT_EQ(variants[i - 1].source, source) << "they follow each other";
    if (source == ErrorSource::edge) continue;
    EXPECT_EQ(4 * entry_of(source, varied), entry_of(source, reference)) << name_of(source);
    EXPECT_EQ(2 * entry_of(source, varied), entry_of(source, variants[i - 1].resolution)) << name_of(source);
  }
  for (const auto source : {ErrorSource::rings, ErrorSource::edge, ErrorSource::time_step, ErrorSource::creep})
    EXPECT_EQ(n[source], 2);
  EXPECT_EQ(n.size(), 9U) << "all but the jumps of wear";
}

// What all relations of the phases leave of the error of another source, few of them show.
TEST(Variants, NeedManyCyclesForCreepAlone) {
  auto resolution = resolution_for(1e-3);
  resolution.n_creep_cycles = 192;
  for (const auto& [source, varied, reference] : variants_of(resolution, unlocked()))
    EXPECT_EQ(reference.n_creep_cycles, source == ErrorSource::creep ? 192 : 12) << name_of(source);
  for (const auto& variant : variants_of(resolution, CaseNeeds()))
    EXPECT_EQ(variant.reference.n_creep_cycles, 192) << "all have the same period";
}

// A mesh that the case brings along is not generated anew: cells are split, and rings share them.
TEST(Variants, OfAGivenMeshAreMadeOfItsCells) {
  auto resolution = resolution_for(1e-3);
  resolution.mesh_refinements = 0;
  std::map<ErrorSource, std::vector<Variant>> by_source;
  for (const auto& variant : variants_of(resolution, CaseNeeds())) by_source[variant.source].push_back(variant);
  EXPECT_EQ(by_source.count(ErrorSource::far_field), 0U);
  const auto& split = by_source.at(ErrorSource::grading).front();
  EXPECT_EQ(split.resolution.mesh_refinements, 1U);
  EXPECT_EQ(split.reference.mesh_refinements, 0U);
  EXPECT_EQ(split.resolution.elements_per_radius, split.reference.elements_per_radius);
  const auto& edge = by_source.at(ErrorSource::edge).front();
  EXPECT_EQ(edge.resolution.mesh_refinements, 1U);
  EXPECT_NEAR(edge.resolution.edge_before_node - edge.reference.edge_before_node, 0.5, 1e-15);
  EXPECT_EQ(by_source.at(ErrorSource::rings).size(), 2U);
  resolution.elements_per_radius = 12;
  for (const auto& variant : variants_of(resolution, CaseNeeds())) {
    if (variant.source == ErrorSource::rings) {
      EXPECT_EQ(variant.resolution.elements_per_radius, 24U);
    }
  }
  EXPECT_FALSE(refined(resolution, ErrorSource::grading));
}

// Unless steps and rings depend on each other, and never fewer than tell anything.
TEST(Variants, OfRingsAndEdgesHaveHalfTheSteps) {
  const auto steps_of_rings = [](const Resolution& resolution, const CaseNeeds& needs) {
    std::set<int> steps;
    for (const auto& [source, varied, reference] : variants_of(resolution, needs))
      if (source == ErrorSource::rings || source == ErrorSource::edge)
        steps.insert({varied.steps_per_cycle, reference.steps_per_cycle});
    return steps;
  };
  const auto resolution = resolution_for(1e-3);
  CaseNeeds needs;
  EXPECT_EQ(steps_of_rings(resolution, needs), std::set<int>{resolution.steps_per_cycle / 2});
  EXPECT_EQ(steps_of_rings(with_steps(resolution, 0.5), needs), std::set<int>{resolution.steps_per_cycle / 2});
  needs.moves_by_steps = true;
  EXPECT_EQ(steps_of_rings(resolution, needs), std::set<int>{resolution.steps_per_cycle});
  needs = CaseNeeds();
  needs.kind = ContactKind::annuli;
  EXPECT_EQ(steps_of_rings(resolution, needs), std::set<int>{resolution.steps_per_cycle});
}

TEST(Variants, AreOfWhatTheCaseNeeds) {
  const auto sources = [](const CaseNeeds& needs) {
    std::set<ErrorSource> all;
    for (const auto& variant : variants_of(resolution_for(1e-3), needs)) all.insert(variant.source);
    return all;
  };
  CaseNeeds needs;
  const auto with_memory = sources(needs);
  needs.memory = false;
  const auto elastic = sources(needs);
  needs.creep = true;
  const auto creeping = sources(needs);
  EXPECT_EQ(elastic.count(ErrorSource::start) + elastic.count(ErrorSource::creep), 0U);
  EXPECT_EQ(with_memory.size(), elastic.size() + 1);
  EXPECT_EQ(with_memory.count(ErrorSource::start), 1U);
  EXPECT_EQ(creeping.size(), elastic.size() + 1);
  EXPECT_EQ(creeping.count(ErrorSource::creep), 1U);
  auto anywhere = CaseNeeds();
  anywhere.begins_anywhere = true;
  EXPECT_EQ(sources(anywhere).count(ErrorSource::instants), 1U);
  EXPECT_EQ(with_memory.count(ErrorSource::instants), 0U);
  // Rings of a worn profile end at its edge, and edges of any order are those of rings.
  EXPECT_EQ(elastic.count(ErrorSource::edge), 1U);
  for (const auto kind : {ContactKind::worn, ContactKind::annuli}) {
    needs.kind = kind;
    EXPECT_EQ(sources(needs).count(ErrorSource::edge), 0U);
  }
}

TEST(Refined, GoesTheOtherWayThanVariantsUntilItsLimit) {
  const auto start = resolution_for(1e-3);
  for (const auto& [source, varied, reference] : variants_of(start, unlocked())) {
    if (source == ErrorSource::edge) continue;
    const double coarser = entry_of(source, varied) - entry_of(source, reference);
    int n = 0;
    auto now = start;
    for (auto finer = refined(now, source); finer; finer = refined(now, source)) {
      EXPECT_TRUE(differ_only_in(source, *finer, now)) << name_of(source);
      EXPECT_LT((entry_of(source, *finer) - entry_of(source, now)) * coarser, 0) << name_of(source);
      now = *finer;
      ASSERT_LT(++n, 20) << name_of(source) << " has no limit";
    }
    EXPECT_GT(n, 0) << name_of(source);
  }
  EXPECT_TRUE(refined(start, ErrorSource::edge) == refined(start, ErrorSource::rings));
  EXPECT_TRUE(refined(start, ErrorSource::instants) == refined(start, ErrorSource::time_step));
}

// A plan takes a tenth of that share to be left.
TEST(Refined, SettlesTenTimesFurther) {
  const auto start = resolution_for(1e-3);
  EXPECT_NEAR(refined(start, ErrorSource::cycles)->periodicity / start.periodicity, 0.1, 1e-12);
}

}  // namespace
}  // namespace fretval
