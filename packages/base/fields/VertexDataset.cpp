#include "base/fields/VertexDataset.hpp"

#include "base/Errors.hpp"

#include <hdf5.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace asperity
{
namespace
{
// Closes an HDF5 id at the end of the block.
class Handle
{
public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle()
  {
    if (id_ >= 0) {
      close_(id_);
    }
  }
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  hid_t id() const { return id_; }
  bool isOpen() const { return id_ >= 0; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// HDF5 prints its own stack of errors unless told not to; ours says what the user needs.
class Silence
{
public:
  Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Silence(Silence const&) = delete;
  Silence& operator=(Silence const&) = delete;

private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

std::size_t colonBeforeDataset(std::string const& text)
{
  const std::size_t colon = text.find(":/");
  const auto ends_with = [&](std::string const& ending) {
    return colon != std::string::npos && colon > ending.size() &&
           text.compare(colon - ending.size(), ending.size(), ending) == 0;
  };
  return ends_with(".h5") || ends_with(".hdf5") ? colon : std::string::npos;
}

// Entries first, first + 1, ..., as many as `values` has.
bool readBlock(hid_t dataset, hsize_t first, std::vector<double>& values)
{
  const hsize_t count = values.size();
  const Handle file_space(H5Dget_space(dataset), H5Sclose);
  const Handle memory_space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  return H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr) >=
           0 &&
         H5Dread(dataset, H5T_NATIVE_DOUBLE, memory_space.id(), file_space.id(), H5P_DEFAULT,
                 values.data()) >= 0;
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
  const Silence silence;
  ASPERITY_REQUIRE(std::filesystem::exists(file_name_),
                   path << " = '" << name << "': there is no file '" << file_name_ << "'.");
  const Handle file(H5Fopen(file_name_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  ASPERITY_REQUIRE(file.isOpen(), path << " = '" << name << "': '" << file_name_
                                       << "' cannot be read as an HDF5 file.");
  const Handle dataset(H5Dopen2(file.id(), dataset_name_.c_str(), H5P_DEFAULT), H5Dclose);
  ASPERITY_REQUIRE(dataset.isOpen(), path << " = '" << name << "': '" << file_name_
                                          << "' has no dataset '" << dataset_name_ << "'.");
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const auto type_class = H5Tget_class(type.id());
  ASPERITY_REQUIRE(H5Sget_simple_extent_ndims(space.id()) == 1 &&
                     (type_class == H5T_FLOAT || type_class == H5T_INTEGER),
                   path << " = '" << name << "' is not a one-dimensional dataset of numbers.");
  size_ = static_cast<long long>(H5Sget_simple_extent_npoints(space.id()));
}

// In blocks of a megabyte or so, skipping those without a wanted id: no rank holds the whole
// dataset.
std::vector<double> VertexDataset::read(std::vector<long long> const& global_ids,
                                        long long num_vertices) const
{
  const Silence silence;
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
  const Handle file(H5Fopen(file_name_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Handle dataset(H5Dopen2(file.id(), dataset_name_.c_str(), H5P_DEFAULT), H5Dclose);
  constexpr long long block_size = 1 << 17;
  std::vector<double> values(global_ids.size());
  for (auto next = order.begin(); next != order.end();) {
    const long long first = global_ids[*next];
    std::vector<double> block(static_cast<std::size_t>(std::min(block_size, size_ - first)));
    ASPERITY_REQUIRE(readBlock(dataset.id(), static_cast<hsize_t>(first), block),
                     path_ << " = '" << name_ << "' cannot be read.");
    const long long end = first + static_cast<long long>(block.size());
    for (; next != order.end() && global_ids[*next] < end; ++next) {
      values[*next] = block[static_cast<std::size_t>(global_ids[*next] - first)];
    }
  }
  return values;
}
} // namespace asperity
