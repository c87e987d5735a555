#include "mesh/file/detail/Hdf5Writer.hpp"

#include <algorithm>

namespace asperity::mesh::detail
{
namespace
{
// Strings as HDF5 takes them, in UTF-8, while `values` live: pointers if their length is variable,
// or else one after the other, filled up with zeros.
class Texts
{
public:
  Texts(std::vector<std::string> const& values, bool have_fixed_length)
      : type_(H5Tcopy(H5T_C_S1), H5Tclose)
  {
    std::size_t longest = 1; // HDF5 has no strings of length 0
    for (auto const& value : values) {
      pointers_.push_back(value.c_str());
      longest = std::max(longest, value.size());
    }
    if (have_fixed_length) {
      for (auto const& value : values) {
        letters_ += value + std::string(longest - value.size(), '\0');
      }
      H5Tset_strpad(type_, H5T_STR_NULLPAD);
    }
    H5Tset_size(type_, have_fixed_length ? longest : H5T_VARIABLE);
    H5Tset_cset(type_, H5T_CSET_UTF8);
  }

  hid_t type() const { return type_; }
  void const* data() const
  {
    return letters_.empty() ? static_cast<void const*>(pointers_.data()) : letters_.data();
  }

private:
  Hdf5Id type_;
  std::vector<char const*> pointers_;
  std::string letters_;
};

hid_t createFile(std::string const& file_name, Hdf5Writer::Layout layout)
{
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (layout == Hdf5Writer::Layout::sealed) {
    H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST);
  }
  return H5Fcreate(file_name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
}
} // namespace

Hdf5Writer::Hdf5Writer(std::string const& file_name, Layout layout)
    : layout_(layout)
    , file_(createFile(file_name, layout), H5Fclose)
    , has_succeeded_(file_.isValid())
{
}

void Hdf5Writer::attribute(std::string const& name, int value)
{
  writeAttribute(name, H5T_NATIVE_INT, Hdf5Id(H5Screate(H5S_SCALAR), H5Sclose), &value);
}

void Hdf5Writer::attribute(std::string const& name, std::string const& value)
{
  const std::vector<std::string> values = {value};
  const Texts text(values, layout_ == Layout::sealed);
  writeAttribute(name, text.type(), Hdf5Id(H5Screate(H5S_SCALAR), H5Sclose), text.data());
}

void Hdf5Writer::attribute(std::string const& name, std::vector<double> const& values)
{
  const hsize_t size = values.size();
  const Hdf5Id space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  writeAttribute(name, H5T_NATIVE_DOUBLE, space, values.data());
}

void Hdf5Writer::writeAttribute(std::string const& name, hid_t type, hid_t space, void const* value)
{
  const Hdf5Id attribute(H5Acreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  note(attribute.isValid() && H5Awrite(attribute, type, value) >= 0);
}

void Hdf5Writer::group(std::string const& path)
{
  const Hdf5Id group(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                     H5Gclose);
  note(group.isValid());
}

void Hdf5Writer::dataset(std::string const& path, std::vector<std::string> const& values)
{
  const Texts texts(values, layout_ == Layout::sealed);
  write(path, texts.type(), texts.data(), values.size(), 0);
}

void Hdf5Writer::write(std::string const& path, hid_t type, void const* values, std::size_t rows,
                       std::size_t columns)
{
  const hsize_t sizes[2] = {rows, columns};
  const Hdf5Id space(H5Screate_simple(columns == 0 ? 1 : 2, sizes, nullptr), H5Sclose);
  const Hdf5Id dataset(
    H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  note(dataset.isValid());
  if (rows > 0) {
    note(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
  }
}

bool Hdf5Writer::finish()
{
  note(file_.isValid() && H5Fflush(file_, H5F_SCOPE_LOCAL) >= 0);
  note(file_.close());
  return has_succeeded_;
}
} // namespace asperity::mesh::detail
