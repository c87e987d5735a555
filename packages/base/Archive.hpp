#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace asperity
{
// The values that a run needs to go on exactly where it stopped, by path, for example
// "state/velocity". A path may hold an integer, a double, a string or a vector of the first two. A
// checkpoint has the values of rank 0, and the values at nodes of all ranks.
class Archive
{
public:
  using Value =
    std::variant<std::int64_t, double, std::string, std::vector<double>, std::vector<std::int64_t>>;

  // Sets the value at the path or replaces it. Every integral type is stored as int64.
  template <class T>
  void set(std::string const& path, T const& value)
  {
    if constexpr (std::is_integral_v<T>) {
      values_[path] = static_cast<std::int64_t>(value);
    } else {
      values_[path] = Value(value);
    }
  }

  // A list with the same number of values for each node of a set, in the order of this rank's
  // nodes: (num_nodes, any number), or empty on all ranks. All ranks set the same paths. A restart,
  // on whatever ranks, gives each rank the values at its nodes; NodeSets has the nodes of the set.
  template <class T>
  void setAtNodes(std::string const& path, std::vector<T> const& values, std::string const& nodes)
  {
    set(path, values);
    nodes_[path] = nodes;
  }
  // The set of nodes that the value belongs to, or "".
  std::string const& nodesOf(std::string const& path) const;

  // archive.get<double>("time"); InputError if the path is missing or holds another type.
  template <class T>
  T const& get(std::string const& path) const
  {
    Value const& value = at(path);
    if (T const* found = std::get_if<T>(&value)) {
      return *found;
    }
    throwWrongType(path, value);
  }
  std::int64_t getInteger(std::string const& path) const { return get<std::int64_t>(path); }
  double getDouble(std::string const& path) const { return get<double>(path); }

  bool has(std::string const& path) const { return values_.count(path) > 0; }

  // insert() adds all values of `part`, or what it saves, under `path`; child() returns the values
  // under `path`.
  void insert(std::string const& path, Archive part);
  template <class Part, class = std::enable_if_t<!std::is_same_v<Part, Archive>>>
  void insert(std::string const& path, Part const& part)
  {
    Archive values;
    part.save(values);
    insert(path, std::move(values));
  }
  Archive child(std::string const& path) const;

  std::map<std::string, Value> const& values() const { return values_; }

private:
  Value const& at(std::string const& path) const;
  [[noreturn]] static void throwWrongType(std::string const& path, Value const& value);

  std::map<std::string, Value> values_;
  std::map<std::string, std::string> nodes_; // by path, where it is not ""
};

// A sum over the steps of a run, a struct whose members() have names and pointers to members.
template <class Sum>
void saveMembers(Archive& archive, std::string const& path, Sum const& sum)
{
  for (auto const& [name, member] : Sum::members()) {
    archive.set(path + "/" + name, sum.*member);
  }
}
template <class Sum>
Sum loadMembers(Archive const& archive, std::string const& path)
{
  Sum sum;
  for (auto const& [name, member] : Sum::members()) {
    sum.*member = archive.get<std::decay_t<decltype(sum.*member)>>(path + "/" + name);
  }
  return sum;
}

// The nodes of this rank by the name of their set: numbers that do not depend on the ranks, each
// of which one rank has.
using NodeSets = std::map<std::string, std::vector<std::int64_t>>;
} // namespace asperity
