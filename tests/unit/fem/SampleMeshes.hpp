#pragma once

#include "fem/dofs/DofMap.hpp"
#include "mesh/parallel/Partition.hpp"
#include "unit/base/Refusal.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

// Small meshes for tests, and what tests need around them.
namespace asperity::fem::test
{
inline RCP<const Communicator> worldCommunicator()
{
  return rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
}

inline RCP<const Communicator> selfCommunicator()
{
  return rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF));
}

template <int Dim>
DofMap makeDofs(Mesh<Dim> const& mesh, int components, RCP<const Communicator> const& communicator)
{
  return DofMap(mesh.global_ids, mesh.num_owned, components, communicator);
}

// In [-1, 1), the same on every rank and in every run.
double pseudorandom(GlobalOrdinal index, int sequence);

// [0, width] x [0, height] in right triangles whose diagonals are all parallel, so that the stencil
// of the matrices is the same everywhere inside. Boundaries `bottom`, `right`, `top`, `left`.
GlobalMesh<2> uniformRectangle(int cells_x, int cells_y, double width, double height);

// A box with a corner at the origin, in six tetrahedra for each of its equal blocks; boundaries
// `left` and `right` (x), `bottom` and `top` (y), `front` and `back` (z).
GlobalMesh<3> uniformBox(std::array<int, 3> const& cells, Point<3> const& size);

// The unit cube, likewise; boundaries `bottom` (z = 0), `top`, and `sides`.
GlobalMesh<3> uniformCube(int cells);

// Moves the vertices that are on no boundary about, by less than `amplitude`.
template <int Dim>
void distort(GlobalMesh<Dim>& mesh, double amplitude);

// Turned about the origin, counterclockwise.
void rotate(GlobalMesh<2>& mesh, double angle);

// A rotation of space, by rows.
using Rotation = std::array<Point<3>, 3>;
Rotation rotationAbout(Point<3> axis, double angle);
Point<3> rotated(Rotation const& rotation, Point<3> const& x);
Point<3> rotatedBack(Rotation const& rotation, Point<3> const& x);
void rotate(GlobalMesh<3>& mesh, Rotation const& rotation);
} // namespace asperity::fem::test
