#pragma once

#include "Scratch.hpp"

#include <string>

// HDF5 files from a text, so that a fuzzer changes what a file says and not only bytes, which
// checksums of HDF5 or its own library refuse:
//
//   #recipe                                      or "#recipe sealed", with HDF5's checksums
//   attribute NAME int|text|reals VALUE...       of the file
//   group PATH
//   dataset PATH int8|int32|int64|uint64|float64 ROWSxCOLUMNS VALUE...
//   texts PATH VALUE|VALUE...
//
// Values that are missing are 0; lines that say something else are left out.
namespace asperity::fuzz
{
bool isRecipe(std::string const& input);

// Makes the file of a recipe, or else one of these bytes. False if a recipe cannot be made.
bool makeFile(std::string const& input, Scratch const& file);
} // namespace asperity::fuzz
