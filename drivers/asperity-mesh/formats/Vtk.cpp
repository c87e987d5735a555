#include "formats/MeshFormat.hpp"
#include "formats/VtkGrid.hpp"
#include "surfaces/files/BinaryFile.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "registry/Registry.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace asperity::geometry
{
// VTK's legacy format, as text or binary (big-endian), of versions up to 5.1.
namespace
{
struct NumberType
{
  char const* name;
  std::size_t size;
  double (*read)(char const*);
};

template <class Number>
double readBig(char const* bytes)
{
  return static_cast<double>(fromBytes<Number>(bytes, ByteOrder::big));
}

constexpr NumberType number_types[] = {{"char", 1, readBig<std::int8_t>},
                                       {"unsigned_char", 1, readBig<std::uint8_t>},
                                       {"short", 2, readBig<std::int16_t>},
                                       {"unsigned_short", 2, readBig<std::uint16_t>},
                                       {"int", 4, readBig<std::int32_t>},
                                       {"unsigned_int", 4, readBig<std::uint32_t>},
                                       {"vtkidtype", 4, readBig<std::int32_t>},
                                       {"vtktypeint32", 4, readBig<std::int32_t>},
                                       {"vtktypeint64", 8, readBig<std::int64_t>},
                                       {"long", 8, readBig<std::int64_t>},
                                       {"unsigned_long", 8, readBig<std::uint64_t>},
                                       {"float", 4, readBig<float>},
                                       {"double", 8, readBig<double>}};

class LegacyFile
{
public:
  explicit LegacyFile(std::string const& file_name) : where_("Mesh file '" + file_name + "'")
  {
    BinaryFile file(file_name, "Mesh file");
    text_.resize(file.size());
    file.read(text_.data(), text_.size());
  }
  std::string const& where() const { return where_; }

  VtkGrid grid()
  {
    if (line().rfind("# vtk DataFile Version", 0) != 0) {
      fail("'# vtk DataFile Version' is expected at the beginning");
    }
    line(); // title
    const auto form = lower(trimmed(line()));
    is_binary_ = form == "binary";
    if (!is_binary_ && form != "ascii") {
      fail("ASCII or BINARY is expected, not '" + form + "'");
    }
    for (auto section = word(); !section.empty(); section = word()) {
      read(section);
    }
    return std::move(grid_);
  }

private:
  static std::string lower(std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
  }

  [[noreturn]] void fail(std::string const& message) const
  {
    throw InputError(where_ + ", byte " + std::to_string(at_) + ": " + message + '.');
  }

  std::string line()
  {
    const auto end = std::min(text_.find('\n', at_), text_.size());
    auto result = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    return result;
  }

  static bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

  std::string word() // "" at the end
  {
    while (at_ < text_.size() && isSpace(text_[at_])) {
      ++at_;
    }
    const auto begin = at_;
    while (at_ < text_.size() && !isSpace(text_[at_])) {
      ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }

  std::uint64_t count()
  {
    const auto text = word();
    const auto value = readInteger(text);
    if (!value || *value < 0) {
      fail("a number of values is expected, not '" + text + "'");
    }
    return static_cast<std::uint64_t>(*value);
  }

  // Skips the rest of the line before the values.
  std::vector<double> numbers(std::string const& type_name, std::uint64_t count)
  {
    const auto type =
      std::find_if(std::begin(number_types), std::end(number_types),
                   [&](NumberType const& one) { return lower(type_name) == one.name; });
    if (type == std::end(number_types)) {
      fail("numbers of type '" + type_name + "' cannot be read");
    }
    const auto room = text_.size() - at_;
    if (count > room / (is_binary_ ? type->size : 1)) {
      fail("the file is too short for " + std::to_string(count) + " numbers");
    }
    std::vector<double> values;
    values.reserve(count);
    if (is_binary_) {
      line();
      if (count > (text_.size() - at_) / type->size) {
        fail("the file is too short for " + std::to_string(count) + " numbers");
      }
      for (std::uint64_t i = 0; i < count; ++i, at_ += type->size) {
        values.push_back(type->read(&text_[at_]));
      }
      return values;
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto text = word();
      const auto value = readNumber(text);
      if (!value) {
        fail("a number is expected, not '" + text + "'");
      }
      values.push_back(*value);
    }
    return values;
  }

  std::vector<std::int64_t> integers(std::string const& type_name, std::uint64_t count)
  {
    std::vector<std::int64_t> result;
    for (double value : numbers(type_name, count)) {
      if (!(std::abs(value) < 1e15)) {
        fail("a whole number is expected, not " + formatNumber(value));
      }
      result.push_back(static_cast<std::int64_t>(value));
    }
    return result;
  }

  void read(std::string const& section)
  {
    const auto name = lower(section);
    if (name == "dataset") {
      const auto kind = word();
      if (lower(kind) != "unstructured_grid") {
        fail("a dataset UNSTRUCTURED_GRID is expected, not '" + kind + "'");
      }
    } else if (name == "points") {
      const auto number = count();
      grid_.points = numbers(word(), 3 * number);
    } else if (name == "cells") {
      readCells();
    } else if (name == "cell_types") {
      grid_.types = integers("int", count());
    } else if (name == "cell_data" || name == "point_data") {
      is_of_cells_ = name == "cell_data";
      num_data_ = count();
    } else if (name == "metadata") {
      while (at_ < text_.size() && !trimmed(line()).empty()) {
      }
    } else {
      readData(name);
    }
  }

  void readCells()
  {
    const auto first = count(), second = count();
    const auto before = at_;
    if (lower(word()) == "offsets") { // version 5.1
      auto offsets = integers(word(), first);
      if (offsets.empty() || lower(word()) != "connectivity") {
        fail("OFFSETS and CONNECTIVITY are expected");
      }
      grid_.offsets.assign(offsets.begin() + 1, offsets.end());
      grid_.connectivity = integers(word(), second);
      return;
    }
    at_ = before;
    const auto all = integers("int", second);
    for (std::size_t i = 0; i < all.size();) {
      const auto left = static_cast<std::int64_t>(all.size() - i) - 1;
      if (all[i] < 0 || all[i] > left) {
        fail("a cell has " + std::to_string(all[i]) + " points, and " + std::to_string(left) +
             " are left");
      }
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      grid_.connectivity.insert(grid_.connectivity.end(), begin, begin + all[i]);
      grid_.offsets.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
      i += static_cast<std::size_t>(all[i]) + 1;
    }
    if (grid_.offsets.size() != first) {
      fail("there are " + std::to_string(grid_.offsets.size()) + " cells, not " +
           std::to_string(first));
    }
  }

  // Attributes of points or cells. Only single numbers of cells are kept.
  void readData(std::string const& kind)
  {
    if (kind == "field") {
      word();
      for (auto left = count(); left > 0; --left) {
        auto name = word();
        if (lower(name) == "metadata") {
          read(name);
          name = word();
        }
        const auto components = count(), rows = count();
        keep(name, components, numbers(word(), product(components, rows)));
      }
    } else if (kind == "scalars") {
      std::istringstream words(line());
      std::string name, type;
      std::uint64_t components = 1;
      words >> name >> type;
      words >> components;
      components = words.fail() ? 1 : components;
      const auto before = at_;
      if (lower(word()) == "lookup_table") {
        word();
      } else {
        at_ = before;
      }
      keep(name, components, numbers(type, product(components, num_data_)));
    } else if (kind == "vectors" || kind == "normals" || kind == "tensors" ||
               kind == "global_ids" || kind == "pedigree_ids") {
      word();
      const std::uint64_t components = kind == "tensors"                  ? 9
                                       : kind[0] == 'v' || kind[0] == 'n' ? 3
                                                                          : 1;
      numbers(word(), product(components, num_data_));
    } else if (kind == "lookup_table") {
      word();
      numbers(is_binary_ ? "unsigned_char" : "float", product(4, count()));
    } else {
      fail("section '" + excerpt(kind) + "' is not known");
    }
  }

  std::uint64_t product(std::uint64_t a, std::uint64_t b) const
  {
    if (b != 0 && a > text_.size() / b) {
      fail("the file is too short for " + std::to_string(a) + " times " + std::to_string(b) +
           " numbers");
    }
    return a * b;
  }

  void keep(std::string const& name, std::uint64_t components, std::vector<double> values)
  {
    if (is_of_cells_ && components == 1) {
      grid_.cell_data[name] = std::move(values);
    }
  }

  std::string where_, text_;
  std::size_t at_ = 0;
  bool is_binary_ = false, is_of_cells_ = false;
  std::uint64_t num_data_ = 0;
  VtkGrid grid_;
};

class Vtk final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".vtk"}; }
  std::vector<FormatOption> ownOptions() const override { return vtkOptions(); }
  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    LegacyFile file(file_name);
    return meshOf(file.grid(), options, file.where());
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "VTK", Vtk)
} // namespace asperity::geometry
