#include "base/Archive.hpp"

#include "base/Errors.hpp"

#include <array>

namespace asperity
{
void Archive::insert(std::string const& path, Archive part)
{
  for (auto& entry : part.values_) {
    values_[path + "/" + entry.first] = std::move(entry.second);
  }
  for (auto& entry : part.nodes_) {
    nodes_[path + "/" + entry.first] = std::move(entry.second);
  }
}

std::string const& Archive::nodesOf(std::string const& path) const
{
  static const std::string none;
  const auto found = nodes_.find(path);
  return found == nodes_.end() ? none : found->second;
}

Archive Archive::child(std::string const& path) const
{
  const std::string prefix = path + "/";
  Archive part;
  for (auto entry = values_.lower_bound(prefix);
       entry != values_.end() && entry->first.compare(0, prefix.size(), prefix) == 0; ++entry) {
    part.values_[entry->first.substr(prefix.size())] = entry->second;
  }
  return part;
}

Archive::Value const& Archive::at(std::string const& path) const
{
  const auto found = values_.find(path);
  ASPERITY_REQUIRE(found != values_.end(),
                   "The checkpoint has no value '"
                     << path << "'. It was written by another version or for another deck.");
  return found->second;
}

void Archive::throwWrongType(std::string const& path, Value const& value)
{
  static constexpr std::array<char const*, std::variant_size_v<Value>> names = {
    "an integer", "a number", "a text", "a list of numbers", "a list of integers"};
  throw InputError("The checkpoint holds " + std::string(names[value.index()]) + " as '" + path +
                   "', and this version reads another type. It was written by another version.");
}
} // namespace asperity
