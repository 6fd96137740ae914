#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <string>
#include <vector>

namespace fretval {

/// Writes a whole file: next to its place first, then renamed, so that no reader ever sees half of it.
/// Throws std::filesystem::filesystem_error.
void write_file(const std::filesystem::path& file, const std::string& content);

/// The content of a file, byte for byte; empty if it cannot be read.
std::string content_of(const std::filesystem::path& file);

/// One column of a CSV file; its name carries the unit, for example "r [m]".
struct Column {
  std::string name;
  Eigen::VectorXd values;
};

/// Columns of equal length; 17 digits give the same numbers again.
void write_csv(const std::filesystem::path& file, const std::vector<Column>& columns, int n_digits = 10);

}  // namespace fretval
