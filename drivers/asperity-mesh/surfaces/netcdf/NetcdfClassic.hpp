#pragma once

#include "surfaces/files/BinaryFile.hpp"
#include "surfaces/netcdf/NetcdfFile.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace asperity::geometry
{
// A file of netCDF's classic formats, which HDF5 cannot read: versions 1 (CDF-1), 2 (64-bit
// offsets) and 5 (64-bit data). Dimensions and variables are known after construction; values are
// read on demand. Sizes in a damaged header are checked against the size of the file before memory
// is taken. InputError with file and byte.
class NetcdfClassic : public NetcdfFile
{
public:
  NetcdfClassic(std::string const& file_name, std::string const& what);

  std::map<std::string, std::uint64_t> const& dimensions() const { return sizes_; }
  std::map<std::string, NetcdfAttribute> const& attributes() const { return attributes_; }

  std::vector<double> numbers(std::string const& name) const override;
  std::vector<std::string> texts(std::string const& name) const override;

private:
  enum class Type;
  struct Layout // of a variable's values
  {
    Type type;
    std::uint64_t begin; // byte in the file
    std::uint64_t count; // of values, in a record if is_record
    bool is_record;      // the first dimension is the unlimited one
  };

  void readHeader();
  std::uint64_t count(); // of things in the file, 4 or 8 bytes
  std::uint64_t listLength(std::uint32_t tag, char const* things);
  std::string name();
  std::map<std::string, NetcdfAttribute> attributeList();
  void readDimensions();
  void readVariables();
  void readVariable();
  Type typeAt();
  double value(char const* bytes, Type type) const;
  std::vector<char> bytesOf(std::string const& name, Layout const& layout) const;
  Layout const& layoutOf(std::string const& name) const;
  static std::uint64_t sizeOf(Type type);

  mutable BinaryFile file_;
  int version_ = 0;
  std::uint64_t num_records_ = 0, record_size_ = 0;
  std::vector<std::string> dimension_names_;
  std::vector<std::uint64_t> dimension_sizes_;
  std::size_t unlimited_ = static_cast<std::size_t>(-1); // the number of that dimension
  std::map<std::string, std::uint64_t> sizes_;
  std::map<std::string, NetcdfAttribute> attributes_;
  std::map<std::string, Layout> layouts_;
};
} // namespace asperity::geometry
