#pragma once

#include <string>
#include <vector>

#include "comparison/case/case.h"
#include "mdr/profiles/profile.h"

namespace fretval {

/// Warnings about values of a case that are possible but look like a wrong unit: a relaxed modulus that no elastomer
/// has, and an indenter whose surface rises far more, or far less, at the edge of the contact than where contacts are
/// measured. The rise is f'(a), which for a parabola is a/R. Also about a motion at frequencies that a table of moduli
/// does not have, a table whose heights are noisy (table_noise.h), a path that begins in a noisy row (table_noise.h),
/// motions in which the contact opens, and about a parabola at an a/R where a sphere of that radius would have another
/// contact radius: d = a²/R against d = (a/2) ln((R+a)/(R-a)), which at one indentation differ by about (a/R)²/6; and
/// about a scan through the apex whose halves differ.
std::vector<std::string> implausible_values(const Case& input, const mdr::Profile& profile);

/// What to look at where a history does not become periodic: a relaxed modulus that no elastomer has, or that is a
/// thousandth of a branch, as if one in MPa were written in Pa. Empty: the modulus is not the reason.
std::string hint_at_modulus(const Case& input);

}  // namespace fretval
