#pragma once

#include "mesh/GlobalMesh.hpp"

#include <string>

// A mesh of Gmsh, in any of its .msh formats or made from a geometry (.geo). Only one object may
// exist at a time, because Gmsh's library has global data.
class GmshFile
{
public:
  // `settings` are NAME=VALUE each, for the constants of a geometry (GmshGeometry.hpp). InputError
  // if there is no such file, Gmsh cannot read or mesh it, or a setting is wrong.
  explicit GmshFile(std::string const& file_name, std::vector<std::string> const& settings = {});
  ~GmshFile();
  GmshFile(GmshFile const&) = delete;
  GmshFile& operator=(GmshFile const&) = delete;

  // 3 if there are cells with a volume, or else 2.
  int dimension() const;

  // Physical groups of cells become regions, those of facets boundaries, or faults if they lie
  // inside the body, by their names; vertices keep the order of Gmsh's tags, cells and facets are
  // oriented. InputError unless the mesh consists of linear simplices, each in one named group, in
  // the plane z = 0 if it is two-dimensional.
  template <int Dim>
  asperity::GlobalMesh<Dim> mesh() const;

private:
  std::string where_;
};
