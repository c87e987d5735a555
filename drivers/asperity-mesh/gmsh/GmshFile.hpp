#pragma once

#include "assembly/ForeignMesh.hpp"
#include "assembly/GroupNames.hpp"
#include "gmsh/GmshGroups.hpp"
#include "gmsh/GmshSession.hpp"

#include "mesh/GlobalMesh.hpp"

#include <string>

namespace asperity::geometry
{
// A mesh of Gmsh in any of its .msh formats. Only one object may exist at a time.
class GmshFile
{
public:
  // `where` names the file in messages. A mesh that Gmsh has partitioned is put together.
  // InputError, which starts with `where`, if there is no such file, Gmsh cannot read it, its
  // groups are wrong (GmshGroups.hpp), or it lacks parts.
  GmshFile(std::string const& file_name, std::string where, GroupNames const& names = {});

  // 3 if there are cells with a volume, or else 2.
  int dimension() const;
  PhysicalGroups const& groups() const { return groups_; }

  // Physical groups of cells become regions, those of facets boundaries, or faults if they lie
  // inside the body (assemble); vertices keep the order of Gmsh's tags. InputError unless each cell
  // is in a group.
  template <int Dim>
  GlobalMesh<Dim> mesh(AssemblyOptions const& options = {}) const;

private:
  std::string where_;
  GmshSession session_;
  PhysicalGroups groups_;
};
} // namespace asperity::geometry
