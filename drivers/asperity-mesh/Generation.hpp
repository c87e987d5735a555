#pragma once

#include "Arguments.hpp"

#include "mesh/GlobalMesh.hpp"

// What the commands that make meshes have in common; in 2D and 3D.

// The mesh, bisected to --cell-size if that is given: a formula in the coordinates. InputError if
// it is none, depends on t or is not positive somewhere.
template <int Dim>
asperity::GlobalMesh<Dim> graded(asperity::GlobalMesh<Dim> const& mesh, Arguments const& arguments);

// Writes the file and says how large the mesh is.
template <int Dim>
void writeAndReport(asperity::GlobalMesh<Dim> const& mesh, std::string const& file_name);
