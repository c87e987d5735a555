#pragma once

#include "hdf5/Handle.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace asperity::h5
{
// How texts are stored. Texts of fixed length (that of the longest; the others are padded with
// zeros) are covered by HDF5's checksums in a sealed file.
enum class TextLength
{
  variable,
  fixed
};

// Anything that carries attributes: single texts in UTF-8, single integers, lists of numbers.
class Object
{
public:
  void setAttribute(std::string const& name, std::string const& value,
                    TextLength length = TextLength::variable);
  void setAttribute(std::string const& name, int value);
  void setAttribute(std::string const& name, std::int64_t value);
  void setAttribute(std::string const& name, std::vector<double> const& values);

  bool hasAttribute(std::string const& name) const;

  // Error if there is no attribute of that name, or it has another type.
  std::string textAttribute(std::string const& name) const;
  std::int64_t integerAttribute(std::string const& name) const;
  std::vector<double> numbersAttribute(std::string const& name) const;

  std::string const& what() const { return what_; }

protected:
  Object(Handle handle, std::string what) : handle_(std::move(handle)), what_(std::move(what)) {}

  Handle handle_;
  std::string what_; // "DIR/fault.h5: fields/alpha", for messages
};
} // namespace asperity::h5
