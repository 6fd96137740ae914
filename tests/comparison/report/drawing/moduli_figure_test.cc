#include "comparison/report/drawing/moduli_figure.h"

#include <gtest/gtest.h>

#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

TEST(ModuliFigure, SaysHowWellABodyStandsForMeasuredModuli) {
  const ScratchFolder folder;
  StoredResult result{stored_result("single"), folder.path()};
  folder.write("moduli.csv", "f [Hz],G' [Pa],G'' [Pa]\n1,1,1\n10,2,1\n");
  folder.write("measured_moduli.csv", "f [Hz],G' [Pa],G'' [Pa]\n3,1.5,1.25\n");
  auto& fit = result.json["scene"]["fit_of_moduli"];
  fit = {{"residual", 0.012}, {"worst", 0.03}, {"worst_frequency", 4.0}, {"kramers_kronig", nullptr}};
  const auto sparse = filling_of({moduli_figure(result)}).dump();
  for (const char* part : {"by 1.2 %", "most at 4 Hz by 3 %", "too sparse", "\"x\":[3.0],\"y\":[1.25]"})
    EXPECT_NE(sparse.find(part), std::string::npos) << part;
  fit["kramers_kronig"] = {{"consistent", false}};
  EXPECT_NE(filling_of({moduli_figure(result)}).dump().find("contradict each other"), std::string::npos);
}

}  // namespace
}  // namespace fretval
