#pragma once

#include "hdf5/Dataset.hpp"
#include "hdf5/Handle.hpp"

#include <string>

// For the sources of this folder alone: every call of HDF5 goes through these.
namespace asperity::h5
{
// Throws Error with `what` and HDF5's description of its last failure.
[[noreturn]] void fail(std::string const& what);

// The result of a call of HDF5, which prints nothing; Error "<what> failed" if it is negative.
template <class Call>
auto checked(std::string const& what, Call const& call)
{
  const Silence silence;
  const auto result = call();
  if (result < 0) {
    fail(what);
  }
  return result;
}

// The object that a call creates or opens.
template <class Call>
Handle opened(std::string const& what, Handle::Close close, Call const& call)
{
  return Handle(checked(what, call), close);
}

// The type of numbers in memory.
hid_t native(Type type);

// {} is a single value; `largest` may have H5S_UNLIMITED.
Handle makeSpace(Shape const& shape, Shape const& largest, std::string const& what);

Handle makeProperties(hid_t kind, std::string const& what);

// Of a dataset or an attribute.
ValueClass valueClassOf(hid_t type, std::string const& what);
Shape shapeOf(Handle const& space, std::string const& what);
} // namespace asperity::h5
