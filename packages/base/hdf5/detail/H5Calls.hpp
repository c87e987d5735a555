#pragma once

#include "base/hdf5/H5.hpp"

#include <string>

// For the sources of H5.hpp alone.
namespace asperity::h5
{
// Throws Error with `what` and HDF5's description of its last failure.
[[noreturn]] void fail(std::string const& what);

// Fails if the status of an HDF5 call is negative.
void check(herr_t status, std::string const& what);

// {} is a single value; `largest` may have H5S_UNLIMITED.
Handle makeSpace(Shape const& shape, Shape const& largest, std::string const& what);

// Of strings of any length in UTF-8.
Handle makeTextType(std::string const& what);

Handle makeProperties(hid_t kind, std::string const& what);
} // namespace asperity::h5
