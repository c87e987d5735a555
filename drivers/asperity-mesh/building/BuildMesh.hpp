#pragma once

#include "arrangement/Arranged.hpp"
#include "building/BuildParameters.hpp"
#include "meshing/CellSize.hpp"

#include "mesh/GlobalMesh.hpp"

#include <functional>
#include <string>

namespace asperity::geometry
{
Arranged arrangeSurfaces(BuildSettings const& settings);

// The size of cells in the body: at faults, and where curves come near to each other.
CellSize sizeOfCells(Arranged const& arranged, BuildSettings const& settings);

// The mesh before it is split along its faults, which mesh::checkMesh accepts. InputError as of
// fillVolume.
GlobalMesh<3> meshArranged(Arranged const& arranged, BuildSettings const& settings,
                           CellSize const& size,
                           std::function<void(std::string const&)> const& reportProgress);
} // namespace asperity::geometry
