#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

// What the options of convert say about names. Numbers are those of the file, as of
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

// A physical group of Gmsh.
struct Group
{
  std::string name;
  std::vector<int> entities;
};

// The groups of the model that Gmsh's library has open, those of cells and those of facets. A group
// is called as the options say, or by its own name, or else region_N or boundary_N.
struct PhysicalGroups
{
  std::vector<Group> regions, boundaries; // boundaries without those to be left out
  std::vector<std::string> remarks;       // on the names that were made here, and from where
  std::vector<std::string> warnings;
};

// InputError, which starts with `where`, if there are no groups, an entity of cells is in two
// regions, a name cannot be that of a boundary or is that of two groups without intention, or a
// group to be left out is not there. It needs no mesh: this can be known before it is made.
PhysicalGroups physicalGroups(int dimension, GroupNames const& names, std::string const& where);
