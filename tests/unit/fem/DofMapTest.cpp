#include "fem/dofs/DofMap.hpp"

#include "unit/fem/SampleMeshes.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

namespace asperity::fem
{
using namespace fem::test;

TEST(DofMap, NumbersTheComponentsOfAVertexOneAfterTheOther)
{
  auto const mesh = mesh::distribute(uniformRectangle(5, 4, 1, 1), *worldCommunicator());
  for (int components : {1, 2}) {
    auto const dofs = makeDofs(mesh, components, worldCommunicator());
    EXPECT_EQ(dofs.owned()->getGlobalNumElements(), 30u * components);
    EXPECT_EQ(dofs.numOwnedNodes(), mesh.num_owned);
    EXPECT_EQ(dofs.numLocalNodes(), static_cast<int>(mesh.vertices.size()));
    for (int node = 0; node < dofs.numLocalNodes(); ++node) {
      for (int c = 0; c < components; ++c) {
        const GlobalOrdinal expected = mesh.global_ids[node] * components + c;
        EXPECT_EQ(dofs.overlap()->getGlobalElement(dofs.dof(node, c)), expected);
        if (node < mesh.num_owned) {
          EXPECT_EQ(dofs.owned()->getGlobalElement(dofs.dof(node, c)), expected);
        }
      }
    }
  }
}

TEST(DofMap, ImportsTheValuesOfGhostsFromTheirOwners)
{
  auto const mesh = mesh::distribute(uniformRectangle(5, 4, 1, 1), *worldCommunicator());
  auto const dofs = makeDofs(mesh, 2, worldCommunicator());
  Vector owned(dofs.owned()), local(dofs.overlap());
  {
    auto const values = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int dof = 0; dof < 2 * dofs.numOwnedNodes(); ++dof) {
      values(dof, 0) = static_cast<double>(dofs.owned()->getGlobalElement(dof));
    }
  }
  dofs.shareWithGhosts(owned, local);
  auto const values = local.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int dof = 0; dof < 2 * dofs.numLocalNodes(); ++dof) {
    EXPECT_EQ(values(dof, 0), static_cast<double>(dofs.overlap()->getGlobalElement(dof)));
  }
  if (worldCommunicator()->getSize() > 1) {
    EXPECT_GT(dofs.numLocalNodes(), dofs.numOwnedNodes());
  }
}
} // namespace asperity::fem
