#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "meshing/CellSize.hpp"

#include "mesh/GlobalMesh.hpp"

#include <functional>
#include <string>

namespace asperity::geometry
{
// Divides curves, patches and the volume between them into cells with Gmsh: the surfaces keep their
// names, and the mesh is not yet split along the faults. `reportProgress` gets a line for each
// step, and every ten seconds an estimate of the progress, from the expected number of cells.
//
// InputError, with Gmsh's reason, if Gmsh cannot do it, or a patch is closed or has a handle.
GlobalMesh<3> fillVolume(Complex const& complex, Model const& model, CellSize const& size,
                         double expected_cells,
                         std::function<void(std::string const&)> const& reportProgress);
} // namespace asperity::geometry
