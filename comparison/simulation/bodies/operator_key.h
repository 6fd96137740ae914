#pragma once

#include <string>

#include "comparison/simulation/fem_case/fem_case.h"
#include "fem/operators/fourier_order.h"

namespace fretval {

/// Everything that a condensed operator on a generated mesh depends on, down to its last bit, in lines of text: the
/// description of its body (all digits), the Fourier order, the versions of the libraries, the kernels that OpenBLAS
/// chooses for this processor, and a hash of the sources that make operators with the compiler and its flags. The hash
/// is renewed by every build, so that no version number has to be maintained; after a changed comment operators are
/// made once more. n_processes: number of processes that make it together, which decides the order of sums.
std::string operator_key(const BodyDescription& description, const fem::FourierOrder& order, int n_processes = 1);

/// The key of an operator of an order over all components of a surface, see fem::surface_block.
std::string surface_key(const BodyDescription& description, const fem::FourierOrder& order);

/// Whether a key belongs to an operator of this harmonic, and whether this program on this processor could have made
/// it.
bool is_of_harmonic(const std::string& key, const fem::FourierOrder& order);
bool is_of_this_version(const std::string& key);

}  // namespace fretval
