#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "comparison/accuracy/case_study.h"
#include "comparison/accuracy/verdict.h"
#include "comparison/simulation/body.h"

namespace fretval {

/// A case computed both ways.
struct CaseResult {
  Case scene;
  MdrCase mdr_case;
  FemCase fem_case;  ///< at the resolution that the study has chosen
  MdrAnswer mdr;
  StudyResult study;
  Comparison verdict;
};

/// The whole of result.json, with the keys of the documentation in docs/results.md.
nlohmann::ordered_json result_json(const CaseResult& outcome);

/// Removes the result.json of an earlier run from a folder, if there is one: without it a folder is no result.
void withdraw_result(const std::filesystem::path& folder);

/// Writes result.json, run.json, history.csv, contact.csv, profile.csv and, if the case asks for fields, the VTU files
/// into a folder, which is made if need be; result.json comes last. make_body: for the fields, which need the whole
/// body once more.
void write_result(const CaseResult& outcome, const mdr::NormalResponse& reference, const std::filesystem::path& folder,
                  const std::function<Body(const BodySpecification&)>& make_body);

}  // namespace fretval
