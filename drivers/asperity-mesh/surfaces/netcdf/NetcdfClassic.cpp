#include "surfaces/netcdf/NetcdfClassic.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace asperity::geometry
{
// The numbers that the format gives its types; those from `uint8` on are of version 5.
enum class NetcdfClassic::Type
{
  int8 = 1,
  text = 2,
  int16 = 3,
  int32 = 4,
  float32 = 5,
  float64 = 6,
  uint8 = 7,
  uint16 = 8,
  uint32 = 9,
  int64 = 10,
  uint64 = 11
};

namespace
{
constexpr std::uint32_t tag_of_dimensions = 10, tag_of_variables = 11, tag_of_attributes = 12;
constexpr auto classic_order = ByteOrder::big;

std::uint64_t padded(std::uint64_t size) { return (size + 3) / 4 * 4; }

std::string withoutEnd(std::string text)
{
  text.resize(std::min(text.size(), text.find('\0')));
  text.erase(text.find_last_not_of(" \n\t") + 1);
  return text;
}

// False if the product exceeds 64 bits.
bool multiply(std::uint64_t& product, std::uint64_t factor)
{
  if (factor != 0 && product > UINT64_MAX / factor) {
    return false;
  }
  product *= factor;
  return true;
}
} // namespace

std::uint64_t NetcdfClassic::sizeOf(Type type)
{
  switch (type) {
  case Type::int8:
  case Type::text:
  case Type::uint8: return 1;
  case Type::int16:
  case Type::uint16: return 2;
  case Type::int32:
  case Type::float32:
  case Type::uint32: return 4;
  default: return 8;
  }
}

NetcdfClassic::NetcdfClassic(std::string const& file_name, std::string const& what)
    : NetcdfFile(what + " '" + file_name + "'")
    , file_(file_name, what)
{
  readHeader();
}

void NetcdfClassic::readHeader()
{
  std::array<char, 4> magic{};
  file_.read(magic.data(), magic.size());
  version_ = magic[3];
  if (std::string(magic.data(), 3) != "CDF" || (version_ != 1 && version_ != 2 && version_ != 5)) {
    file_.fail("'CDF' and version 1, 2 or 5 are expected at the beginning.");
  }
  num_records_ = count();
  readDimensions();
  attributes_ = attributeList();
  readVariables();
}

std::uint64_t NetcdfClassic::count()
{
  return version_ == 5 ? file_.number<std::uint64_t>(classic_order)
                       : file_.number<std::uint32_t>(classic_order);
}

// Each thing has at least 4 bytes.
std::uint64_t NetcdfClassic::listLength(std::uint32_t tag, char const* things)
{
  const auto found = file_.number<std::uint32_t>(classic_order);
  const auto length = count();
  if (found != tag && (found != 0 || length != 0)) {
    file_.fail("the list of " + std::string(things) + " is expected: the header is damaged.");
  }
  file_.requireBytes(length, 4, things);
  return length;
}

std::string NetcdfClassic::name()
{
  const auto length = count();
  file_.requireBytes(length, 1, "characters of a name");
  std::string text(padded(length), '\0');
  file_.read(text.data(), text.size());
  text.resize(length);
  return text;
}

NetcdfClassic::Type NetcdfClassic::typeAt()
{
  const auto type = file_.number<std::uint32_t>(classic_order);
  if (type < 1 || type > (version_ == 5 ? 11u : 6u)) {
    file_.fail("type " + std::to_string(type) + " is not known: the header is damaged.");
  }
  return static_cast<Type>(type);
}

std::map<std::string, NetcdfAttribute> NetcdfClassic::attributeList()
{
  std::map<std::string, NetcdfAttribute> result;
  const auto length = listLength(tag_of_attributes, "attributes");
  for (std::uint64_t i = 0; i < length; ++i) {
    auto& attribute = result[name()];
    const Type type = typeAt();
    const auto num_values = count();
    file_.requireBytes(num_values, sizeOf(type), "values of an attribute");
    std::vector<char> bytes(padded(num_values * sizeOf(type)));
    file_.read(bytes.data(), bytes.size());
    if (type == Type::text) {
      attribute.text = withoutEnd(std::string(bytes.data(), num_values));
      continue;
    }
    for (std::uint64_t k = 0; k < num_values; ++k) {
      attribute.numbers.push_back(value(&bytes[k * sizeOf(type)], type));
    }
  }
  return result;
}

void NetcdfClassic::readDimensions()
{
  const auto length = listLength(tag_of_dimensions, "dimensions");
  for (std::uint64_t i = 0; i < length; ++i) {
    dimension_names_.push_back(name());
    dimension_sizes_.push_back(count());
    if (dimension_sizes_.back() == 0) {
      unlimited_ = i;
      dimension_sizes_.back() = num_records_;
    }
    sizes_[dimension_names_.back()] = dimension_sizes_.back();
  }
}

void NetcdfClassic::readVariables()
{
  const auto length = listLength(tag_of_variables, "variables");
  for (std::uint64_t i = 0; i < length; ++i) {
    readVariable();
  }
  // Records have the values of all such variables, each filled up to 4 bytes, but not a single one.
  std::uint64_t num_variables = 0, last = 0;
  for (auto const& [unused, layout] : layouts_) {
    if (layout.is_record) {
      ++num_variables;
      last = layout.count * sizeOf(layout.type);
      record_size_ += padded(last);
    }
  }
  record_size_ = num_variables == 1 ? last : record_size_;
}

void NetcdfClassic::readVariable()
{
  NetcdfVariable variable;
  variable.name = name();
  const auto num_dimensions = count();
  file_.requireBytes(num_dimensions, 4, "dimensions of a variable");
  Layout layout{Type::int8, 0, 1, false};
  for (std::uint64_t d = 0; d < num_dimensions; ++d) {
    const auto number = count();
    if (number >= dimension_names_.size()) {
      file_.fail("variable '" + variable.name + "' has a dimension that is not in the file.");
    }
    variable.dimensions.push_back(dimension_names_[number]);
    variable.shape.push_back(dimension_sizes_[number]);
    if (d == 0 && number == unlimited_) {
      layout.is_record = true;
    } else if (!multiply(layout.count, dimension_sizes_[number]) || layout.count > file_.size()) {
      file_.fail("variable '" + variable.name + "' is larger than the file.");
    }
  }
  variable.attributes = attributeList();
  layout.type = typeAt();
  count(); // the size, which is not reliable for large variables
  layout.begin = version_ == 1 ? file_.number<std::uint32_t>(classic_order)
                               : file_.number<std::uint64_t>(classic_order);
  variable.is_text = layout.type == Type::text;
  layouts_.emplace(variable.name, layout);
  variables_.push_back(std::move(variable));
}

double NetcdfClassic::value(char const* bytes, Type type) const
{
  switch (type) {
  case Type::int8: return fromBytes<std::int8_t>(bytes, classic_order);
  case Type::int16: return fromBytes<std::int16_t>(bytes, classic_order);
  case Type::int32: return fromBytes<std::int32_t>(bytes, classic_order);
  case Type::float32: return fromBytes<float>(bytes, classic_order);
  case Type::float64: return fromBytes<double>(bytes, classic_order);
  case Type::uint16: return fromBytes<std::uint16_t>(bytes, classic_order);
  case Type::uint32: return fromBytes<std::uint32_t>(bytes, classic_order);
  case Type::int64: return static_cast<double>(fromBytes<std::int64_t>(bytes, classic_order));
  case Type::uint64: return static_cast<double>(fromBytes<std::uint64_t>(bytes, classic_order));
  default: // uint8, text
    return fromBytes<std::uint8_t>(bytes, classic_order);
  }
}

NetcdfClassic::Layout const& NetcdfClassic::layoutOf(std::string const& name) const
{
  return layouts_.at(variable(name).name);
}

std::vector<char> NetcdfClassic::bytesOf(std::string const& name, Layout const& layout) const
{
  const std::uint64_t size = layout.count * sizeOf(layout.type);
  const std::uint64_t num_parts = layout.is_record ? num_records_ : 1;
  if (num_parts == 0 || size == 0) {
    return {};
  }
  file_.seek(layout.begin);
  file_.requireBytes(num_parts - 1, std::max<std::uint64_t>(record_size_, 1), "more records");
  file_.seek(layout.begin + (num_parts - 1) * record_size_);
  file_.requireBytes(size, 1, "bytes of variable '" + name + "'");
  std::vector<char> bytes(num_parts * size);
  for (std::uint64_t part = 0; part < num_parts; ++part) {
    file_.seek(layout.begin + part * record_size_);
    file_.read(&bytes[part * size], size);
  }
  return bytes;
}

std::vector<double> NetcdfClassic::numbers(std::string const& name) const
{
  Layout const& layout = layoutOf(name);
  ASPERITY_REQUIRE(layout.type != Type::text,
                   where_ << ": variable '" << name << "' has characters, not numbers.");
  const auto bytes = bytesOf(name, layout);
  const std::uint64_t size = sizeOf(layout.type);
  std::vector<double> result(bytes.size() / size);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = value(&bytes[i * size], layout.type);
  }
  return result;
}

std::vector<std::string> NetcdfClassic::texts(std::string const& name) const
{
  Layout const& layout = layoutOf(name);
  ASPERITY_REQUIRE(layout.type == Type::text,
                   where_ << ": variable '" << name << "' has numbers, not characters.");
  const auto bytes = bytesOf(name, layout);
  auto const& shape = variable(name).shape;
  const std::uint64_t length = shape.empty() ? 1 : shape.back();
  std::vector<std::string> result;
  for (std::uint64_t at = 0; length > 0 && at + length <= bytes.size(); at += length) {
    result.push_back(withoutEnd(std::string(&bytes[at], length)));
  }
  return result;
}
} // namespace asperity::geometry
