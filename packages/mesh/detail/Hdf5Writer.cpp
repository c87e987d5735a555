#include "mesh/detail/Hdf5Writer.hpp"

namespace asperity::mesh::detail
{
namespace
{
// Variable length, UTF-8.
class StringType : public Hdf5Id
{
public:
  StringType() : Hdf5Id(H5Tcopy(H5T_C_S1), H5Tclose)
  {
    H5Tset_size(*this, H5T_VARIABLE);
    H5Tset_cset(*this, H5T_CSET_UTF8);
  }
};
} // namespace

Hdf5Writer::Hdf5Writer(std::string const& file_name)
    : file_(H5Fcreate(file_name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose)
    , has_succeeded_(file_.isValid())
{
}

void Hdf5Writer::attribute(std::string const& name, int value)
{
  writeAttribute(name, H5T_NATIVE_INT, &value);
}

void Hdf5Writer::attribute(std::string const& name, std::string const& value)
{
  char const* text = value.c_str();
  writeAttribute(name, StringType(), &text);
}

void Hdf5Writer::writeAttribute(std::string const& name, hid_t type, void const* value)
{
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose);
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

void Hdf5Writer::dataset(std::string const& path, double const* values, std::size_t rows,
                         std::size_t columns)
{
  write(path, H5T_NATIVE_DOUBLE, values, rows, columns);
}

void Hdf5Writer::dataset(std::string const& path, int const* values, std::size_t rows,
                         std::size_t columns)
{
  write(path, H5T_NATIVE_INT, values, rows, columns);
}

void Hdf5Writer::dataset(std::string const& path, std::vector<std::string> const& values)
{
  std::vector<char const*> texts;
  for (auto const& value : values) {
    texts.push_back(value.c_str());
  }
  write(path, StringType(), texts.data(), texts.size(), 0);
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
