#include "mesh/file/detail/SlabReader.hpp"

namespace asperity::mesh::detail
{
namespace
{
// Some entries of a dataset of one dimension; false if they cannot be read.
template <class Number>
bool readEntries(h5::File const& file, std::string const& path, h5::Part const& part,
                 Number* values)
{
  try {
    const h5::Dataset dataset = file.openDataset(path);
    const h5::Shape shape = dataset.shape();
    if (shape.size() != 1 || part.first + part.count > shape[0]) {
      return false;
    }
    dataset.readPart(values, part);
    return true;
  } catch (h5::Error const&) {
    return false;
  }
}
} // namespace

SlabReader::SlabReader(std::string const& file_name, PartitionSummary const& summary)
    : where_("Mesh file '" + file_name + "'")
    , seed_(seedOf(summary))
{
  try {
    file_ = h5::File::open(file_name);
  } catch (h5::Error const&) {
    note("it cannot be opened by this rank");
  }
}

void SlabReader::note(std::string const& problem)
{
  if (problem_.empty()) {
    problem_ = where_ + ": " + problem + ". Partition the mesh again.";
  }
}

SlabReader::Slab SlabReader::findSlab(std::string const& array, int part, hsize_t num_rows_of_all)
{
  long long offsets[2] = {0, 0};
  Slab slab;
  const auto entry = static_cast<hsize_t>(part);
  const bool is_read = readEntries(*file_, array + "/offsets", {entry, 2}, offsets) &&
                       readEntries(*file_, array + "/checksums", {entry, 1}, &slab.checksum);
  if (!is_read || offsets[0] < 0 || offsets[1] < offsets[0] ||
      static_cast<hsize_t>(offsets[1]) > num_rows_of_all) {
    note("'" + array + "' has no valid offsets and checksums for part " + std::to_string(part));
    return slab;
  }
  slab.rows.first = static_cast<hsize_t>(offsets[0]);
  slab.rows.count = static_cast<hsize_t>(offsets[1] - offsets[0]);
  return slab;
}

// The dataset, if its shape is (n, columns), or (n) for columns = 0.
std::optional<h5::Dataset> SlabReader::openValues(std::string const& path, hsize_t columns) const
{
  try {
    h5::Dataset values = file_->openDataset(path);
    values.requireStorage();
    const h5::Shape shape = values.shape();
    const bool is_fit = columns == 0 ? shape.size() == 1 : shape.size() == 2 && shape[1] == columns;
    return is_fit ? std::optional<h5::Dataset>(std::move(values)) : std::nullopt;
  } catch (h5::Error const&) {
    return std::nullopt;
  }
}

std::uint64_t SlabReader::readRows(std::string const& array, int part, hsize_t columns,
                                   Read const& read)
{
  if (!file_) {
    return 0;
  }
  const std::string path = array + "/values";
  const auto values = openValues(path, columns);
  if (!values) {
    note("'" + path + "' is missing, damaged or of another shape"); // the same on every rank
    return 0;
  }
  const Slab slab = findSlab(array, part, values->shape()[0]);
  try {
    read(*values, slab.rows);
  } catch (h5::Error const&) {
    note("'" + path + "' cannot be read");
  }
  return slab.checksum;
}
} // namespace asperity::mesh::detail
