#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// A condensed operator as it is kept in a file.
struct StoredOperator {
  std::string key;  ///< everything that it depends on, as text
  Compliance compliance;
  std::map<std::string, double> figures;  ///< numbers by name that describe the body it was condensed from
};

/// Thrown for bytes that are not the file of an operator, are incomplete or damaged, or belong to another operator.
struct OperatorFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The file of an operator: a block of 512 bytes, then an HDF5 file, which HDF5's own tools find behind the block.
///
/// HDF5: datasets `key`, `radii`, `areas` and `compliance` (lower triangle, row after row; the matrix is symmetric bit
/// for bit), and an attribute for each figure. The block says how many bytes follow and their CRC-64, which tells every
/// flipped byte and every burst of up to 64 bits: HDF5 1.10 guards neither its data nor its metadata; of 18,000 flipped
/// bits in a small file it took 2843 for another matrix, hung twice and crashed once. Therefore HDF5 reads nothing
/// whose checksum is wrong.
///
/// Throws SolverError if the matrix is not symmetric.
std::string operator_file(const StoredOperator& stored);

/// The operator in the bytes of a file, equal to the one that was written bit for bit. key: that of the operator that
/// is wanted; empty: any operator will do. Throws OperatorFileError. Threads wait for each other: Debian's HDF5 is not
/// safe for them.
StoredOperator operator_in(const std::string& file, const std::string& key = "");

/// CRC-64/XZ of n bytes.
std::uint64_t checksum(const char* bytes, std::size_t n);

}  // namespace fretval::fem
