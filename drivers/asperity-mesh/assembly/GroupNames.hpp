#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace asperity::geometry
{
// The options of convert that give names.
constexpr char const* boundaries_option = "--names";
constexpr char const* regions_option = "--region-names";

// What they say about names. Numbers are those of the file, as of
// Gmsh's physical groups.
struct GivenNames
{
  std::map<int, std::string> by_number;
  std::map<std::string, std::string> by_name; // of the group in the file
};

struct GroupNames
{
  // `boundaries` and `regions` are lists "1=free, 3=fault, old=new", `without` "a, b", each as
  // often as the option was given. InputError for what is not of this form or is given twice.
  GroupNames(std::vector<std::string> const& boundaries, std::vector<std::string> const& regions,
             std::vector<std::string> const& without);
  GroupNames() = default;

  GivenNames boundaries, regions;
  std::set<std::string> without; // boundaries and faults
};

// InputError unless all names to be left out are those of boundaries, with the nearest name.
void requireBoundaries(std::set<std::string> const& without,
                       std::vector<std::string> const& boundaries,
                       std::vector<std::string> const& regions, std::string const& where);

// InputError unless a group of this name, which `option` changes, is among `names`.
void requireKnownName(std::string const& option, std::string const& name,
                      std::vector<std::string> const& names, std::string const& where);
} // namespace asperity::geometry
