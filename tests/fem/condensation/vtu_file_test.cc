#include "fem/condensation/vtu_file.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/fem/vtu_data.h"

namespace fretval::fem::vtu_file_test {
namespace {

/// A square of so many by so many cells at x, each value that of its component and point.
Patch square_at(double x, unsigned n, unsigned n_components) {
  Patch patch = new_patch(n, n_components);
  patch.vertices[0] = {x, 0, 2};
  patch.vertices[1] = {x + 1, 0, 2};
  patch.vertices[2] = {x, 1, 2};
  patch.vertices[3] = {x + 1, 1, 2};
  for (unsigned c = 0; c < n_components; ++c)
    for (unsigned q = 0; q < patch.data.n_cols(); ++q) patch.data(c, q) = static_cast<float>(10 * c + q);
  return patch;
}

std::string file_of(const std::vector<Patch>& patches, const std::vector<Field>& fields) {
  std::ostringstream stream;
  write_vtu(patches, fields, stream);
  return stream.str();
}

TEST(VtuFile, HasThePointsAndFieldsOfItsPatches) {
  const std::string file = file_of({square_at(0, 1, 4), square_at(5, 1, 4)}, {{"u (m)", 3}, {"p (Pa)", 1}});
  EXPECT_NE(file.find("NumberOfPoints=\"8\" NumberOfCells=\"2\""), std::string::npos);
  const auto points = vtu_data(file, ""), vectors = vtu_data(file, "u (m)");
  EXPECT_EQ(std::vector<float>(points.begin(), points.begin() + 6), (std::vector<float>{0, 0, 2, 1, 0, 2}));
  EXPECT_EQ(points[12], 5);
  EXPECT_EQ(std::vector<float>(vectors.begin(), vectors.begin() + 6), (std::vector<float>{0, 10, 20, 1, 11, 21}));
  EXPECT_EQ(vtu_data(file, "p (Pa)"), (std::vector<float>{30, 31, 32, 33, 30, 31, 32, 33}));
}

TEST(VtuFile, CountsTheCellsInsideAPatch) {
  EXPECT_NE(file_of({square_at(0, 3, 1)}, {{"p", 1}}).find("NumberOfPoints=\"16\" NumberOfCells=\"9\""),
            std::string::npos);
}

TEST(VtuFile, HasTensors) {
  const std::string file = file_of({square_at(0, 1, 9)}, {{"stress (Pa)", 9}});
  EXPECT_NE(file.find("Name=\"stress (Pa)\" NumberOfComponents=\"9\""), std::string::npos);
  const auto tensors = vtu_data(file, "stress (Pa)");
  EXPECT_EQ(std::vector<float>(tensors.begin(), tensors.begin() + 9),
            (std::vector<float>{0, 10, 20, 30, 40, 50, 60, 70, 80}));
}

TEST(VtuFile, ListsTheStepsOfASeries) {
  std::ostringstream stream;
  write_pvd({{0.5, "a.vtu"}, {0.75, "b.vtu"}}, stream);
  const auto first = stream.str().find("timestep=\"0.5\" group=\"\" part=\"0\" file=\"a.vtu\""),
             second = stream.str().find("timestep=\"0.75\" group=\"\" part=\"0\" file=\"b.vtu\"");
  EXPECT_NE(first, std::string::npos) << stream.str();
  EXPECT_NE(second, std::string::npos);
  EXPECT_LT(first, second);
}

}  // namespace
}  // namespace fretval::fem::vtu_file_test
