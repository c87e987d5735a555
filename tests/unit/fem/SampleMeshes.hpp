#pragma once

#include "base/Errors.hpp"
#include "fem/DofMap.hpp"
#include "mesh/Partition.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

// Small meshes for tests, and what tests need around them.
namespace asperity::fem::testing
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

// The unit cube in six tetrahedra for each of cells^3 cubes; boundaries `bottom` (z = 0), `top`,
// and `sides`.
GlobalMesh<3> uniformCube(int cells);

// Moves the vertices that are on no boundary about, by less than `amplitude`.
template <int Dim>
void distort(GlobalMesh<Dim>& mesh, double amplitude);

// Turned about the origin, counterclockwise.
void rotate(GlobalMesh<2>& mesh, double angle);

// Expects an InputError whose message contains all these pieces.
void expectInputError(std::function<void()> const& call, std::vector<std::string> const& pieces);
} // namespace asperity::fem::testing
