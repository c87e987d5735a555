#pragma once

#include "surfaces/grids/GridFile.hpp"

#include "registry/Registry.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// A format of files with grids of heights or depths. Registered under its name at the end of the
// format's file, which is all that the format needs:
//   ASPERITY_REGISTER(GridFormatRegistry, "SRTM", Srtm)
class GridFormat
{
public:
  static constexpr char const* registered_as = "grid format";
  GridFormat() = default;
  virtual ~GridFormat() = default;
  GridFormat(GridFormat const&) = delete;
  GridFormat& operator=(GridFormat const&) = delete;

  virtual std::vector<std::string> endings() const = 0; // of file names, as ".hgt"
  // Whether a file may have several grids, each a variable with a name.
  virtual bool hasVariables() const { return false; }

  // variable: "" for the only grid of the file, and always where there are no variables.
  // InputError, with file, place and what is expected there, for what is damaged or no grid.
  virtual GridData read(std::string const& file_name, std::string const& variable) const = 0;
};
using GridFormatRegistry = Registry<GridFormat>;
} // namespace asperity::geometry
