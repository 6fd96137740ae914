#include "comparison/support/versions.h"

#include <gtest/gtest.h>

#include <cctype>

namespace fretval {
namespace {

TEST(Versions, AreNumbersOfFretvalAndItsLibraries) {
  std::vector<std::string> names;
  for (const auto& [name, version] : versions()) {
    names.push_back(name);
    ASSERT_FALSE(version.empty()) << name;
    EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(version[0]))) << name << " " << version;
    EXPECT_NE(version.find('.'), std::string::npos) << name << " " << version;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"fretval", "deal.II", "PETSc", "MUMPS", "gmsh", "Eigen"}));
}

}  // namespace
}  // namespace fretval
