#pragma once

#include "Arguments.hpp"

#include "mesh/GlobalMesh.hpp"

// Functions that all commands that make meshes share, in 2D and 3D.

// Bisects a mesh of bricks with these sides [m] to --cell-size, a formula in the coordinates, if it
// is given: as `Mesh / Cell Size` of a deck does. InputError if the text is not a formula, depends
// on t or is not positive somewhere.
template <int Dim>
asperity::GlobalMesh<Dim> graded(asperity::GlobalMesh<Dim> const& mesh,
                                 asperity::Point<Dim> const& brick, Arguments const& arguments);

// The mesh with the faults of --fault "NAME=CONDITION", formulas in the coordinates that hold where
// they are not zero (mesh/faults/Faults.hpp); it is not split. InputError if it could not be.
template <int Dim>
asperity::GlobalMesh<Dim> withFaults(asperity::GlobalMesh<Dim> mesh, Arguments const& arguments);

// Writes the file and prints how large the mesh is.
template <int Dim>
void writeAndReport(asperity::GlobalMesh<Dim> const& mesh, std::string const& file_name);
