#pragma once

#include "surfaces/kinds/SurfaceKinds.hpp"

namespace asperity::geometry
{
// A kind of surface. To add one: a file with its entries and how the surface is made, a declaration
// here, and a line in the table of SurfaceKinds.cpp.
struct SurfaceKind
{
  std::string name;                 // the word of `Type`
  std::vector<std::string> sources; // entries of which one is given
  Teuchos::RCP<const ParameterList> (*entries)();
  TriangleSurface (*make)(ParameterList const& list, std::string const& path,
                          SurfaceContext const& context);
};

SurfaceKind surfaceFileKind();
SurfaceKind traceKind();
SurfaceKind contoursKind();
SurfaceKind gridKind();
SurfaceKind planeKind();
} // namespace asperity::geometry
