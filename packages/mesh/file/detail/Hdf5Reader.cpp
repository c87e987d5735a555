#include "mesh/file/detail/Hdf5Reader.hpp"

#include "base/Errors.hpp"

#include <filesystem>
#include <limits>

namespace asperity::mesh::detail
{
namespace
{
// Strings of fixed or variable length. `read` fills a buffer with values of the given type.
bool readStrings(hid_t type, hid_t space, std::function<bool(void*)> const& read,
                 std::vector<std::string>& values)
{
  if (H5Tget_class(type) != H5T_STRING) {
    return false;
  }
  if (H5Tis_variable_str(type) > 0) {
    std::vector<char*> texts(values.size(), nullptr);
    if (!read(texts.data())) {
      return false;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = texts[i] ? texts[i] : "";
    }
    return H5Dvlen_reclaim(type, space, H5P_DEFAULT, texts.data()) >= 0;
  }
  const std::size_t length = H5Tget_size(type);
  std::string texts(length * values.size(), '\0');
  if (!read(texts.data())) {
    return false;
  }
  const char filler = H5Tget_strpad(type) == H5T_STR_SPACEPAD ? ' ' : '\0';
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = texts.substr(i * length, length);
    values[i] = values[i].substr(0, values[i].find('\0'));
    values[i].erase(values[i].find_last_not_of(filler) + 1);
  }
  return true;
}
} // namespace

Hdf5Reader::Hdf5Reader(std::string const& file_name)
    : where_("Mesh file '" + file_name + "'")
    , file_(H5Fopen(file_name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose)
{
  std::error_code error;
  ASPERITY_REQUIRE(std::filesystem::exists(file_name, error), where_ << " does not exist.");
  ASPERITY_REQUIRE(file_.isValid(), where_
                                      << " cannot be opened as an HDF5 file. It is truncated, of "
                                         "another kind, or not readable for you.");
}

// A path that leads over a missing group does not exist, and neither does a link to nowhere.
bool Hdf5Reader::has(std::string const& path) const
{
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    if (H5Lexists(file_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) {
      return false;
    }
    if (end == std::string::npos) {
      return H5Oexists_by_name(file_, path.c_str(), H5P_DEFAULT) > 0;
    }
  }
}

int Hdf5Reader::integerAttribute(std::string const& name) const
{
  const Hdf5Id attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT), H5Aclose);
  ASPERITY_REQUIRE(attribute.isValid(),
                   where_ << " is no mesh: it has no attribute '" << name << "'.");
  const Hdf5Id type(H5Aget_type(attribute), H5Tclose);
  const Hdf5Id space(H5Aget_space(attribute), H5Sclose);
  int value = 0;
  ASPERITY_REQUIRE(H5Tget_class(type) == H5T_INTEGER && H5Sget_simple_extent_npoints(space) == 1 &&
                     H5Aread(attribute, H5T_NATIVE_INT, &value) >= 0,
                   where_ << ": the attribute '" << name << "' is not an integer.");
  return value;
}

std::string Hdf5Reader::stringAttribute(std::string const& name) const
{
  const Hdf5Id attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT), H5Aclose);
  ASPERITY_REQUIRE(attribute.isValid(),
                   where_ << " is no mesh: it has no attribute '" << name << "'.");
  const Hdf5Id type(H5Aget_type(attribute), H5Tclose);
  const Hdf5Id space(H5Aget_space(attribute), H5Sclose);
  std::vector<std::string> value(1);
  const auto read = [&](void* buffer) { return H5Aread(attribute, type, buffer) >= 0; };
  ASPERITY_REQUIRE(H5Sget_simple_extent_npoints(space) == 1 &&
                     readStrings(type, space, read, value),
                   where_ << ": the attribute '" << name << "' is not a string.");
  return value[0];
}

bool Hdf5Reader::hasAttribute(std::string const& name) const
{
  return H5Aexists(file_, name.c_str()) > 0;
}

std::vector<double> Hdf5Reader::numbersAttribute(std::string const& name, std::size_t count) const
{
  const Hdf5Id attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Id type(H5Aget_type(attribute), H5Tclose);
  const Hdf5Id space(H5Aget_space(attribute), H5Sclose);
  const auto type_class = H5Tget_class(type);
  std::vector<double> values(count);
  ASPERITY_REQUIRE((type_class == H5T_FLOAT || type_class == H5T_INTEGER) &&
                     H5Sget_simple_extent_npoints(space) == static_cast<hssize_t>(count) &&
                     H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()) >= 0,
                   where_ << ": the attribute '" << name << "' does not consist of " << count
                          << " numbers.");
  return values;
}

std::vector<std::string> Hdf5Reader::groupEntries(std::string const& path) const
{
  const Hdf5Id group(H5Gopen2(file_, path.c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info;
  ASPERITY_REQUIRE(group.isValid() && H5Gget_info(group, &info) >= 0,
                   where_ << " has no group '" << path << "'.");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const ssize_t length =
      H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT);
    ASPERITY_REQUIRE(length > 0, where_ << ": group '" << path << "' cannot be read.");
    std::string name(static_cast<std::size_t>(length) + 1, '\0');
    H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, &name[0], name.size(),
                       H5P_DEFAULT);
    name.pop_back();
    names.push_back(name);
  }
  return names;
}

void Hdf5Reader::readRows(std::string const& path, std::size_t columns, bool only_integers,
                          hid_t type, Destination const& destination) const
{
  ASPERITY_REQUIRE(has(path), where_ << " has no dataset '" << path << "'.");
  const Hdf5Id dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  ASPERITY_REQUIRE(dataset.isValid(), where_ << ": '" << path << "' is not a dataset.");
  const Hdf5Id file_type(H5Dget_type(dataset), H5Tclose);
  const auto type_class = H5Tget_class(file_type);
  ASPERITY_REQUIRE(type_class == H5T_INTEGER || (type_class == H5T_FLOAT && !only_integers),
                   where_ << ": dataset '" << path << "' does not consist of "
                          << (only_integers ? "integers." : "numbers."));
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose);
  const int num_dimensions = H5Sget_simple_extent_ndims(space);
  hsize_t sizes[2] = {0, 0};
  const int wanted = columns == 0 ? 1 : 2;
  const bool has_shape = num_dimensions == wanted &&
                         H5Sget_simple_extent_dims(space, sizes, nullptr) == wanted &&
                         (columns == 0 || sizes[1] == columns);
  ASPERITY_REQUIRE(
    has_shape, where_ << ": dataset '" << path << "' has not the shape (n"
                      << (columns == 0 ? std::string(")") : ", " + std::to_string(columns) + ")")
                      << '.');
  ASPERITY_REQUIRE(sizes[0] < static_cast<hsize_t>(std::numeric_limits<int>::max()),
                   where_ << ": dataset '" << path << "' is too long: " << sizes[0] << " rows.");
  ASPERITY_REQUIRE(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, destination(sizes[0])) >=
                     0,
                   where_ << ": dataset '" << path << "' cannot be read. The file may be damaged.");
}

std::vector<int> Hdf5Reader::integers(std::string const& path) const
{
  std::vector<int> values;
  readRows(path, 0, true, H5T_NATIVE_INT, [&](std::size_t num_rows) {
    values.resize(num_rows);
    return static_cast<void*>(values.data());
  });
  return values;
}

std::vector<std::string> Hdf5Reader::strings(std::string const& path) const
{
  ASPERITY_REQUIRE(has(path), where_ << " has no dataset '" << path << "'.");
  const Hdf5Id dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  ASPERITY_REQUIRE(dataset.isValid(), where_ << ": '" << path << "' is not a dataset.");
  const Hdf5Id type(H5Dget_type(dataset), H5Tclose);
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  std::vector<std::string> values(count > 0 ? static_cast<std::size_t>(count) : 0);
  const auto read = [&](void* buffer) {
    return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer) >= 0;
  };
  ASPERITY_REQUIRE(H5Sget_simple_extent_ndims(space) == 1 && readStrings(type, space, read, values),
                   where_ << ": dataset '" << path << "' is not a list of strings.");
  return values;
}
} // namespace asperity::mesh::detail
