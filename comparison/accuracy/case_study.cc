#include "comparison/accuracy/case_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/accuracy/refinement_plan.h"
#include "comparison/support/log.h"
#include "fem/stick_zone/stick_depths.h"

namespace fretval {
namespace {

constexpr int most_refinements = 6;
constexpr Eigen::Index enough_stuck_rings = 6, enough_slipping_rings = 3;
constexpr double worthwhile_gain = 4;  // a ring that is less finer than that, the error budget asks for by itself
constexpr double worthwhile_gain_if_hopeless = 1.5;  // where it asks for more than can be planned
constexpr double finest_ring_at_the_centre = 1e-4, finest_ring_at_the_edge = 1e-7;

constexpr const char* first_slip = "stick_radius_first_slip";
constexpr const char* shakedown = "stick_radius_shakedown";
constexpr const char* normal_force = "normal_force_max";
constexpr const char* contact_radius = "contact_radius_max";

/// The next power of two, so that similar cases share their bodies.
double rounded_up(double x) {
  return std::exp2(std::ceil(std::log2(x)));
}

double finest_ring(const Resolution& resolution) {
  return resolution.focus ? resolution.focus->ring : 1.0 / resolution.elements_per_radius;
}

Eigen::Index rings_within(const std::vector<double>& radii, double c) {
  return std::max<Eigen::Index>(std::upper_bound(radii.begin(), radii.end(), c) - radii.begin() - 1, 0);
}

Measures centre_depths(const std::map<std::string, fem::StickDepths>& zones) {
  Measures centre;
  for (const auto& [quantity, depths] : zones) centre[quantity] = depths.depth[0];
  return centre;
}

SceneNeeds needs_of(const FemCase& scene) {
  return {scene.relaxation.has_memory(), !scene.motion.phase, scene.worn_edge.has_value()};
}

/// What reading the edges leaves open, in the units of measures.
Measures uncertainties_of_edges(const ProbeAnswer& answer, const FemCase& scene) {
  if (!answer.failure.empty()) return {};
  const auto& fe = answer.fe;
  Measures uncertainties;
  if (fe.normal_force_max > 0) uncertainties[normal_force] = fe.normal_force_uncertainty / fe.normal_force_max;
  if (!scene.worn_edge) {
    uncertainties[contact_radius] = fe.contact_radius_uncertainty / scene.units.length;
    uncertainties[first_slip] = fe.first_slip_uncertainty / scene.units.length;
    uncertainties[shakedown] = fe.shakedown_uncertainty / scene.units.length;
  }
  return uncertainties;
}

std::string large_shares(const ErrorBar& bar) {
  std::string text;
  for (const auto& share : bar.shares)
    if (share.estimate > bar.total() / 10)
      text += fmt::format("{}{} {:.1e}", text.empty() ? "" : ", ", name_of(share.source), share.estimate);
  return text;
}

/// Adds what a bar falls short of a width.
void widen(ErrorBar& bar, double width) {
  const double missing = width - bar.total();
  if (missing > 0) bar.shares.push_back({ErrorSource::edge, missing, std::nullopt});
}

/// The depth of a stick zone goes at least with the square of its radius: a bar of more than half of the radius leaves
/// open whether anything sticks at all.
void widen_to_none(double c, ErrorBar& bar) {
  constexpr double all_of_it = 1.01;
  if (bar.total() > c / 2) widen(bar, all_of_it * c);
}

FixedByCase fixed_by(const Case& scene) {
  return {scene.rings_per_radius.has_value(), scene.steps_per_cycle.has_value()};
}

}  // namespace

double seconds_alone(const ProbeAnswer& answer) {
  double seconds = answer.fe.seconds;
  if (answer.body) seconds += answer.body->cost.total();
  if (answer.normal) seconds += answer.normal->seconds;
  return seconds;
}

CaseStudy::CaseStudy(const PreparedCase& prepared, StudyDepth depth)
    : prepared_(prepared), depth_(depth), now_{prepared.fem.resolution, {}} {
  want(now_.base);
}

void CaseStudy::want(const Resolution& resolution) {
  if (measures_.count(resolution) == 0 && std::find(wanted_.begin(), wanted_.end(), resolution) == wanted_.end())
    wanted_.push_back(resolution);
}

void CaseStudy::want_variants() {
  for (const auto& track : tracks_of(now_))
    for (const auto& variant : variants_of(track, needs_of(prepared_.fem))) {
      want(variant.resolution);
      want(variant.reference);
    }
}

void CaseStudy::take(const Resolution& resolution, ProbeAnswer&& answer) {
  measures_[resolution] = answer.failure.empty() ? measures_of(answer.fe, prepared_.fem.units) : Measures{};
  if (depth_ == StudyDepth::budget && answer.failure.empty() && !prepared_.fem.worn_edge)
    depths_[resolution] = {{first_slip, answer.fe.first_slip_depths}, {shakedown, answer.fe.shakedown_depths}};
  const auto all = tracks_of(now_);
  // The histories of variants are not needed any more.
  if (std::find(all.begin(), all.end(), resolution) != all.end()) answers_[resolution] = std::move(answer);
}

const Resolution& CaseStudy::resolution_of(const std::string& quantity) const {
  const auto found = now_.focused.find(quantity);
  return found == now_.focused.end() ? now_.base : found->second;
}

std::vector<Resolution> CaseStudy::tracks_of(const Tracks& tracks) {
  std::vector<Resolution> all{tracks.base};
  for (const auto& [quantity, resolution] : tracks.focused) all.push_back(resolution);
  return all;
}

std::optional<Focus> CaseStudy::closer_look(const std::string& quantity) const {
  const Resolution& now = resolution_of(quantity);
  const auto& answer = answers_.at(now);
  const auto& rings = answer.fe.rings;
  const auto& measures = measures_.at(now);
  const double c = measures.at(quantity), ring = finest_ring(now);
  const Eigen::Index n_stuck = rings_within(answer.body->radii, c);
  if (n_stuck < enough_stuck_rings) {
    // Of a zone that does not show, it is enough to know that it is small against the tolerance.
    const double fine_enough = n_stuck > 0 ? 0 : prepared_.tolerances.stick_radius / 4;
    if (ring < std::max(finest_ring_at_the_centre, fine_enough)) return std::nullopt;
    const double outer = n_stuck > 0 ? rounded_up(1.5 * c + ring) : rounded_up(ring);
    return Focus{0, outer, outer / 32};
  }
  const auto contact = measures.find(contact_radius);
  if (rings.contact - n_stuck >= enough_slipping_rings || contact == measures.end()) return std::nullopt;
  if (ring < finest_ring_at_the_edge) return std::nullopt;
  const double edge = contact->second, width = rounded_up(std::max(1.5 * (edge - c), ring / 4));
  // Similar cases share their bodies if the edge is where it is expected.
  const double centre = std::abs(edge - 1) < width / 8 ? 1 : edge;
  return Focus{centre - 2 * width, centre + width / 2, width / 16};
}

bool CaseStudy::failed() const {
  const auto all = tracks_of(now_);
  return std::any_of(all.begin(), all.end(), [&](const Resolution& r) { return !answers_.at(r).failure.empty(); });
}

bool CaseStudy::focus_on_unresolved_edges() {
  for (const char* quantity : {first_slip, shakedown}) focus_on(quantity, worthwhile_gain);
  return !wanted_.empty();
}

bool CaseStudy::focus_on_what_is_hopeless() {
  const auto bars = budget();
  for (const char* quantity : {first_slip, shakedown}) {
    const auto bar = bars.find(quantity);
    if (bar != bars.end() && bar->second.total() > most_tolerances * tolerance_of(prepared_.tolerances, quantity))
      focus_on(quantity, worthwhile_gain_if_hopeless);
  }
  return !wanted_.empty();
}

void CaseStudy::focus_on(const std::string& quantity, double least_gain) {
  if (prepared_.scene.rings_per_radius || prepared_.fem.worn_edge) return;
  const auto focus = closer_look(quantity);
  if (!focus || focus->ring > finest_ring(resolution_of(quantity)) / least_gain) return;
  Resolution closer = now_.base;
  closer.focus = focus;
  now_.focused[quantity] = closer;
  want(closer);
}

ErrorBudget CaseStudy::budget() const {
  ErrorBudget all;
  for (const auto& track : tracks_of(now_)) {
    auto bars = error_budget(track, measures_, uncertainties_of_edges(answers_.at(track), prepared_.fem),
                             needs_of(prepared_.fem));
    // Refining for it costs hundreds of rings, and does not decide what a border leaves open.
    if (depth_ == StudyDepth::budget) carry_depths(track, bars);
    if (prepared_.fem.worn_edge) carry_slip_inside(track, bars);
    for (const char* quantity : {first_slip, shakedown})
      if (bars.count(quantity) > 0) widen_to_none(measures_.at(track).at(quantity), bars.at(quantity));
    if (depth_ == StudyDepth::budget) carry_drift(track, bars);
    for (const auto& [quantity, bar] : bars)
      if (resolution_of(quantity) == track) all[quantity] = bar;
  }
  return all;
}

/// Where the error of the depth at the centre leaves open whether anything sticks, adds to the bar what that means for
/// the stick radius: under a flat face, all of the face or nothing.
void CaseStudy::carry_depths(const Resolution& track, ErrorBudget& budget) const {
  const auto own = depths_.find(track);
  if (own == depths_.end()) return;
  std::map<Resolution, Measures> centre;
  for (const auto& [resolution, measures] : measures_) {
    const auto found = depths_.find(resolution);
    centre[resolution] = found == depths_.end() ? Measures{} : centre_depths(found->second);
  }
  // At the border the bar of a depth is hardly larger than its error. Where nothing sticks, slips stand for depths,
  // and not at all next to the edge of a flat face.
  constexpr double safety = 2, rings_next_to_face = 8;
  const double face = prepared_.scene.indenter.flat_radius / prepared_.fem.units.length,
               around_face = face > 0 ? face + rings_next_to_face / track.elements_per_radius : 0;
  for (const auto& [quantity, bar] : error_budget(track, centre, {}, needs_of(prepared_.fem))) {
    const double c = measures_.at(track).at(quantity), uncertainty = safety * bar.total();
    if (std::abs(centre.at(track).at(quantity)) > uncertainty) continue;
    const double reach = fem::reach_of_edge(own->second.at(quantity), c, uncertainty);
    widen(budget.at(quantity), c > 0 ? reach : std::max(reach, around_face));
  }
}

/// While an unlocked phase drifts too fast for the body, rings slip on the way that would not: where the first-slip
/// zone is none, it may be all that sticks in the end.
void CaseStudy::carry_drift(const Resolution& track, ErrorBudget& budget) const {
  const auto& measures = measures_.at(track);
  if (!needs_of(prepared_.fem).creep || measures.at(first_slip) > 0) return;
  widen(budget.at(first_slip), measures.at(shakedown) + budget.at(shakedown).total());
}

/// The rings of a worn profile that stick are counted. Where the slip inside its stick radius is no more than its own
/// bar, all rings up to there may stick.
void CaseStudy::carry_slip_inside(const Resolution& track, ErrorBudget& budget) const {
  const auto slip = budget.find("slip_inside_stick_zone");
  if (slip == budget.end() || measures_.at(track).at(slip->first) > slip->second.total()) return;
  const double missing = prepared_.fem.worn_edge->inner - measures_.at(track).at(shakedown);
  if (missing > 0) budget.at(shakedown).shares.push_back({ErrorSource::edge, missing, std::nullopt});
}

bool CaseStudy::refine_what_is_too_wide() {
  return refine(1, std::numeric_limits<double>::infinity());
}

/// Cheaper settings are proved by what the bars leave of the tolerances: bars that leave hardly anything are refined
/// once more, if that costs little.
bool CaseStudy::make_room_for_economy() {
  constexpr double share = 2.0 / 3, most_times = 2;
  if (depth_ != StudyDepth::economy || has_room_) return false;
  has_room_ = true;
  return refine(share, most_times);
}

bool CaseStudy::refine(double share_of_tolerance, double most_times) {
  if (n_refinements_ >= most_refinements) return false;
  std::map<Resolution, std::vector<BarToMeet>> bars;  // by track
  for (const auto& [quantity, bar] : budget()) {
    const double tolerance = share_of_tolerance * tolerance_of(prepared_.tolerances, quantity), total = bar.total();
    bars[resolution_of(quantity)].push_back({bar, tolerance});
    if (total > tolerance)
      log::info(fmt::format("{}: error bar of {} is {:.1e} ({}), {:.1e} is asked for", prepared_.scene.name, quantity,
                            total, large_shares(bar), tolerance));
  }
  const Tracks before = now_;
  bool any = false;
  const auto refine = [&](Resolution& track) {
    const auto& answer = answers_.at(track);
    const Effort effort{static_cast<double>(answer.body->n_dofs), static_cast<double>(answer.body->radii.size() - 1),
                        static_cast<double>(answer.fe.n_steps)};
    const auto finer = planned_refinement(track, bars[track], effort, fixed_by(prepared_.scene), most_times);
    if (!finer) return;
    log::info(fmt::format("{}: from {} to {}", prepared_.scene.name, text_of(track), text_of(*finer)));
    track = *finer;
    any = true;
  };
  refine(now_.base);
  for (auto& [quantity, track] : now_.focused) refine(track);
  if (any) {
    ++n_refinements_;
    before_ = before;
  }
  return any;
}

void CaseStudy::advance() {
  wanted_.clear();
  if (depth_ == StudyDepth::answer) return;
  if (depth_ == StudyDepth::budget) return want_variants();
  if (economy_) return economise();
  if (failed()) {
    if (!before_) return;
    for (const auto& track : tracks_of(now_))
      if (!answers_.at(track).failure.empty())
        log::info(fmt::format("{}: taken back: {}", prepared_.scene.name, answers_.at(track).failure));
    now_ = *before_;
    return economise();
  }
  if (focus_on_unresolved_edges()) return;
  want_variants();
  if (!wanted_.empty() || focus_on_what_is_hopeless()) return;
  if (!refine_what_is_too_wide() && !make_room_for_economy()) return economise();
  for (const auto& track : tracks_of(now_)) {
    want(track);
    // What was a variant before has to be kept now.
    if (measures_.count(track) > 0 && answers_.count(track) == 0) wanted_.push_back(track);
  }
  forget_old_answers();
}

void CaseStudy::forget_old_answers() {
  auto kept = tracks_of(now_);
  for (const auto& track : tracks_of(*before_)) kept.push_back(track);
  for (auto answer = answers_.begin(); answer != answers_.end();)
    answer = std::find(kept.begin(), kept.end(), answer->first) == kept.end() ? answers_.erase(answer) : ++answer;
}

std::vector<ProvedTrack> CaseStudy::proved_tracks() const {
  ProvedMeasures proved;
  for (const auto& [quantity, bar] : budget())
    proved[quantity] = {measures_.at(resolution_of(quantity)).at(quantity), bar.total(),
                        tolerance_of(prepared_.tolerances, quantity)};
  // One body is cheaper than several: often one resolution reads all well enough, or the base what has a focus.
  for (const auto& track : tracks_of(now_))
    if (covers(proved, measures_.at(track))) return {{track, proved}};
  std::vector<ProvedTrack> tracks{{now_.base, {}}};
  for (const auto& entry : proved) {
    const ProvedMeasures alone{entry};
    auto track = std::find_if(tracks.begin(), tracks.end(),
                              [&](const ProvedTrack& t) { return covers(alone, measures_.at(t.resolution)); });
    if (track == tracks.end()) {
      const auto& own = resolution_of(entry.first);
      track = own == now_.base ? tracks.begin() : tracks.insert(tracks.end(), {own, {}});
    }
    track->measures.insert(entry);
  }
  return tracks;
}

void CaseStudy::economise() {
  if (depth_ != StudyDepth::economy) return;
  if (!economy_) economy_.emplace(proved_tracks(), needs_of(prepared_.fem), fixed_by(prepared_.scene));
  wanted_ = economy_->advance(measures_);
}

CheapestProved CaseStudy::cheapest() const {
  CheapestProved cheapest;
  for (const auto& track : economy_->tracks()) {
    cheapest.resolutions.push_back(track.resolution);
    for (const auto& [quantity, proved] : track.measures) {
      const double value = measures_.at(track.resolution).at(quantity);
      cheapest.measures[quantity] = value;
      cheapest.bars[quantity] = std::abs(value - proved.value) + proved.bar;
    }
  }
  return cheapest;
}

StudyResult CaseStudy::result() const {
  StudyResult result;
  result.answer = answers_.at(now_.base);
  result.resolution = now_.base;
  result.n_refinements = n_refinements_;
  result.n_probes = static_cast<int>(measures_.size());
  for (const auto& track : tracks_of(now_)) result.seconds += seconds_alone(answers_.at(track));
  if (!result.answer.failure.empty()) return result;
  for (const auto& [quantity, resolution] : now_.focused) {
    const auto& focused = answers_.at(resolution);
    if (!focused.failure.empty()) {
      result.answer.failure = focused.failure;
      return result;
    }
    auto& fe = result.answer.fe;
    if (quantity == first_slip) {
      fe.stick_radius_first_slip = focused.fe.stick_radius_first_slip;
      fe.first_slip_uncertainty = focused.fe.first_slip_uncertainty;
    } else {
      fe.stick_radius_shakedown = focused.fe.stick_radius_shakedown;
      fe.shakedown_uncertainty = focused.fe.shakedown_uncertainty;
    }
    result.focus[quantity] = *resolution.focus;
  }
  if (depth_ != StudyDepth::answer) result.budget = budget();
  if (economy_) result.cheapest = cheapest();
  return result;
}

}  // namespace fretval
