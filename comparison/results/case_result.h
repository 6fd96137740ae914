#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "comparison/accuracy/proof.h"
#include "comparison/accuracy/rings_needed.h"
#include "comparison/accuracy/surface_wear_proof.h"
#include "comparison/accuracy/wear_proof.h"
#include "comparison/model_error/model_error.h"
#include "comparison/reference/mdr_answer.h"

namespace fretval {

/// A case computed both ways.
struct CaseResult {
  Case input;
  MdrCase mdr_case;
  FemCase fem_case;  ///< at the resolution that the proof has chosen
  MdrAnswer mdr;
  Proof proof;
  ProvedAnswer fe;
  Comparison comparison;  ///< of all quantities; empty: MDR does not hold
  std::optional<ProvedWear> wear = {};
  std::optional<ProvedSurfaceWear> surface_wear = {};
  std::optional<MdrAnswer> half_space = {};  ///< MDR's answer over a half-space in the place of another body
  std::optional<GivenRings> rings = {};      ///< rings of a given mesh
  ModelErrors model = {};                    ///< how good MDR is as a model

  [[nodiscard]] bool is_compared() const { return fem_case.kind != ContactKind::annuli; }
};

/// The outcome of a case. If one method finds gross slip, the other has to find it, too, as have both where the balance
/// of forces demands it (steady_sliding_share); neither may begin to slide below that share.
Outcome outcome_of(const CaseResult& result);

/// The result of a case from the answers of both methods, compared if MDR holds for it.
CaseResult result_of(const PreparedCase& prepared, MdrAnswer&& mdr, Proof proof, ProvedAnswer&& fe);

/// Adds the wear of the indenter to a result.
void add_wear(ProvedWear&& wear, CaseResult& result);

/// The whole of result.json, with the keys of the documentation in docs/results.md.
nlohmann::ordered_json result_json(const CaseResult& result);

/// cycle.json, what happens under the indenter in the last period, SI units:
///   r      outer radii of the rings
///   t      instants, at most 48, the end of the period among them; p and tau of the rings, a list an instant
///   zones  a text a step, at most 360, a letter a ring: o open, s sticks, f and b slips forward and backward
///   mdr    of an unworn indenter: r, and p, tau at the largest indentation; d, u_x, F_N, F_x over the period;
///          friction_work in J per period
/// mdr is from springs; not there if they do not become periodic, or for a point of a sweep.
/// Five digits of each number.
nlohmann::ordered_json cycle_json(const CaseResult& result);

/// Cost of an answer of the finite elements: seconds (mesh, assembly, factorisation, normal_history, friction_history),
/// dofs, contact_nodes, time_steps, cycles.
nlohmann::ordered_json cost_json(const FeAnswer& fe);

/// Removes the result.json of an earlier run from a folder, if there is one: without it a folder is no result.
void withdraw_result(const std::filesystem::path& folder);

/// json: result_json of the result. reference: MDR's normal response, for a case that is compared.
///
/// Writes result.json, run.json, history.csv, contact.csv, cycle.json, profile.csv and, if the case asks for fields,
/// those (field_files.h), which need the whole body, into a folder, which is made if need be; result.json comes last.
void write_result(const CaseResult& result, const nlohmann::ordered_json& json, const mdr::NormalResponse& reference,
                  const std::filesystem::path& folder);

}  // namespace fretval
