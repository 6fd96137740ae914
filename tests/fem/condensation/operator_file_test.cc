#include "fem/condensation/operator_file.h"

#include <gtest/gtest.h>

#include "fem/support/solver_error.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::operator_file_test {
namespace {

StoredOperator stored_operator() {
  return {"made by the test\nin two lines\n",
          normal_half_space(16).compliance,
          {{"dofs", 1234}, {"a third", 1.0 / 3}, {"tiny", 5e-324}}};
}

std::string message_of(const std::string& file, const std::string& key = "") {
  try {
    operator_in(file, key);
  } catch (const OperatorFileError& error) {
    return error.what();
  }
  return "";
}

TEST(OperatorFile, ComesBackBitForBit) {
  const auto stored = stored_operator();
  const auto read = operator_in(operator_file(stored), stored.key);
  EXPECT_EQ(read.key, stored.key);
  EXPECT_EQ(read.figures, stored.figures);
  EXPECT_EQ(read.compliance.radii, stored.compliance.radii);
  EXPECT_EQ(read.compliance.areas, stored.compliance.areas);
  EXPECT_EQ(*read.compliance.matrix, *stored.compliance.matrix);
}

// The blocks of a surface have up to three components, one after the other.
TEST(OperatorFile, BlocksOfSeveralComponentsComeBack) {
  auto stored = stored_operator();
  const auto n = stored.compliance.areas.size();
  for (const Eigen::Index n_components : {2, 3}) {
    const Eigen::MatrixXd any = Eigen::MatrixXd::Random(n_components * n, n_components * n);
    stored.compliance.matrix = Eigen::MatrixXd(any + any.transpose());
    EXPECT_EQ(*operator_in(operator_file(stored), stored.key).compliance.matrix, *stored.compliance.matrix);
  }
}

// Processes that keep the same operator at once replace each other's files.
TEST(OperatorFile, IsTheSameBytesForTheSameOperator) {
  EXPECT_EQ(operator_file(stored_operator()), operator_file(stored_operator()));
}

// Half of the matrix, and little beside it.
TEST(OperatorFile, IsHardlyLargerThanWhatItHolds) {
  const auto stored = stored_operator();
  const auto n = stored.compliance.radii.size();
  const auto numbers = sizeof(double) * (2 * n + n * (n - 1) / 2);
  EXPECT_LT(operator_file(stored).size(), numbers + 6000);
}

TEST(OperatorFile, HasAKeyOfAnyLength) {
  auto stored = stored_operator();
  stored.key = std::string(100000, 'k');  // attributes of HDF5 end at 64 kB
  EXPECT_EQ(operator_in(operator_file(stored)).key, stored.key);
}

TEST(OperatorFile, NoFlippedBitIsTrusted) {
  const auto file = operator_file(stored_operator());
  for (std::size_t i = 0; i < file.size(); ++i) {
    auto flipped = file;
    flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 8)));
    EXPECT_NE(message_of(flipped), "") << "byte " << i;
  }
}

TEST(OperatorFile, NoTruncatedOrLongerFileIsTrusted) {
  const auto file = operator_file(stored_operator());
  for (std::size_t n = 0; n < file.size(); n += 97) EXPECT_NE(message_of(file.substr(0, n)), "") << n;
  EXPECT_EQ(message_of(file + '\0'), "its checksum is not that of its content");
}

TEST(OperatorFile, NothingElseIsTrusted) {
  EXPECT_EQ(message_of(""), "it is no file of an operator");
  EXPECT_EQ(message_of(std::string(5000, 'x')), "it is no file of an operator");
  const auto file = operator_file(stored_operator());
  EXPECT_EQ(message_of(file.substr(512)), "it is no file of an operator");
  EXPECT_EQ(message_of(file, "another key"), "it is another operator");
}

TEST(OperatorFile, IsOfSymmetricMatricesAlone) {
  auto stored = stored_operator();
  Eigen::MatrixXd matrix = *stored.compliance.matrix;
  matrix(0, 1) *= 1 + 1e-15;
  stored.compliance.matrix = matrix;
  EXPECT_THROW(operator_file(stored), SolverError);
}

// The check value of CRC-64/XZ in the catalogue of parametrised CRC algorithms.
TEST(OperatorFile, ItsChecksumIsCrc64Xz) {
  const std::string digits = "123456789";
  EXPECT_EQ(checksum(digits.data(), digits.size()), 0x995DC9BBDF1939FAU);
}

}  // namespace
}  // namespace fretval::fem::operator_file_test
