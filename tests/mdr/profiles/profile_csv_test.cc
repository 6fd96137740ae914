#include "mdr/profiles/profile_csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

namespace fretval::mdr::profile_csv_test {
namespace {

Profile read(const std::string& text, double noise = 0) {
  std::istringstream stream(text);
  return read_profile_table(stream, "scan.csv", noise);
}

std::string error_of(const std::string& text, double noise = 0) {
  try {
    read(text, noise);
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(ProfileCsv, ReadsMetresAndNamedUnits) {
  EXPECT_NEAR(shape(read("0,5\n1,6\n2,9\n3,14\n"), 2), 4, 1e-14);
  const std::string rows = "0,0\n1,1\n2,4\n3,9\n";
  const struct {
    const char* header;
    double radius, height;
  } units[] = {{"r,f\nmm,um\n", 1e-3, 1e-6},
               {"r [m]; f [nm]\n", 1, 1e-9},
               {"r (mm),f (\u00b5m)\n", 1e-3, 1e-6},
               {"r,f\n[\u03bcm],[m]\n", 1e-6, 1},
               {"r,f\n", 1, 1}};
  for (const auto& unit : units) {
    const Profile profile = read(unit.header + rows);
    EXPECT_NEAR(end_radius(profile) / unit.radius, 3, 1e-14) << unit.header;
    EXPECT_NEAR(shape(profile, 2 * unit.radius) / unit.height, 4, 1e-13) << unit.header;
  }
}

TEST(ProfileCsv, FitsANoisyScan) {
  std::mt19937 random(1);
  std::normal_distribution<double> scatter(0, 0.1);
  std::ostringstream text;
  text << "r,f\nmm,um\n";
  for (int k = 3; k < 200; ++k) text << 0.01 * k << "," << 50 * std::pow(0.01 * k, 2) + scatter(random) << "\n";
  const Profile profile = read(text.str(), 1e-7);
  EXPECT_NEAR(transform(profile, 1.5e-3) / transform(parabola(1e-2), 1.5e-3), 1, 2e-3);  // noise/height
  EXPECT_NE(error_of(text.str()).find("line 3: radius = 0.03: must be 0"), std::string::npos) << error_of(text.str());
  EXPECT_NE(error_of(text.str(), 1e-8).find("scan.csv: profile table at r in m"), std::string::npos);
}

// A profilometer's line over a parabola of which one half is 2 % higher, in units of its own.
TEST(ProfileCsv, TakesTheMeanOfATwoSidedScan) {
  std::ostringstream text;
  text << "r,f\nmm,um\n";
  for (int k = -20; k <= 24; ++k) text << 0.1 * k << "," << 7 + (k < 0 ? 51 : 49) * 0.01 * k * k << "\n";
  const Profile profile = read(text.str());
  EXPECT_NEAR(end_radius(profile), 2e-3, 1e-15);
  EXPECT_NEAR(shape(profile, 1e-3), 5e-5, 1e-16);
  std::istringstream stream(text.str());
  const auto rows = read_profile_rows(stream, "scan.csv");
  EXPECT_EQ(rows.r.size(), 21U);
  EXPECT_NEAR(rows.halves.value().largest_difference, 8e-6, 1e-15);
  EXPECT_NEAR(rows.halves->radius_of_difference, 2e-3, 1e-15);
  std::istringstream outwards("0,0\n1,1\n2,4\n3,9\n");
  EXPECT_FALSE(read_profile_rows(outwards, "scan.csv").halves);
}

// Found by fuzzing: slopes between such heights overflow.
TEST(ProfileCsv, RefusesHeightsBeyondTheRangeOfSlopes) {
  std::istringstream stream("r,f\nmm,um\n0,5\n1,1\n2,1e308\n8,46\n");
  try {
    read_profile_table(stream, "table.csv");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("table.csv: profile table at r in m"), std::string::npos) << error.what();
  }
}

TEST(ProfileCsv, ErrorsNameSourceAndPlace) {
  const struct {
    const char* text;
    const char* named;
  } tables[] = {
      {"r,f\n0,0\n1,1\n# gap\n0.5,2\n3,9\n", "scan.csv, line 5: radius = 0.5: must be greater"},
      {"0,0\n1,1\n1,1\n3,9\n", "scan.csv, line 3: radius = 1: must not be that of the row before"},
      {"-1,0\n1,1\n2,4\n3,9\n", "scan.csv, line 2: radius = 1: must be 0, the axis"},
      {"-2,4\n-1,1\n", "scan.csv: rows of a two-sided scan with r >= 0 = 0: must be at least 2"},
      {"r,f\nmm,mm\n-2,4\n-1,1\n0,0\n1,1.3\n2,4\n",
       "scan.csv: the halves of the scan differ by 0.0003 m at r = 0.001 m"},
      {"0.1,0\n1,1\n2,4\n3,9\n", "scan.csv, line 1: radius = 0.1: must be 0, the axis"},
      {"0,0\n1,x\n", "scan.csv, line 2"},
      {"0,0,1\n", "scan.csv, line 1"},
      {"r [inch],f [m]\n0,0\n1,1\n2,4\n3,9\n", "scan.csv: unit of column 1 = \"inch\": must be one of"},
      {"0,0\n1,1\n2,4\n", "scan.csv: profile table of 3 radii"},
      {"0,0\n1,1\n1.9,3\n2,1\n2.1,3.2\n3,9\n", "scan.csv: profile table at r in m = "},
  };
  for (const auto& table : tables) {
    const std::string error = error_of(table.text);
    EXPECT_NE(error.find(table.named), std::string::npos) << error;
  }
  EXPECT_NE(error_of("0,0\n1,1\n2,4\n3,9\n", -1).find("noise"), std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::profile_csv_test
