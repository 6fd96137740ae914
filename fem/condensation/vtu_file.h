#pragma once

#include <deal.II/base/data_out_base.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace fretval::fem {

/// A piece of a surface in space with its values: scalars, vectors and tensors, one component after the other.
using Patch = dealii::DataOutBase::Patch<2, 3>;

/// A quadrilateral patch of n by n cells, with n_components values at each of its (n + 1)^2 points, all 0.
Patch new_patch(unsigned n, unsigned n_components);

/// A field of a file: its name with its unit, and 1, 3 or 9 components.
struct Field {
  std::string name;
  unsigned n_components = 1;
};

/// Writes patches and their fields, in their order, in the VTU format. The same patches give the same bytes.
void write_vtu(const std::vector<Patch>& patches, const std::vector<Field>& fields, std::ostream& stream);

/// A step of a series: its time in s, and a file, relative to that of the series.
using SeriesStep = std::pair<double, std::string>;

/// Writes a list of the files of a series in the PVD format, which ParaView opens as one data set.
void write_pvd(const std::vector<SeriesStep>& steps, std::ostream& stream);

}  // namespace fretval::fem
