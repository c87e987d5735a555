#include "surfaces/files/BinaryFile.hpp"
#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/files/TextFile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

// PLY: a header that declares elements and their properties, then the elements, as text or in
// binary of either byte order. Elements other than `vertex` and `face` are skipped.
namespace asperity::geometry
{
namespace
{
enum class Type
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

const std::map<std::string, Type, std::less<>> types = {
  {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
  {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
  {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
  {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
  {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
  {"float64", Type::float64}};

std::uint64_t sizeOf(Type type)
{
  return type == Type::float64                         ? 8
         : type <= Type::uint8                         ? 1
         : type == Type::int16 || type == Type::uint16 ? 2
                                                       : 4;
}

struct Property
{
  std::string name;
  Type type = Type::float32;
  std::optional<Type> count; // of a list
};

struct Element
{
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  std::optional<std::size_t> find(std::string const& property) const
  {
    for (std::size_t i = 0; i < properties.size(); ++i) {
      if (properties[i].name == property) {
        return i;
      }
    }
    return std::nullopt;
  }
  std::uint64_t leastSize(bool is_text) const // [bytes]
  {
    std::uint64_t size = 0;
    for (auto const& property : properties) {
      size += is_text ? 2 : sizeOf(property.count.value_or(property.type));
    }
    return std::max<std::uint64_t>(size, 1);
  }
};

struct Header
{
  std::vector<Element> elements;
  bool is_text = false;
  ByteOrder order = ByteOrder::little;
};

Type typeAt(TextFile const& file, std::size_t i)
{
  const auto found = types.find(file.word(i));
  if (found == types.end()) {
    file.fail("'" + std::string(file.word(i)) + "' is no type of PLY.");
  }
  return found->second;
}

void readFormat(TextFile const& file, Header& header)
{
  file.require(2, "format ascii 1.0");
  auto const word = file.word(1);
  header.is_text = word == "ascii";
  header.order = word == "binary_big_endian" ? ByteOrder::big : ByteOrder::little;
  if (!header.is_text && word != "binary_big_endian" && word != "binary_little_endian") {
    file.fail("format '" + std::string(word) +
              "' is none of ascii, binary_little_endian and binary_big_endian.");
  }
}

void readProperty(TextFile const& file, std::vector<Element>& elements)
{
  if (elements.empty()) {
    file.fail("a property stands before the first element.");
  }
  file.require(3, "property type name");
  Property property;
  if (file.word(1) == "list") {
    file.require(5, "property list type type name");
    property.count = typeAt(file, 2);
  }
  const std::size_t at = property.count ? 3 : 1;
  property.type = typeAt(file, at);
  property.name = std::string(file.word(at + 1));
  elements.back().properties.push_back(property);
}

Header readHeader(TextFile& file)
{
  Header header;
  bool has_format = false;
  if (!file.next() || file.word(0) != "ply") {
    file.fail("'ply' is expected on the first line.");
  }
  while (file.next()) {
    auto const key = file.word(0);
    if (key == "end_header") {
      if (!has_format) {
        file.fail("the header has no line 'format'.");
      }
      return header;
    }
    if (key == "format") {
      readFormat(file, header);
      has_format = true;
    } else if (key == "element") {
      file.require(3, "element name count");
      const auto count = file.integer(2);
      if (count < 0) {
        file.fail("the count is negative.");
      }
      header.elements.push_back({std::string(file.word(1)), static_cast<std::uint64_t>(count), {}});
    } else if (key == "property") {
      readProperty(file, header.elements);
    } else if (key != "comment" && key != "obj_info") {
      file.fail("'" + std::string(key) + "' is not known in a header of PLY.");
    }
  }
  file.fail("the file ends within its header: it is cut.");
}

// The numbers of an element, one after the other.
class TextSource
{
public:
  explicit TextSource(TextFile& file) : file_(file) {}
  void requireBytes(std::uint64_t count, std::uint64_t bytes_each, std::string const& things) const
  {
    if (count > (file_.size() - std::min(file_.size(), file_.offset())) / bytes_each + 1) {
      fail("the file names " + std::to_string(count) + " " + things +
           ", for which it is too "
           "small.");
    }
  }
  void begin()
  {
    if (!file_.next()) {
      fail("the file ends before all elements are there: it is cut.");
    }
    word_ = 0;
  }
  double number(Type) { return file_.number(word_++); }
  [[noreturn]] void fail(std::string const& message) const { file_.fail(message); }

private:
  TextFile& file_;
  std::size_t word_ = 0;
};

class BinarySource
{
public:
  BinarySource(BinaryFile& file, ByteOrder order) : file_(file), order_(order) {}
  void requireBytes(std::uint64_t count, std::uint64_t bytes_each, std::string const& things) const
  {
    file_.requireBytes(count, bytes_each, things);
  }
  void begin() {}
  double number(Type type)
  {
    switch (type) {
    case Type::int8: return file_.number<std::int8_t>(order_);
    case Type::uint8: return file_.number<std::uint8_t>(order_);
    case Type::int16: return file_.number<std::int16_t>(order_);
    case Type::uint16: return file_.number<std::uint16_t>(order_);
    case Type::int32: return file_.number<std::int32_t>(order_);
    case Type::uint32: return file_.number<std::uint32_t>(order_);
    case Type::float32: return file_.number<float>(order_);
    default: return file_.number<double>(order_);
    }
  }
  [[noreturn]] void fail(std::string const& message) const { file_.fail(message); }

private:
  BinaryFile& file_;
  ByteOrder order_;
};

template <class Source>
class Body
{
public:
  Body(Header const& header, Source source) : header_(header), source_(std::move(source)) {}

  TriangleSurface run()
  {
    for (auto const& element : header_.elements) {
      source_.requireBytes(element.count, element.leastSize(header_.is_text),
                           "elements '" + element.name + "'");
      if (element.name == "vertex") {
        readVertices(element);
      } else if (element.name == "face") {
        readFaces(element);
      } else {
        for (std::uint64_t i = 0; i < element.count; ++i) {
          readElement(element);
        }
      }
    }
    return std::move(surface_);
  }

private:
  // Scalars of the element, and the items of the list `kept`.
  void readElement(Element const& element, std::optional<std::size_t> kept = std::nullopt)
  {
    source_.begin();
    scalars_.resize(element.properties.size());
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      auto const& property = element.properties[p];
      if (!property.count) {
        scalars_[p] = source_.number(property.type);
        continue;
      }
      const double count = source_.number(*property.count);
      if (!(count >= 0 && count <= most_items)) {
        source_.fail("a list of " + element.name + " has a count that is not in [0, 1e6].");
      }
      if (p == kept) {
        items_.clear();
      }
      for (int i = 0; i < static_cast<int>(count); ++i) {
        const double item = source_.number(property.type);
        if (p == kept) {
          items_.push_back(item);
        }
      }
    }
  }

  void readVertices(Element const& element)
  {
    std::array<std::size_t, 3> at{};
    for (std::size_t d = 0; d < 3; ++d) {
      const auto found = element.find(std::string(1, "xyz"[d]));
      if (!found || element.properties[*found].count) {
        source_.fail("the element 'vertex' has no property x, y or z.");
      }
      at[d] = *found;
    }
    surface_.points.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      readElement(element);
      auto& point = surface_.points.emplace_back();
      for (std::size_t d = 0; d < 3; ++d) {
        point[d] = scalars_[at[d]];
        if (!std::isfinite(point[d])) {
          source_.fail("vertex " + std::to_string(i) + " has a coordinate that is not finite.");
        }
      }
    }
  }

  void readFaces(Element const& element)
  {
    auto list = element.find("vertex_indices");
    list = list ? list : element.find("vertex_index");
    if (!list || !element.properties[*list].count) {
      source_.fail("the element 'face' has no list 'vertex_indices'.");
    }
    const double end = static_cast<double>(surface_.points.size());
    std::vector<int> corners;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      readElement(element, list);
      if (items_.size() < 3) {
        source_.fail("face " + std::to_string(i) + " has fewer than 3 corners.");
      }
      corners.clear();
      for (const double item : items_) {
        if (!(item >= 0 && item < end && item == std::floor(item))) {
          source_.fail("face " + std::to_string(i) + " names vertex " + std::to_string(item) +
                       ", which is outside [0, " + std::to_string(surface_.points.size()) + ").");
        }
        corners.push_back(static_cast<int>(item));
      }
      addPolygon(surface_, corners);
    }
  }

  static constexpr double most_items = 1e6;
  Header const& header_;
  Source source_;
  TriangleSurface surface_;
  std::vector<double> scalars_, items_;
};

std::vector<SurfacePart> readPly(std::string const& file_name)
{
  TextFile text(file_name, "Surface file");
  const Header header = readHeader(text);
  std::vector<SurfacePart> parts(1);
  if (header.is_text) {
    parts.front().surface = Body(header, TextSource(text)).run();
  } else {
    BinaryFile binary(file_name, "Surface file");
    binary.seek(text.offset());
    parts.front().surface = Body(header, BinarySource(binary, header.order)).run();
  }
  return parts;
}

class Ply final : public SurfaceFormat
{
public:
  std::vector<std::string> endings() const override { return {".ply"}; }
  std::vector<SurfacePart> read(std::string const& file_name) const override
  {
    return readPly(file_name);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceFormatRegistry, "PLY", Ply)
} // namespace asperity::geometry
