#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/coarsening_search.h"
#include "comparison/accuracy/compared_quantities.h"
#include "comparison/accuracy/error_budget.h"
#include "comparison/accuracy/verdict.h"
#include "comparison/simulation/fe_run.h"

namespace fretval {

/// A case ready to be computed.
struct PreparedCase {
  Case scene;
  MdrCase mdr;
  FemCase fem;
  Tolerances tolerances;
};

/// Seconds of an answer whose body and normal history were its own: mesh, assembly, factorisation, both histories.
double seconds_alone(const ProbeAnswer& answer);

/// How far a study goes: one resolution and no more; that and its error bars, whatever they are; until the error bars
/// meet the tolerance; and on to the cheapest resolutions that this proof covers.
enum class StudyDepth { answer, budget, proof, economy };

/// The cheapest resolutions that the proof covers, see Economy.
struct CheapestProved {
  std::vector<Resolution> resolutions;  ///< one, or the base and those with a focus that it needs
  Measures measures;
  Measures bars;  ///< distance from the proved value, and the bar of that
};

/// What a study of a case comes to.
struct StudyResult {
  ProbeAnswer answer;  ///< at the chosen resolution, with the stick radii of the focused ones
  Resolution resolution;
  std::map<std::string, Focus> focus;      ///< stick radii that are read from a graded mesh, by name
  ErrorBudget budget;                      ///< empty if none was asked for
  std::optional<CheapestProved> cheapest;  ///< with StudyDepth::economy
  int n_refinements = 0, n_probes = 0;
  double seconds = 0;  ///< of the chosen resolutions if the case ran alone and without a budget
};

/// Chooses the resolution of a case by what its finite elements turn out to miss, without a look at what MDR says:
///
/// 1. the coarsest resolution that usually does (resolution_for);
/// 2. a stick zone or a slip annulus of too few rings is focused on, again and again until it is resolved, proved
///    smaller than the finest ring or, for a stick zone that does not show, than a quarter of the tolerance; where the
///    rings of the focus were less than four times finer, step 4 gets there at a lower cost, unless the bar turns out
///    to be more than 15 tolerances;
/// 3. the error budget, each source by its own refinement;
/// 4. while the bar of a quantity is wider than its tolerance, what is expected to mend that at the lowest cost is
///    refined (planned_refinement). A refinement whose numerics fail is taken back.
/// 5. StudyDepth::economy: what of the proved resolutions can be coarsened without moving anything by more than the
///    bars leave of the tolerance (see Economy); a focus is left out where the plain rings read its zone well enough.
///
/// The caller computes what is wanted, round by round. Rings and steps that the case file fixes stay as they are.
class CaseStudy {
 public:
  CaseStudy(const PreparedCase& prepared, StudyDepth depth);

  /// Resolutions to be computed next; empty: the study is finished.
  [[nodiscard]] const std::vector<Resolution>& wanted() const { return wanted_; }
  [[nodiscard]] const PreparedCase& prepared() const { return prepared_; }
  void take(const Resolution& resolution, ProbeAnswer&& answer);
  /// Call when all that was wanted is taken.
  void advance();
  [[nodiscard]] StudyResult result() const;

 private:
  struct Tracks {
    Resolution base;
    std::map<std::string, Resolution> focused;  // stick radii with a resolution of their own
  };
  static std::vector<Resolution> tracks_of(const Tracks& tracks);
  [[nodiscard]] const Resolution& resolution_of(const std::string& quantity) const;
  [[nodiscard]] std::optional<Focus> closer_look(const std::string& quantity) const;
  [[nodiscard]] ErrorBudget budget() const;
  void carry_depths(const Resolution& track, ErrorBudget& budget) const;
  void carry_drift(const Resolution& track, ErrorBudget& budget) const;
  void carry_slip_inside(const Resolution& track, ErrorBudget& budget) const;
  [[nodiscard]] bool failed() const;
  bool focus_on_unresolved_edges();
  bool focus_on_what_is_hopeless();
  void focus_on(const std::string& quantity, double least_gain);
  bool refine_what_is_too_wide();
  bool make_room_for_economy();
  bool refine(double share_of_tolerance, double most_times);
  void economise();
  [[nodiscard]] std::vector<ProvedTrack> proved_tracks() const;
  [[nodiscard]] CheapestProved cheapest() const;
  void want(const Resolution& resolution);
  void want_variants();
  void forget_old_answers();

  const PreparedCase& prepared_;
  StudyDepth depth_;
  Tracks now_;
  std::optional<Tracks> before_;  // the last refinement
  std::map<Resolution, ProbeAnswer> answers_;
  std::map<Resolution, Measures> measures_;
  std::map<Resolution, std::map<std::string, fem::StickDepths>>
      depths_;  // with StudyDepth::budget; not of worn profiles
  std::vector<Resolution> wanted_;
  int n_refinements_ = 0;
  bool has_room_ = false;  // as much as there is
  std::optional<Economy> economy_;
};

}  // namespace fretval
