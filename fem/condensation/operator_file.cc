#include "fem/condensation/operator_file.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <mutex>
#include <utility>

#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

constexpr std::size_t block_size = 512;  // the smallest that HDF5 looks behind
constexpr const char* block_format = "fretval operator 1: CRC-64/XZ {:016x} of the {} bytes after the first 512\n";

/// An object of HDF5, closed with it.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw OperatorFileError("HDF5 does not find in it what an operator has");
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Returns the result of a call of HDF5, and throws if it is negative.
template <class Status>
Status checked(Status status) {
  if (status < 0) throw OperatorFileError("HDF5 fails");
  return status;
}

/// Guards HDF5, which has one error stack and one of everything else for all threads.
std::unique_lock<std::mutex> hdf5_for_this_thread() {
  static std::mutex mutex;
  std::unique_lock<std::mutex> lock(mutex);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return lock;
}

/// Access properties of a file that exists in memory alone.
hid_t access_in_memory() {
  constexpr std::size_t increment = 1 << 16;
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  checked(H5Pset_fapl_core(access, increment, false));
  return access;
}

/// Creation properties of a dataset without times: equal operators give equal bytes.
hid_t timeless() {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  checked(H5Pset_obj_track_times(creation, false));
  return creation;
}

void write_numbers(hid_t file, const char* name, const double* numbers, std::size_t n) {
  const hsize_t size = n;
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle creation(timeless(), H5Pclose);
  const Handle set(H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
  checked(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers));
}

std::vector<double> numbers_in(hid_t file, const char* name) {
  const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(set), H5Sclose);
  std::vector<double> numbers(static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space))));
  checked(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()));
  return numbers;
}

// A key is a dataset, because attributes end at 64 kB.
void write_key(hid_t file, const std::string& key) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  checked(H5Tset_size(type, key.size() + 1));
  const Handle creation(timeless(), H5Pclose);
  const Handle set(H5Dcreate2(file, "key", type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
  checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, key.c_str()));
}

std::string key_in(hid_t file) {
  const Handle set(H5Dopen2(file, "key", H5P_DEFAULT), H5Dclose);
  const Handle type(H5Dget_type(set), H5Tclose);
  std::string key(H5Tget_size(type), '\0');
  checked(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, key.data()));
  key.resize(std::min(key.size(), key.find('\0')));
  return key;
}

void write_figure(hid_t file, const std::string& name, double figure) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  checked(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &figure));
}

herr_t add_figure(hid_t file, const char* name, const H5A_info_t*, void* figures) {
  const hid_t attribute = H5Aopen(file, name, H5P_DEFAULT);
  double figure = 0;
  const herr_t status = attribute < 0 ? -1 : H5Aread(attribute, H5T_NATIVE_DOUBLE, &figure);
  H5Aclose(attribute);
  (*static_cast<std::map<std::string, double>*>(figures))[name] = figure;
  return status;
}

std::vector<double> lower_triangle(const Eigen::MatrixXd& matrix) {
  std::vector<double> packed;
  packed.reserve(static_cast<std::size_t>(matrix.rows() * (matrix.rows() + 1) / 2));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j) packed.push_back(matrix(i, j));
  return packed;
}

/// The matrix whose lower triangle is packed row after row; its rows have to be a multiple of n_rings, one set for each
/// component.
Eigen::MatrixXd symmetric_matrix(const std::vector<double>& packed, Eigen::Index n_rings) {
  const auto rows_of_triangle = std::sqrt(2.0 * static_cast<double>(packed.size()) + 0.25) - 0.5;
  const auto n = static_cast<Eigen::Index>(std::lround(rows_of_triangle));
  if (n == 0 || n % n_rings != 0 || packed.size() != static_cast<std::size_t>(n * (n + 1) / 2))
    throw OperatorFileError(fmt::format("its compliance has {} numbers, for {} rings", packed.size(), n_rings));
  Eigen::MatrixXd matrix(n, n);
  auto next = packed.begin();
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) matrix(i, j) = matrix(j, i) = *next++;
  return matrix;
}

std::string hdf5_image(const StoredOperator& stored) {
  const auto lock = hdf5_for_this_thread();
  const auto& [radii, areas, matrix, half_space] = stored.compliance;
  const Handle access(access_in_memory(), H5Pclose), creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  checked(H5Pset_obj_track_times(creation, false));
  const Handle file(H5Fcreate("operator", H5F_ACC_TRUNC, creation, access), H5Fclose);
  write_key(file, stored.key);
  for (const auto& [name, figure] : stored.figures) write_figure(file, name, figure);
  write_numbers(file, "radii", radii.data(), radii.size());
  write_numbers(file, "areas", areas.data(), static_cast<std::size_t>(areas.size()));
  const auto packed = lower_triangle(matrix);
  write_numbers(file, "compliance", packed.data(), packed.size());
  checked(H5Fflush(file, H5F_SCOPE_LOCAL));
  std::string image(static_cast<std::size_t>(checked(H5Fget_file_image(file, nullptr, 0))), '\0');
  checked(H5Fget_file_image(file, image.data(), image.size()));
  return image;
}

StoredOperator operator_in_image(const std::string& file) {
  const auto lock = hdf5_for_this_thread();
  const Handle access(access_in_memory(), H5Pclose);
  // HDF5 copies what it is given, and does not write to it.
  checked(H5Pset_file_image(access, const_cast<char*>(file.data()), file.size()));
  const Handle opened(H5Fopen("operator", H5F_ACC_RDONLY, access), H5Fclose);
  StoredOperator stored{key_in(opened), {}, {}};
  checked(H5Aiterate2(opened, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add_figure, &stored.figures));
  auto& [radii, areas, matrix, half_space] = stored.compliance;
  radii = numbers_in(opened, "radii");
  const auto read_areas = numbers_in(opened, "areas");
  areas = Eigen::Map<const Eigen::VectorXd>(read_areas.data(), static_cast<Eigen::Index>(read_areas.size()));
  if (radii.size() != read_areas.size() + 1)
    throw OperatorFileError(fmt::format("it has {} radii and {} areas", radii.size(), read_areas.size()));
  matrix = symmetric_matrix(numbers_in(opened, "compliance"), areas.size());
  return stored;
}

std::string block_of(const char* bytes, std::size_t n) {
  std::string block = fmt::format(block_format, checksum(bytes, n), n);
  block.resize(block_size, ' ');
  return block;
}

}  // namespace

std::uint64_t checksum(const char* bytes, std::size_t n) {
  constexpr auto all = ~std::uint64_t{0};
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, all, all, true, true> crc;
  crc.process_bytes(bytes, n);
  return crc.checksum();
}

std::string operator_file(const StoredOperator& stored) {
  const Eigen::MatrixXd& matrix = *stored.compliance.matrix;
  if (matrix != matrix.transpose()) throw SolverError("the compliance of the contact line is not symmetric");
  const auto image = hdf5_image(stored);
  return block_of(image.data(), image.size()) + image;
}

StoredOperator operator_in(const std::string& file, const std::string& key) {
  if (file.size() <= block_size || file.compare(0, 16, block_format, 16) != 0)
    throw OperatorFileError("it is no file of an operator");
  if (file.compare(0, block_size, block_of(file.data() + block_size, file.size() - block_size)) != 0)
    throw OperatorFileError("its checksum is not that of its content");
  auto stored = operator_in_image(file);
  if (!key.empty() && stored.key != key) throw OperatorFileError("it is another operator");
  return stored;
}

}  // namespace fretval::fem
