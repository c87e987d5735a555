#include "parameters/fields/VertexDataset.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/NearestName.hpp"
#include "parameters/fields/MissingFile.hpp"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>

namespace asperity
{
namespace
{
constexpr hsize_t block_size = 1 << 17; // values, a megabyte

// Calls read(); where HDF5 fails, the message begins with the parameter and its value.
template <class Read>
void asInputError(std::string const& path, std::string const& name, Read const& read)
{
  try {
    read();
  } catch (h5::Error const& error) {
    throw InputError(path + " = '" + name + "' cannot be read. " + error.what());
  }
}

// Paths of what the file has, down to the members of its groups.
std::vector<std::string> namesBelow(h5::File const& file)
{
  std::vector<std::string> names;
  for (auto const& name : file.names()) {
    names.push_back("/" + name);
    try {
      for (auto const& member : file.openGroup(name).names()) {
        names.push_back("/" + name + "/" + member);
      }
    } catch (h5::Error const&) { // a dataset
    }
  }
  return names;
}

// What the group has, if it is one.
std::optional<std::vector<std::string>> membersOf(h5::File const& file, std::string const& group)
{
  try {
    return file.openGroup(group).names();
  } catch (h5::Error const&) {
    return std::nullopt;
  }
}

std::size_t colonBeforeDataset(std::string const& text)
{
  const std::size_t colon = text.find(":/");
  const auto ends_with = [&](std::string const& ending) {
    return colon != std::string::npos && colon > ending.size() &&
           text.compare(colon - ending.size(), ending.size(), ending) == 0;
  };
  return ends_with(".h5") || ends_with(".hdf5") ? colon : std::string::npos;
}
} // namespace

bool VertexDataset::isName(std::string const& text)
{
  return colonBeforeDataset(text) != std::string::npos;
}

VertexDataset::VertexDataset(std::string const& name, std::string const& path)
    : name_(name)
    , path_(path)
    , file_name_(name.substr(0, colonBeforeDataset(name)))
    , dataset_name_(name.substr(colonBeforeDataset(name) + 1))
{
  std::error_code ignored;
  ASPERITY_REQUIRE(std::filesystem::exists(file_name_, ignored),
                   path << " = '" << name << "': there is no file '" << file_name_ << "'. "
                        << whereNot(file_name_));
  asInputError(path, name, [&] {
    const h5::Dataset dataset = open();
    const h5::Shape shape = dataset.shape();
    const h5::ValueClass value_class = dataset.valueClass();
    ASPERITY_REQUIRE(shape.size() == 1 && (value_class == h5::ValueClass::real ||
                                           value_class == h5::ValueClass::integer),
                     path << " = '" << name << "' is not a one-dimensional dataset of numbers.");
    size_ = static_cast<long long>(shape[0]);
  });
}

h5::Dataset VertexDataset::open() const
{
  const std::string where = path_ + " = '" + name_ + "': '" + file_name_ + "'";
  std::optional<h5::File> file;
  try {
    file = h5::File::open(file_name_);
  } catch (h5::Error const&) {
    throw InputError(where + " cannot be read as an HDF5 file.");
  }
  try {
    return file->openDataset(dataset_name_); // keeps the file open
  } catch (h5::Error const&) {
    if (const auto members = membersOf(*file, dataset_name_)) {
      throw InputError(where + ": '" + dataset_name_ + "' is a group, not a dataset. It has " +
                       (members->empty() ? "no members" : quotedNames(*members)) + '.');
    }
    throw InputError(where + " has no dataset '" + dataset_name_ + "'." +
                     didYouMean(dataset_name_, namesBelow(*file)));
  }
}

// Reads blocks of about a megabyte and skips those without a wanted id, so that no rank holds the
// whole dataset.
std::vector<double> VertexDataset::read(std::vector<long long> const& global_ids,
                                        long long num_vertices) const
{
  std::vector<std::size_t> order(global_ids.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return global_ids[i] < global_ids[j]; });
  ASPERITY_REQUIRE(size_ == num_vertices,
                   path_ << " = '" << name_ << "' has " << size_ << " values, but the mesh has "
                         << num_vertices
                         << " vertices. One value per vertex of the mesh is wanted, in its order.");
  ASPERITY_ASSERT(order.empty() ||
                  (global_ids[order.front()] >= 0 && global_ids[order.back()] < num_vertices));
  std::vector<double> values(global_ids.size());
  asInputError(path_, name_, [&] {
    const h5::Dataset dataset = open();
    for (auto next = order.begin(); next != order.end();) {
      const auto first = static_cast<hsize_t>(global_ids[*next]);
      std::vector<double> block(std::min(block_size, static_cast<hsize_t>(size_) - first));
      dataset.readPart(block.data(), {first, block.size()});
      const auto end = static_cast<long long>(first + block.size());
      for (; next != order.end() && global_ids[*next] < end; ++next) {
        values[*next] = block[static_cast<std::size_t>(global_ids[*next]) - first];
      }
    }
  });
  return values;
}

std::vector<double> VertexDataset::readAll(std::string const& unit) const
{
  std::vector<double> values;
  asInputError(path_, name_, [&] {
    const h5::Dataset dataset = open();
    const auto given = dataset.hasAttribute("unit") ? dataset.textAttribute("unit") : unit;
    ASPERITY_REQUIRE(given == unit,
                     path_ << " = '" << name_ << "' is in " << given << ", not in " << unit << ".");
    values = dataset.read<double>();
  });
  return values;
}

std::uint64_t VertexDataset::checksum() const
{
  Checksum checksum;
  asInputError(path_, name_, [&] {
    const h5::Dataset dataset = open();
    const auto size = static_cast<hsize_t>(size_);
    for (hsize_t first = 0; first < size; first += block_size) {
      std::vector<double> block(std::min(block_size, size - first));
      dataset.readPart(block.data(), {first, block.size()});
      checksum.add(block);
    }
  });
  return checksum.value();
}
} // namespace asperity
