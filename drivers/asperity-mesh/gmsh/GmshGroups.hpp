#pragma once

#include "assembly/GroupNames.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
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
} // namespace asperity::geometry
