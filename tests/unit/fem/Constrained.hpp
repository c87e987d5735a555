#pragma once

#include "base/parallel/Reductions.hpp"
#include "fem/constraints/Constraints.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Eigen/Dense>
#include <Tpetra_Vector.hpp>

// A small mesh with constraints, for their tests.
namespace asperity::fem::test
{
using Condition = VelocityCondition<2>;

// 6 x 4 cells; the vertices of the bottom are 0 ... 6, the lower left corner is 0.
inline constexpr int lower_right = 6;

inline GlobalMesh<2> rectangle(double angle = 0)
{
  auto mesh = uniformRectangle(6, 4, 3, 2);
  rotate(mesh, angle);
  return mesh;
}

template <int Dim>
struct Constrained
{
  Constrained(GlobalMesh<Dim> const& whole, std::vector<VelocityCondition<Dim>> const& conditions,
              int components = Dim, std::vector<double> const& sample_times = {0, 1})
      : mesh(mesh::distribute(whole, *worldCommunicator()))
      , dofs(makeDofs(mesh, components, worldCommunicator()))
      , constraints(mesh, dofs, conditions, sample_times)
  {
  }

  using Value = Eigen::Matrix<double, Dim, 1>;

  Value row(int node, int r) const
  {
    Value result;
    for (int c = 0; c < Dim; ++c) {
      result[c] = constraints.frames().entry(node, r, c);
    }
    return result;
  }

  bool fixed(int node, int component) const
  {
    return constraints.held()[dofs.dof(node, component)];
  }

  // The prescribed velocity of an owned node along the axes.
  Value velocity(int node, double t) const
  {
    Vector v(dofs.owned());
    v.putScalar(77);
    constraints.prescribedVelocity(t, v);
    auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
    Value local, along_axes;
    for (int c = 0; c < Dim; ++c) {
      local[c] = values(dofs.dof(node, c), 0);
    }
    constraints.frames().fromFrame(node, local.data(), along_axes.data());
    return along_axes;
  }

  // The local number of an owned vertex, -1 if it is another rank's.
  int owned(GlobalOrdinal id) const
  {
    for (int node = 0; node < mesh.num_owned; ++node) {
      if (mesh.global_ids[node] == id) {
        return node;
      }
    }
    return -1;
  }

  Mesh<Dim> mesh;
  DofMap dofs;
  Constraints<Dim> constraints;
};

inline int sumOverRanks(int mine) { return asperity::sumOverRanks(mine, *worldCommunicator()); }

inline bool oneRank() { return worldCommunicator()->getSize() == 1; }
} // namespace asperity::fem::test
