#include "comparison/simulation/bodies/operator_key.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "comparison/support/versions.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/small_body.h"

namespace fretval::operator_key_test {
namespace {

using fem::axisymmetric;
using fem::FourierOrder;
using fem::lateral;

TEST(OperatorKey, IsAnotherOneForEverythingThatAnOperatorDependsOn) {
  std::vector<BodyDescription> bodies(6, small_body());
  bodies[1].contact_nodes[2] = std::nextafter(bodies[1].contact_nodes[2], 1);
  bodies[2].contact_nodes.push_back(1.25);
  bodies[3].growth = std::nextafter(bodies[3].growth, 1);
  bodies[4].far_radius = std::nextafter(bodies[4].far_radius, 100);
  bodies[5].degree = 3;
  std::set<std::string> keys;
  for (const auto& body : bodies)
    for (const auto order : {axisymmetric, lateral}) keys.insert(operator_key(body, order));
  for (const int n_processes : {2, 3}) keys.insert(operator_key(small_body(), axisymmetric, n_processes));
  EXPECT_EQ(keys.size(), 2 * bodies.size() + 2);
}

/// What the build makes of a source and flags.
std::string hash_of(const std::string& source, const std::string& flags) {
  const ScratchFolder folder;
  folder.write("a.cc", source);
  const auto run = shell_run("cmake -DOUTPUT=" + quoted(folder.path() / "hash.h") + " -DROOT=" + quoted(folder.path()) +
                                 " -DNAME=FRETVAL_OPERATORS_HASH -DSOURCES=a.cc -DBUILD=" + quoted(flags) +
                                 " -P " FRETVAL_SOURCE_DIR "/cmake/sources_hash.cmake",
                             folder);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return text_of(folder.path() / "hash.h");
}

TEST(OperatorKey, ItsHashIsAnotherOneForOtherSourcesAndFlags) {
  const auto hash = hash_of("int i = 1;", "GNU -O3");
  EXPECT_EQ(hash_of("int i = 1;", "GNU -O3"), hash);
  EXPECT_NE(hash_of("int i = 2;", "GNU -O3"), hash);
  EXPECT_NE(hash_of("int i = 1;", "GNU -O2"), hash);
}

// A harmonic does not know whether there is another one.
TEST(OperatorKey, IsTheSameForBodiesWithOneHarmonicAndWithBoth) {
  EXPECT_EQ(operator_key(small_body(true), axisymmetric), operator_key(small_body(false), axisymmetric));
}

TEST(OperatorKey, NamesVersionsAndKernels) {
  const auto key = operator_key(small_body(), axisymmetric);
  for (const auto& [name, version] : versions()) expect_parts(key, {name + " " + version + "\n"});
  expect_parts(key, {"kernels OpenBLAS", "order 0"});
  EXPECT_EQ(key.find("operators "), 0U);
  EXPECT_EQ(key.find('\n'), std::string("operators ").size() + 64) << "a SHA-256 of the sources";
}

TEST(OperatorKey, TellsItsHarmonicAndWhetherThisProgramMadeIt) {
  const auto key = operator_key(small_body(), lateral);
  EXPECT_TRUE(is_of_harmonic(key, lateral));
  EXPECT_FALSE(is_of_harmonic(key, axisymmetric));
  EXPECT_TRUE(is_of_this_version(key));
  auto other = key;
  other[15] = other[15] == '0' ? '1' : '0';
  EXPECT_FALSE(is_of_this_version(other));
}

}  // namespace
}  // namespace fretval::operator_key_test
