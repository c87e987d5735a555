#pragma once

#include "hdf5/Object.hpp"

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace asperity::h5
{
// The types of numbers in files and in memory; HDF5 converts between them.
enum class Type
{
  int8,
  int32,
  int64,
  uint64,
  float32,
  float64
};

enum class ValueClass
{
  integer,
  real,
  text,
  other
};

template <class Number>
constexpr Type typeOf()
{
  if constexpr (std::is_floating_point_v<Number>) {
    static_assert(sizeof(Number) == 4 || sizeof(Number) == 8);
    return sizeof(Number) == 4 ? Type::float32 : Type::float64;
  } else if constexpr (std::is_signed_v<Number>) {
    static_assert(sizeof(Number) == 1 || sizeof(Number) == 4 || sizeof(Number) == 8);
    return sizeof(Number) == 1 ? Type::int8 : sizeof(Number) == 4 ? Type::int32 : Type::int64;
  } else {
    static_assert(std::is_unsigned_v<Number> && sizeof(Number) == 8);
    return Type::uint64;
  }
}

using Shape = std::vector<hsize_t>; // {} is a single value

// A part of a dataset, or of each appended row: the `count` indices from `first` on, of the first
// dimension of the dataset or of the row. If rows are single numbers, the part is {0, 1} or empty.
struct Part
{
  hsize_t first = 0;
  hsize_t count = 0;
};

class Dataset : public Object
{
public:
  ValueClass valueClass() const;
  Type type() const; // of numbers; the next larger one if the file's own is not among them
  Shape shape() const;

  // Throws Error if the file is too small for values of this shape, because the shape is damaged.
  // Call this before memory is allocated for the values; the functions here that return whole
  // datasets do so.
  void requireStorage() const;

  // All values.
  template <class Number>
  void write(Number const* values)
  {
    writeAll(typeOf<Number>(), values);
  }
  template <class Number>
  void read(Number* values) const
  {
    readAll(typeOf<Number>(), values);
  }
  template <class Number>
  std::vector<Number> read() const
  {
    std::vector<Number> values(numValues());
    read(values.data());
    return values;
  }
  std::vector<std::string> readTexts() const; // of variable or fixed length

  // A part of the first dimension; values: (part.count, rest of the shape). The numbers given to
  // writePart must have the dataset's own type.
  template <class Number>
  void readPart(Number* values, Part const& part) const
  {
    readPartOf(typeOf<Number>(), values, part);
  }
  template <class Number>
  void writePart(Number const* values, Part const& part)
  {
    writePartOf(typeOf<Number>(), values, part);
  }

  // Adds rows to an extendable dataset, or only room for them; writeRows fills a part of each of
  // the last num_rows rows: values (num_rows, part.count, rest).
  void extend(hsize_t num_rows);
  void writeRows(double const* values, hsize_t num_rows, Part const& part);
  void appendPart(double const* values, hsize_t num_rows, Part const& part)
  {
    extend(num_rows);
    writeRows(values, num_rows, part);
  }

private:
  friend class Group;
  Dataset(Handle handle, std::string what) : Object(std::move(handle), std::move(what)) {}

  Handle space() const;
  Handle fileType() const;
  std::size_t numValues() const;
  void writeAll(Type type, void const* values);
  void readAll(Type type, void* values) const;
  void readPartOf(Type type, void* values, Part const& part) const;
  void writePartOf(Type type, void const* values, Part const& part);
  void writeSlab(Type type, void const* values, Shape const& start, Shape const& count);
};
} // namespace asperity::h5
