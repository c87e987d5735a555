#include "io/checkpoint/ArchiveBytes.hpp"

#include "base/Errors.hpp"

#include <cstring>
#include <utility>

namespace asperity::io::detail
{
namespace
{
class Writer
{
public:
  void number(std::int64_t value) { raw(&value, sizeof value); }

  template <class Sequence>
  void sequence(Sequence const& values)
  {
    number(static_cast<std::int64_t>(values.size()));
    raw(values.data(), values.size() * sizeof(typename Sequence::value_type));
  }

  void value(std::int64_t value) { number(value); }
  void value(double value) { raw(&value, sizeof value); }
  template <class Sequence>
  void value(Sequence const& values)
  {
    sequence(values);
  }

  std::vector<char> bytes;

private:
  void raw(void const* data, std::size_t size)
  {
    char const* begin = static_cast<char const*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
  }
};

class Reader
{
public:
  explicit Reader(std::vector<char> const& bytes) : bytes_(bytes) {}

  bool atEnd() const { return position_ == bytes_.size(); }

  void value(std::int64_t& value) { raw(&value, sizeof value); }
  void value(double& value) { raw(&value, sizeof value); }
  template <class Sequence>
  void value(Sequence& values)
  {
    std::int64_t size = 0;
    value(size);
    values.resize(size);
    raw(values.data(), values.size() * sizeof(typename Sequence::value_type));
  }

private:
  void raw(void* data, std::size_t size)
  {
    ASPERITY_ASSERT(size <= bytes_.size() - position_);
    if (size > 0) {
      std::memcpy(data, bytes_.data() + position_, size);
    }
    position_ += size;
  }

  std::vector<char> const& bytes_;
  std::size_t position_ = 0;
};

// The alternative `index` of the variant, read.
template <std::size_t... I>
Archive::Value readValue(Reader& reader, std::int64_t index, std::index_sequence<I...>)
{
  Archive::Value value;
  const auto read = [&](auto alternative) {
    reader.value(alternative);
    value = std::move(alternative);
  };
  ((index == static_cast<std::int64_t>(I) ? read(std::variant_alternative_t<I, Archive::Value>())
                                          : void()),
   ...);
  return value;
}
} // namespace

std::vector<char> toBytes(Archive const& archive)
{
  Writer writer;
  for (auto const& entry : archive.values()) {
    writer.sequence(entry.first);
    writer.number(static_cast<std::int64_t>(entry.second.index()));
    std::visit([&](auto const& value) { writer.value(value); }, entry.second);
  }
  return writer.bytes;
}

Archive fromBytes(std::vector<char> const& bytes)
{
  Archive archive;
  Reader reader(bytes);
  while (!reader.atEnd()) {
    std::string path;
    std::int64_t index = 0;
    reader.value(path);
    reader.value(index);
    const auto value =
      readValue(reader, index, std::make_index_sequence<std::variant_size_v<Archive::Value>>());
    std::visit([&](auto const& held) { archive.set(path, held); }, value);
  }
  return archive;
}
} // namespace asperity::io::detail
