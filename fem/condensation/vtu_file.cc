#include "fem/condensation/vtu_file.h"

#include <deal.II/grid/reference_cell.h>

#include <tuple>

namespace fretval::fem {
namespace {

namespace interpretation = dealii::DataComponentInterpretation;
using Range = std::tuple<unsigned, unsigned, std::string, interpretation::DataComponentInterpretation>;

}  // namespace

Patch new_patch(unsigned n, unsigned n_components) {
  Patch patch;
  patch.reference_cell = dealii::ReferenceCells::Quadrilateral;
  patch.n_subdivisions = n;
  patch.data.reinit(n_components, (n + 1) * (n + 1));
  return patch;
}

void write_vtu(const std::vector<Patch>& patches, const std::vector<Field>& fields, std::ostream& stream) {
  std::vector<std::string> names;
  std::vector<Range> ranges;
  for (const auto& [name, n] : fields) {
    const auto first = static_cast<unsigned>(names.size());
    if (n > 1)
      ranges.emplace_back(
          first, first + n - 1, name,
          n == 3 ? interpretation::component_is_part_of_vector : interpretation::component_is_part_of_tensor);
    names.insert(names.end(), n, name);
  }
  dealii::DataOutBase::VtkFlags flags;
  flags.print_date_and_time = false;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  dealii::DataOutBase::write_vtu(patches, names, ranges, flags, stream);
}

void write_pvd(const std::vector<SeriesStep>& steps, std::ostream& stream) {
  dealii::DataOutBase::write_pvd_record(stream, steps);
}

}  // namespace fretval::fem
