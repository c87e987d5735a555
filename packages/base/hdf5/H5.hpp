#pragma once

#include <hdf5.h>
#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// HDF5 with owned handles and exceptions. Paths of objects use '/'; missing groups are made.
// A file is used by one rank, or between openShared and close by all of them.
namespace asperity::h5
{
// What HDF5 was asked to do, with the file, and its own description of what went wrong.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

enum class Type
{
  int8,
  int64,
  float32,
  float64
};

using Shape = std::vector<hsize_t>; // {} is a single value

// Owns an HDF5 identifier.
class Handle
{
public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  // Error "<what> failed" if the identifier is negative.
  Handle(hid_t id, Close close, std::string const& what);
  Handle(Handle&& other) noexcept { swap(other); }
  Handle& operator=(Handle&& other) noexcept
  {
    swap(other);
    return *this;
  }
  ~Handle();

  hid_t get() const { return id_; }
  void close(std::string const& what); // Error if that fails, for example on a full disk

private:
  void swap(Handle& other) noexcept
  {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
  }

  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

// Anything that carries attributes.
class Object
{
public:
  void setAttribute(std::string const& name, std::string const& value);
  void setAttribute(std::string const& name, std::int64_t value);
  std::string textAttribute(std::string const& name) const;
  std::int64_t integerAttribute(std::string const& name) const;

protected:
  Object(Handle handle, std::string what) : handle_(std::move(handle)), what_(std::move(what)) {}

  Handle handle_;
  std::string what_; // "DIR/fault.h5: fields/alpha", for messages
};

// What one rank has of a dataset, or of each row that is appended: the numbers first <= i < first +
// count of the first dimension; none if count is 0. Of rows that are single numbers {0, 1} or none.
struct Part
{
  hsize_t first = 0;
  hsize_t count = 0;
};

class Dataset : public Object
{
public:
  Type type() const;
  Shape shape() const;

  // All values; converted by HDF5 if the file holds another type.
  void write(double const* values);
  void write(std::int64_t const* values);
  void write(std::int8_t const* values);
  std::vector<double> readDoubles() const;
  std::vector<std::int64_t> readIntegers() const;
  std::string readBytes() const;
  std::vector<std::string> readTexts() const;

  // Adds rows at the end of an extendable dataset; values: (num_rows, rest of the shape).
  void append(double const* values, hsize_t num_rows);
  void append(std::int64_t const* values, hsize_t num_rows);

  // The same, each rank its part; values: (part.count, rest) and (num_rows, part.count, rest). What
  // writePart writes is of the dataset's own type. Collective, in a file that is shared.
  void writePart(double const* values, Part const& part);
  void writePart(std::int64_t const* values, Part const& part);
  void appendPart(double const* values, hsize_t num_rows, Part const& part);

private:
  friend class Group;
  Dataset(Handle handle, std::string what) : Object(std::move(handle), std::move(what)) {}

  void appendRaw(void const* values, hid_t memory_type, hsize_t num_rows);
  Shape extend(hsize_t num_rows);
  void writeSlab(void const* values, hid_t memory_type, Shape const& start, Shape const& count);
  std::size_t numValues() const;
};

// A piece of a virtual dataset: all `num_rows` rows of a dataset of the same name in `file`, a path
// relative to the folder of the index.
struct VirtualPart
{
  std::string file;
  hsize_t num_rows = 0;
};

class Group : public Object
{
public:
  bool has(std::string const& path) const;
  std::vector<std::string> names() const; // of the members
  bool isGroup(std::string const& path) const;

  Group createGroup(std::string const& path);
  Group openGroup(std::string const& path) const;
  Dataset openDataset(std::string const& path) const;

  // Of fixed shape.
  Dataset create(std::string const& path, Type type, Shape const& shape);

  // A list of strings in UTF-8.
  Dataset createTexts(std::string const& path, std::vector<std::string> const& texts);

  // Rows of shape `row_shape` may be appended; compressed (shuffle, deflate) in chunks of that
  // many rows, or of parts of them where a chunk would have more than 1 MiB. If several ranks will
  // append together, `shared`: HDF5 1.10 then looks for chunks that exist.
  Dataset createExtendable(std::string const& path, Type type, Shape const& row_shape,
                           hsize_t rows_per_chunk, bool shared = false);

  // The rows of the parts, one part after the other. Where a part is missing, nan or -1 is read.
  Dataset createVirtual(std::string const& path, Type type, Shape const& row_shape,
                        std::vector<VirtualPart> const& parts);

  // Stands for the object of the same path in `file`, a path relative to the folder of this file.
  void link(std::string const& path, std::string const& file);

protected:
  Group(Handle handle, std::string what) : Object(std::move(handle), std::move(what)) {}

private:
  Dataset createWith(std::string const& path, hid_t type, Handle const& space,
                     Handle const& properties);
  std::string describe(std::string const& path) const { return what_ + ": " + path; }
};

class File : public Group
{
public:
  using Group::create;

  // Replaces a file of that name.
  static File create(std::filesystem::path const& path);
  static File open(std::filesystem::path const& path); // for reading

  // For writing to what exists, by all ranks of the communicator: objects may be opened, and parts
  // of datasets written, by all at once. Close it before anything may throw on one rank alone:
  // closing is collective. Collective.
  static File openShared(std::filesystem::path const& path, MPI_Comm comm);

  void flush();
  void close(); // Error if what is buffered cannot be written

private:
  File(Handle handle, std::string what) : Group(std::move(handle), std::move(what)) {}
};
} // namespace asperity::h5
