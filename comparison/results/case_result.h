#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/accuracy/proof.h"
#include "comparison/accuracy/rings_needed.h"
#include "comparison/accuracy/surface_wear_proof.h"
#include "comparison/accuracy/wear_proof.h"
#include "comparison/case/case.h"
#include "comparison/model_error/model_error.h"
#include "comparison/reference/half_space.h"
#include "comparison/simulation/fe_answer.h"
#include "mdr/rheology/prony_body.h"

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

/// The outcome of a case, with or without gross slip.
Outcome outcome_of(const CaseResult& result);

/// The result of a case from the answers of both methods, compared if MDR holds for it.
CaseResult result_of(const PreparedCase& prepared, MdrAnswers&& mdr, Proof proof, ProvedAnswer&& fe);

/// Adds the wear of the indenter to a result.
void add_wear(ProvedWear&& wear, CaseResult& result);

/// The whole of result.json, with the keys of the documentation in docs/results.md.
nlohmann::ordered_json result_json(const CaseResult& result);

/// cycle.json, what happens under the indenter in the last period, see docs/results.md. SI units, five digits of each
/// number; at most 48 instants, the end of the period among them, and the zones of at most 360 steps. mdr is from
/// springs, and not there if these do not become periodic.
nlohmann::ordered_json cycle_json(const CaseResult& result);

/// Cost of an answer of the finite elements: seconds (mesh, assembly, factorisation, normal_history, friction_history),
/// dofs, contact_nodes, time_steps, cycles.
nlohmann::ordered_json cost_json(const FeAnswer& fe);

/// Removes the result.json of an earlier run from a folder, if there is one: without it a folder is no result.
void withdraw_result(const std::filesystem::path& folder);

/// json: result_json of the result. reference: MDR's normal response, for a case that is compared.
///
/// Writes result.json, run.json, history.csv, contact.csv, cycle.json, profile.csv and, if the case asks for fields,
/// those, which need the whole body, into a folder, which is made if need be; result.json comes last.
void write_result(const CaseResult& result, const nlohmann::ordered_json& json, const mdr::NormalResponse& reference,
                  const std::filesystem::path& folder);

/// The key "zones" of finite elements in result.json where zones are annuli, see docs/results.md; SI units. length: the
/// unit of the bars, m.
nlohmann::ordered_json zones_json(const ZoneAnswer& zones, const std::optional<ZoneBudget>& bars, double length);

/// The key "zones" of a case of any kind, for the contact on rings and angles see docs/full_contact.md; SI units. Null:
/// zones are discs.
nlohmann::ordered_json zones_json(const CaseResult& result);

/// The key "not_compared": where the image of the profile falls, and the errors that MDR's springs would make
/// (mdr::naive_contact) for the relaxed body at rest at the largest indentation. SI units.
nlohmann::ordered_json not_compared_json(const CaseResult& result);

const char* name_of(fem::WearEnd end);

/// Lists of the values at all points of a course; SI units.
nlohmann::ordered_json course_json(const fem::WearCourse& course, const Units& units);

/// "fe.wear" of result.json, see docs/results.md; SI units.
nlohmann::ordered_json to_json(const ProvedWear& wear, const Units& units);

/// worn_profile.csv: radius and height of the worn indenter, from the centre on, as Wear / Profile and a table of an
/// indenter take it. worn_rings.csv: what each ring has lost, as Wear / Worn rings takes it. wear.csv: by ring the
/// heights at some states of the course, and the largest pressures at its start, when half of the volume is worn off,
/// and at its end. NAME-worn.prm: the case that goes on from there, not for a point of a sweep.
void write_wear(const ProvedWear& wear, const Case& input, const Units& units, const std::filesystem::path& folder);

/// The "surface_wear" object of result.json, see docs/results.md; SI units.
nlohmann::ordered_json to_json(const ProvedSurfaceWear& wear, const Units& units);

/// worn_surface.csv: at each point of rings and angles the height of the indenter before wear and at its end, and the
/// largest pressure of the last cycle.
void write_surface_wear(const ProvedSurfaceWear& wear, const Units& units, const std::filesystem::path& folder);

/// history.csv, surface.csv, surface.vtu and zones.csv of the contact on rings and angles, of its last cycle, see
/// docs/full_contact.md; SI units. Motions are those at the ends of the steps, forces those of their balance.
void write_surface_files(const FeAnswer& fe, const FemCase& fem, const std::filesystem::path& folder);

/// Writes fields of the last period of an answer into a folder, for ParaView: fields.pvd, the plane in which the
/// indenter moves, and surface.pvd, the surface around it, which list fields/section-NN.vtu and fields/surface-NN.vtu,
/// see fem/condensation/meridian_section.h and revolved_surface.h. Such files of an earlier run are removed; with
/// Fields::none, or for an answer in which the whole contact slides, nothing else is done. fem_case: the case at the
/// resolution of the answer.
void write_field_files(const FeAnswer& fe, const FemCase& fem_case, Case::Fields fields,
                       const std::filesystem::path& folder);

/// Writes the data from which the input of a case was made: trace.csv and aligned_profile.csv of a trace that was
/// aligned, and measured_loops.csv of what a rig has measured.
void write_data(const Case& input, const std::filesystem::path& folder);

/// How the data of a case were processed, for scene.data of result.json: trace, record, test_duration, hardness; and
/// measured radii, with their uncertainties. SI units. An empty object: they were taken as they are.
nlohmann::ordered_json data_json(const Case& input);

/// Writes moduli.csv: storage and loss modulus of a body with memory over the frequencies of the motion, of its
/// branches and of the measured moduli, and a decade beyond on either side. measured_moduli.csv: what was measured, at
/// the temperature of the case. Neither for an elastic body.
void write_moduli(const Case& input, const mdr::PronyBody& body, const std::filesystem::path& folder);

/// "measured" of result.json: value and uncertainty of each quantity that the rig has measured, the values of both
/// methods, and their differences from it. From loops come the largest forces and the work in a loop of F_x over u_x.
/// fe, mdr: their objects in result.json. SI units. Null: nothing was measured.
nlohmann::ordered_json measured_json(const Case& input, const nlohmann::ordered_json& fe,
                                     const nlohmann::ordered_json& mdr);

}  // namespace fretval
