#include "mesh/file/detail/MeshFileReader.hpp"

#include "base/Errors.hpp"

#include <filesystem>
#include <limits>

namespace asperity::mesh::detail
{
namespace
{
// Calls read(); an error of HDF5 becomes an InputError with `message`.
template <class Read>
auto asInputError(std::string const& message, Read const& read)
{
  try {
    return read();
  } catch (h5::Error const&) {
    throw InputError(message);
  }
}

h5::File openFile(std::string const& file_name, std::string const& where)
{
  std::error_code error;
  ASPERITY_REQUIRE(std::filesystem::exists(file_name, error), where << " does not exist.");
  return asInputError(where +
                        " cannot be opened as an HDF5 file. It is truncated or of another kind, "
                        "or you may not read it.",
                      [&] { return h5::File::open(file_name); });
}
} // namespace

MeshFileReader::MeshFileReader(std::string const& file_name)
    : where_("Mesh file '" + file_name + "'")
    , file_(openFile(file_name, where_))
{
}

void MeshFileReader::requireAttribute(std::string const& name) const
{
  ASPERITY_REQUIRE(file_.hasAttribute(name),
                   where_ << " is no mesh: it has no attribute '" << name << "'.");
}

int MeshFileReader::dimension() const
{
  const int dimension = integerAttribute("dimension");
  ASPERITY_REQUIRE(dimension == 2 || dimension == 3, where_ << ": the attribute 'dimension' = "
                                                            << dimension << " is neither 2 nor 3.");
  return dimension;
}

int MeshFileReader::integerAttribute(std::string const& name) const
{
  requireAttribute(name);
  const std::string message = where_ + ": the attribute '" + name + "' is not an integer.";
  const auto value = asInputError(message, [&] { return file_.integerAttribute(name); });
  ASPERITY_REQUIRE(value >= std::numeric_limits<int>::min() &&
                     value <= std::numeric_limits<int>::max(),
                   where_ << ": the attribute '" << name << "' = " << value << " is too large.");
  return static_cast<int>(value);
}

std::string MeshFileReader::stringAttribute(std::string const& name) const
{
  requireAttribute(name);
  return asInputError(where_ + ": the attribute '" + name + "' is not a string.",
                      [&] { return file_.textAttribute(name); });
}

std::vector<double> MeshFileReader::numbersAttribute(std::string const& name,
                                                     std::size_t count) const
{
  const std::string message = where_ + ": the attribute '" + name + "' does not consist of " +
                              std::to_string(count) + " numbers.";
  auto values = asInputError(message, [&] { return file_.numbersAttribute(name); });
  ASPERITY_REQUIRE(values.size() == count, message);
  return values;
}

std::vector<std::string> MeshFileReader::groupEntries(std::string const& path) const
{
  return asInputError(where_ + " has no group '" + path + "'.",
                      [&] { return file_.openGroup(path).names(); });
}

h5::Dataset MeshFileReader::open(std::string const& path) const
{
  ASPERITY_REQUIRE(file_.has(path), where_ << " has no dataset '" << path << "'.");
  return asInputError(where_ + ": '" + path + "' is not a dataset.",
                      [&] { return file_.openDataset(path); });
}

void MeshFileReader::refuseIfUnreadable(std::string const& path,
                                        std::function<void()> const& read) const
{
  asInputError(where_ + ": dataset '" + path + "' cannot be read. The file may be damaged.", read);
}

h5::Dataset MeshFileReader::datasetOf(std::string const& path, std::size_t columns,
                                      bool only_integers) const
{
  h5::Dataset dataset = open(path);
  const h5::ValueClass value_class = dataset.valueClass();
  ASPERITY_REQUIRE(value_class == h5::ValueClass::integer ||
                     (value_class == h5::ValueClass::real && !only_integers),
                   where_ << ": dataset '" << path << "' does not consist of "
                          << (only_integers ? "integers." : "numbers."));
  const h5::Shape shape = dataset.shape();
  const bool is_fit = columns == 0 ? shape.size() == 1 : shape.size() == 2 && shape[1] == columns;
  const std::string wanted = columns == 0 ? "(n)" : "(n, " + std::to_string(columns) + ")";
  ASPERITY_REQUIRE(is_fit, where_ << ": dataset '" << path << "' does not have the shape " << wanted
                                  << '.');
  ASPERITY_REQUIRE(shape[0] < static_cast<hsize_t>(std::numeric_limits<int>::max()),
                   where_ << ": dataset '" << path << "' is too long: " << shape[0] << " rows.");
  dataset.requireStorage();
  return dataset;
}

hsize_t MeshFileReader::numRows(std::string const& path) const
{
  const h5::Dataset dataset = open(path);
  h5::Shape shape;
  refuseIfUnreadable(path, [&] {
    dataset.requireStorage();
    shape = dataset.shape();
  });
  return shape.empty() ? 0 : shape[0];
}

std::vector<int> MeshFileReader::integers(std::string const& path) const
{
  return rows<int, int>(path, 0, true);
}

std::vector<std::string> MeshFileReader::strings(std::string const& path) const
{
  const std::string message = where_ + ": dataset '" + path + "' is not a list of strings.";
  const h5::Dataset dataset = open(path);
  return asInputError(message, [&] {
    ASPERITY_REQUIRE(dataset.shape().size() == 1, message);
    return dataset.readTexts();
  });
}
} // namespace asperity::mesh::detail
