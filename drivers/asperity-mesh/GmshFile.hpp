#pragma once

#include "GmshGroups.hpp"
#include "GmshSession.hpp"

#include "mesh/GlobalMesh.hpp"

#include <string>

// A mesh of Gmsh in any of its .msh formats. Only one object may exist at a time.
class GmshFile
{
public:
  // `where` names the file in messages. `scale` multiplies coordinates. A mesh that Gmsh has
  // partitioned is put together. InputError, which starts with `where`, if there is no such file,
  // Gmsh cannot read it, its groups are wrong (GmshGroups.hpp), or it lacks parts.
  GmshFile(std::string const& file_name, std::string where, GroupNames const& names = {},
           double scale = 1);

  // 3 if there are cells with a volume, or else 2.
  int dimension() const;
  PhysicalGroups const& groups() const { return groups_; }

  // Physical groups of cells become regions, those of facets boundaries, or faults if they lie
  // inside the body; vertices keep the order of Gmsh's tags, cells and facets are oriented.
  // InputError unless the mesh consists of linear simplices, each cell in a group, in the plane
  // z = 0 if it is two-dimensional.
  template <int Dim>
  asperity::GlobalMesh<Dim> mesh() const;

private:
  std::string where_;
  double scale_;
  GmshSession session_;
  PhysicalGroups groups_;
};
