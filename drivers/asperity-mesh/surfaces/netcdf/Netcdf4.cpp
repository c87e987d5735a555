#include "surfaces/netcdf/NetcdfFile.hpp"
#include "surfaces/netcdf/UntrustedWork.hpp"

#include "base/Errors.hpp"
#include "hdf5/File.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

// netCDF-4 is HDF5: variables are datasets of the root group, and the coordinates of dimensions are
// datasets that call themselves dimension scales.
namespace asperity::geometry
{
namespace
{
// Attributes of CF, of netCDF itself and of Exodus that readers look at.
constexpr char const* attributes_read[] = {
  "units",         "standard_name",       "axis",         "positive",   "long_name",
  "_FillValue",    "missing_value",       "scale_factor", "add_offset", "CLASS",
  "_Netcdf4Dimid", "_Netcdf4Coordinates", "elem_type"};

NetcdfAttribute readAttribute(h5::Dataset const& dataset, std::string const& name)
{
  NetcdfAttribute attribute;
  try {
    attribute.text = dataset.textAttribute(name);
  } catch (h5::Error const&) {
    try {
      attribute.numbers = dataset.numbersAttribute(name);
    } catch (h5::Error const&) { // of another type, which no reader asks for
    }
  }
  return attribute;
}

// HDF5 itself crashes on some damaged files, or does not come to an end: until 1.10.8 it does not
// check the reference of a text of variable length, for example (H5HG_read). `where` begins the
// message.
void requireNoCrash(std::string const& file_name, std::string const& where,
                    std::function<void()> const& read)
{
  constexpr std::uint64_t least = 2, bytes_per_second = 1000000; // far slower than any read
  std::error_code unknown;
  const auto size = std::filesystem::file_size(file_name, unknown);
  const std::uint64_t seconds = least + (unknown ? 0 : size / bytes_per_second);
  ASPERITY_REQUIRE(
    endsInATrial(read, seconds),
    where << " cannot be read: it is damaged in a way that makes HDF5 crash. Copy the "
             "file again from its source, or write it once more.");
}

class Netcdf4 : public NetcdfFile
{
public:
  Netcdf4(std::string const& file_name, std::string const& what)
      : NetcdfFile(what + " '" + file_name + "'")
      , file_name_(file_name)
      , file_(readable([&] { return h5::File::open(file_name); }))
  {
    constexpr std::uint64_t plenty = std::uint64_t(256) << 20; // bytes, for names and attributes
    const MemoryLimit limit(plenty); // the length of a text may be damaged
    for (auto const& name : readable([&] { return file_.names(); })) {
      try {
        addVariable(name, file_.openDataset(name));
      } catch (h5::Error const&) { // a type or a group
      }
    }
    for (auto& each : variables_) {
      nameDimensions(each);
    }
  }

  std::vector<double> numbers(std::string const& name) const override
  {
    ASPERITY_REQUIRE(!variable(name).is_text,
                     where_ << ": variable '" << name << "' has no numbers.");
    return valuesOf(name, [&] { return file_.openDataset(name).read<double>(); });
  }

  std::vector<std::string> texts(std::string const& name) const override
  {
    auto const& wanted = variable(name);
    ASPERITY_REQUIRE(wanted.is_text, where_ << ": variable '" << name << "' has no characters.");
    return valuesOf(name, [&] { return rows(file_.openDataset(name).readTexts(), wanted.shape); });
  }

private:
  // Characters are texts of length 1, of which the last dimension makes one; a blank at the end and
  // a zero are no part of it.
  static std::vector<std::string> rows(std::vector<std::string> const& pieces,
                                       std::vector<std::uint64_t> const& shape)
  {
    const std::size_t length = shape.empty() ? 1 : std::max<std::size_t>(shape.back(), 1);
    std::vector<std::string> result;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i % length == 0) {
        result.emplace_back();
      }
      result.back() += pieces[i];
    }
    for (auto& text : result) {
      text.erase(text.find_last_not_of(" \n\t") + 1);
    }
    return result;
  }

  // Values are read twice, first in a trial: damage of their layout, too, can make HDF5 crash.
  template <class Call>
  std::invoke_result_t<Call> valuesOf(std::string const& name, Call const& read) const
  {
    const std::string where = where_ + ": variable '" + name + "'";
    requireNoCrash(file_name_, where, read);
    try {
      return read();
    } catch (h5::Error const& error) {
      throw InputError(where + " cannot be read. " + error.what());
    }
  }

  template <class Call>
  std::invoke_result_t<Call> readable(Call const& call) const
  {
    try {
      return call();
    } catch (h5::Error const& error) {
      throw InputError(where_ + " cannot be read: it is cut or damaged. " + error.what());
    }
  }

  void addVariable(std::string const& name, h5::Dataset const& dataset)
  {
    NetcdfVariable added;
    added.name = name;
    for (const auto extent : dataset.shape()) {
      added.shape.push_back(extent);
    }
    added.is_text = dataset.valueClass() != h5::ValueClass::real &&
                    dataset.valueClass() != h5::ValueClass::integer;
    for (char const* attribute : attributes_read) {
      if (dataset.hasAttribute(attribute)) {
        added.attributes[attribute] = readAttribute(dataset, attribute);
      }
    }
    variables_.push_back(std::move(added));
  }

  static bool isScale(NetcdfVariable const& each)
  {
    return each.shape.size() == 1 && each.text("CLASS") == "DIMENSION_SCALE";
  }

  // By the numbers that netCDF gives dimensions, if they are there, else by the only scale of that
  // length. In a square grid without these numbers names are left out.
  void nameDimensions(NetcdfVariable& each) const
  {
    each.dimensions.assign(each.shape.size(), "");
    if (isScale(each)) {
      each.dimensions = {each.name};
      return;
    }
    const auto numbers = each.attributes.find("_Netcdf4Coordinates");
    for (std::size_t d = 0; d < each.shape.size(); ++d) {
      std::vector<std::string> fitting;
      for (auto const& scale : variables_) {
        const auto number = scale.attributes.find("_Netcdf4Dimid");
        const bool is_numbered =
          numbers != each.attributes.end() && d < numbers->second.numbers.size() &&
          number != scale.attributes.end() && !number->second.numbers.empty();
        if (isScale(scale) && scale.shape[0] == each.shape[d] &&
            (!is_numbered || number->second.numbers[0] == numbers->second.numbers[d])) {
          fitting.push_back(scale.name);
        }
      }
      each.dimensions[d] = fitting.size() == 1 ? fitting.front() : "";
    }
  }

  std::string file_name_;
  h5::File file_;
};
} // namespace

std::unique_ptr<NetcdfFile> openNetcdf4(std::string const& file_name, std::string const& what)
{
  requireNoCrash(file_name, what + " '" + file_name + "'",
                 [&] { const Netcdf4 trial(file_name, what); });
  return std::make_unique<Netcdf4>(file_name, what);
}
} // namespace asperity::geometry
