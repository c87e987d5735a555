#pragma once

#include "hdf5/Handle.hpp"
#include "hdf5/Object.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::h5
{
// Texts as HDF5 takes them, in UTF-8, while `values` live: pointers if their length is variable, or
// else one after the other, filled up with zeros.
class Texts
{
public:
  Texts(std::vector<std::string> const& values, TextLength length, std::string const& what);

  hid_t type() const { return type_.get(); }
  void const* data() const
  {
    return letters_.empty() ? static_cast<void const*>(pointers_.data()) : letters_.data();
  }

private:
  Handle type_;
  std::vector<char const*> pointers_;
  std::string letters_;
};

// Reads `count` texts of this type, of either length; `read` fills a buffer with values of the
// type.
std::vector<std::string> readTexts(Handle const& type, std::size_t count, std::string const& what,
                                   std::function<void(void*)> const& read);
} // namespace asperity::h5
