#include "formats/VtkXml.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <sstream>

#ifdef ASPERITY_HAVE_ZLIB
#include <zlib.h>
#endif

namespace asperity::geometry
{
namespace
{
// The bytes of a text in base64 from a place on, up to `count` of them. Pieces that end with '='
// may follow each other.
std::string fromBase64(std::string const& text, std::size_t at, std::size_t count)
{
  static const std::string digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int num_digits = 0, num_padding = 0;
  for (; at < text.size() && bytes.size() < count; ++at) {
    const auto digit = digits.find(text[at]);
    if (digit == std::string::npos && text[at] != '=') {
      if (text[at] == '<') {
        break;
      }
      continue; // a blank
    }
    num_padding += text[at] == '=' ? 1 : 0;
    bits = (bits << 6) | (text[at] == '=' ? 0 : static_cast<std::uint32_t>(digit));
    if (++num_digits == 4) {
      for (int shift = 16; shift >= 8 * num_padding; shift -= 8) {
        bytes.push_back(static_cast<char>((bits >> shift) & 255));
      }
      bits = 0;
      num_digits = num_padding = 0;
    }
  }
  bytes.resize(std::min(bytes.size(), count));
  return bytes;
}
} // namespace

std::string VtkXml::Tag::attribute(std::string const& key, std::string const& without) const
{
  const auto found = attributes.find(key);
  return found == attributes.end() ? without : found->second;
}

VtkXml::VtkXml(std::string const& file_name, std::string const& type)
    : where_("Mesh file '" + file_name + "'")
{
  BinaryFile file(file_name, "Mesh file");
  text_.resize(file.size());
  file.read(text_.data(), text_.size());
  findAppended();
  bool is_of_type = false, is_whole = false;
  for (auto tag = next(0); !tag.name.empty() && !is_whole; tag = next(tag.end)) {
    is_whole = tag.name == "/" + type;
    if (tag.name == "VTKFile") {
      is_of_type = tag.attribute("type") == type;
      readFileTag(tag);
    }
  }
  require(is_of_type && is_whole,
          "is not a complete file of VTK's type " + type + ": it is cut or of another type");
}

void VtkXml::require(bool condition, std::string const& message) const
{
  ASPERITY_REQUIRE(condition, where_ << ' ' << message << '.');
}

// The next tag from a place on; without a name if there is none.
VtkXml::Tag VtkXml::next(std::size_t at) const
{
  Tag tag;
  const auto begin = text_.find('<', at), limit = std::min(text_.size(), appended_);
  const auto end = begin >= limit ? std::string::npos : text_.find('>', begin);
  if (begin >= limit || end == std::string::npos) {
    return tag;
  }
  tag.end = end + 1;
  const auto inside = text_.substr(begin + 1, end - begin - 1);
  const auto blank = inside.find_first_of(" \t\r\n");
  tag.name = inside.substr(0, blank);
  for (auto key = blank; key != std::string::npos && key < inside.size();) {
    const auto equals = inside.find('=', key);
    const auto open = equals == std::string::npos ? equals : inside.find_first_of("\"'", equals);
    const auto close = open == std::string::npos ? open : inside.find(inside[open], open + 1);
    if (close == std::string::npos) {
      break;
    }
    tag.attributes[trimmed(inside.substr(key, equals - key))] =
      inside.substr(open + 1, close - open - 1);
    key = close + 1;
  }
  tag.name = tag.name.empty() ? "?" : tag.name;
  return tag;
}

// Appended data begin behind '_'.
void VtkXml::findAppended()
{
  const auto found = text_.find("<AppendedData");
  if (found != std::string::npos) {
    const auto tag = next(found);
    const auto mark = text_.find('_', tag.end);
    require(!tag.name.empty() && mark != std::string::npos, "has appended data without '_'");
    is_base64_ = tag.attribute("encoding") == "base64";
    appended_ = mark + 1;
  }
}

void VtkXml::readFileTag(Tag const& tag)
{
  order_ = tag.attribute("byte_order") == "BigEndian" ? ByteOrder::big : ByteOrder::little;
  size_of_count_ = tag.attribute("header_type", "UInt32") == "UInt64" ? 8 : 4;
  const auto compressor = tag.attribute("compressor");
  is_compressed_ = !compressor.empty();
  require(!is_compressed_ || compressor == "vtkZLibDataCompressor",
          "is compressed by " + compressor + ". Save it with zlib or without compression");
}

std::vector<double> VtkXml::valuesOf(Tag const& tag) const
{
  const auto name = tag.attribute("Name");
  const auto format = tag.attribute("format");
  if (format == "ascii") {
    return fromText(tag.end, name);
  }
  const bool is_appended = format == "appended";
  require(is_appended || format == "binary",
          "has array '" + name + "' of unknown format '" + format + "'");
  auto at = tag.end;
  if (is_appended) {
    const auto offset = readNumber(tag.attribute("offset"));
    require(appended_ < text_.size() && offset && *offset >= 0 &&
              *offset < static_cast<double>(text_.size() - appended_),
            "has array '" + name + "' whose offset is not in the file");
    at = appended_ + static_cast<std::size_t>(*offset);
  }
  return fromBinary(is_compressed_ ? inflated(at, is_appended, name) : plain(at, is_appended, name),
                    tag.attribute("type"), name);
}

std::vector<double> VtkXml::fromText(std::size_t at, std::string const& name) const
{
  const auto end = text_.find('<', at);
  std::istringstream words(text_.substr(at, end == std::string::npos ? end : end - at));
  std::vector<double> values;
  for (std::string word; words >> word;) {
    const auto value = readNumber(word);
    require(value.has_value(),
            "has '" + excerpt(word) + "' in array '" + name + "', where a number is expected");
    values.push_back(*value);
  }
  return values;
}

// The first bytes of the data that begin there.
std::string VtkXml::bytes(std::size_t at, bool is_appended, std::size_t count,
                          std::string const& name) const
{
  require(count <= text_.size(), "is too short for array '" + name + "'");
  auto result = is_appended && !is_base64_ ? text_.substr(at, count) : fromBase64(text_, at, count);
  require(result.size() == count, "is too short for array '" + name + "'");
  return result;
}

std::uint64_t VtkXml::countAt(std::string const& header, std::size_t place) const
{
  auto const* at = &header[place * size_of_count_];
  return size_of_count_ == 8 ? fromBytes<std::uint64_t>(at, order_)
                             : fromBytes<std::uint32_t>(at, order_);
}

std::string VtkXml::plain(std::size_t at, bool is_appended, std::string const& name) const
{
  const auto size = countAt(bytes(at, is_appended, size_of_count_, name), 0);
  require(size <= text_.size(), "is too short for array '" + name + "'");
  return bytes(at, is_appended, size_of_count_ + size, name).substr(size_of_count_);
}

// Blocks: their number, the size of each but the last one, of the last one if it is smaller, and
// the compressed sizes.
std::string VtkXml::inflated([[maybe_unused]] std::size_t at, [[maybe_unused]] bool is_appended,
                             std::string const& name) const
{
#ifdef ASPERITY_HAVE_ZLIB
  const auto num_blocks = countAt(bytes(at, is_appended, size_of_count_, name), 0);
  require(num_blocks < text_.size(), "is too short for array '" + name + "'");
  const auto header_size = (3 + num_blocks) * size_of_count_;
  const auto header = bytes(at, is_appended, header_size, name);
  std::uint64_t all = header_size;
  for (std::uint64_t i = 0; i < num_blocks; ++i) {
    const auto size = countAt(header, 3 + i);
    require(size <= text_.size() && all <= text_.size(), "is too short for array '" + name + "'");
    all += size;
  }
  const auto packed = bytes(at, is_appended, all, name);
  const auto last = countAt(header, 2);
  std::string result;
  std::size_t from = header_size;
  for (std::uint64_t i = 0; i < num_blocks; ++i) {
    const auto size = static_cast<std::size_t>(countAt(header, 3 + i));
    uLongf room = i + 1 == num_blocks && last > 0 ? last : countAt(header, 1);
    constexpr std::uint64_t most = 1100; // zlib packs no better than by this factor
    require(room / most <= size, "has array '" + name + "', whose sizes are damaged");
    std::string block(room, '\0');
    const int status =
      uncompress(reinterpret_cast<Bytef*>(block.data()), &room,
                 reinterpret_cast<Bytef const*>(&packed[from]), static_cast<uLong>(size));
    require(status == Z_OK && room == block.size(),
            "has array '" + name + "', which cannot be decompressed: it is damaged");
    result += block;
    from += size;
  }
  return result;
#else
  require(false, "has compressed data ('" + name + "'), and this program was built without zlib");
  return "";
#endif
}

template <class Number>
std::vector<double> VtkXml::numbers(std::string const& data) const
{
  std::vector<double> values;
  for (std::size_t i = 0; i + sizeof(Number) <= data.size(); i += sizeof(Number)) {
    values.push_back(static_cast<double>(fromBytes<Number>(&data[i], order_)));
  }
  return values;
}

std::vector<double> VtkXml::fromBinary(std::string const& data, std::string const& type,
                                       std::string const& name) const
{
  using Reader = std::vector<double> (VtkXml::*)(std::string const&) const;
  static const std::map<std::string, Reader> readers = {
    {"Int8", &VtkXml::numbers<std::int8_t>},   {"UInt8", &VtkXml::numbers<std::uint8_t>},
    {"Int16", &VtkXml::numbers<std::int16_t>}, {"UInt16", &VtkXml::numbers<std::uint16_t>},
    {"Int32", &VtkXml::numbers<std::int32_t>}, {"UInt32", &VtkXml::numbers<std::uint32_t>},
    {"Int64", &VtkXml::numbers<std::int64_t>}, {"UInt64", &VtkXml::numbers<std::uint64_t>},
    {"Float32", &VtkXml::numbers<float>},      {"Float64", &VtkXml::numbers<double>}};
  const auto found = readers.find(type);
  require(found != readers.end(),
          "has array '" + name + "' of type '" + type + "', which cannot be read");
  return (this->*found->second)(data);
}
} // namespace asperity::geometry
