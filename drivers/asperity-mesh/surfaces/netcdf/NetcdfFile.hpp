#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace asperity::geometry
{
struct NetcdfAttribute
{
  std::string text;            // of an attribute of characters, without zeros at its end
  std::vector<double> numbers; // of any other
};

struct NetcdfVariable
{
  std::string name;
  std::vector<std::string> dimensions; // their names, "" where the file does not tell
  std::vector<std::uint64_t> shape;    // {} is a single value
  bool is_text = false;
  std::map<std::string, NetcdfAttribute> attributes;

  std::string text(std::string const& attribute) const; // "" if it has no such text
};

// A netCDF file: of the classic formats (CDF-1, CDF-2, CDF-5) or of netCDF-4, which is HDF5.
// InputError with the file's name for what is damaged or not there.
class NetcdfFile
{
public:
  virtual ~NetcdfFile() = default;

  std::vector<NetcdfVariable> const& variables() const { return variables_; }
  NetcdfVariable const& variable(std::string const& name) const;
  bool has(std::string const& name) const;
  // All values of a variable of numbers in the order of its dimensions, the last one fastest.
  virtual std::vector<double> numbers(std::string const& name) const = 0;
  // Of a variable of characters (rows, length): one text for each row, without zeros and blanks at
  // its end; a single text if it has one dimension.
  virtual std::vector<std::string> texts(std::string const& name) const = 0;

  std::string const& where() const { return where_; }

protected:
  explicit NetcdfFile(std::string where) : where_(std::move(where)) {}

  std::string where_; // "Grid file 'NAME'"
  std::vector<NetcdfVariable> variables_;
};

// what: "Grid file", for messages.
std::unique_ptr<NetcdfFile> openNetcdf(std::string const& file_name, std::string const& what);
// Also tells the attributes of a netCDF-4 file that its reader asks for.
std::unique_ptr<NetcdfFile> openNetcdf4(std::string const& file_name, std::string const& what);
} // namespace asperity::geometry
