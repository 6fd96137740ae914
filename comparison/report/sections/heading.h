#pragma once

#include <set>
#include <string>
#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// What a page begins with, for its template: "title", the name of the case or what several are; "date" of the newest
/// result; "libraries" and "citation" of the program; "earlier", how many results are not of the run that writes the
/// page. of_this_run: names of its cases; empty: not known, and nothing is told. no_results: the title of a page
/// without any.
Filling heading_of(const std::vector<StoredResult>& results, const std::set<std::string>& of_this_run,
                   const std::string& no_results);

}  // namespace fretval
