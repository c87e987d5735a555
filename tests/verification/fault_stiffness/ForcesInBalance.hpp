#pragma once

#include "fem/BodyMatrices.hpp"
#include "tnnmg/direct/EigenMatrix.hpp"
#include "unit/fem/Constrained.hpp"
#include "verification/fault_stiffness/ForcesOfGiven.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace asperity::verification
{
struct Rock
{
  double shear_modulus; // Pa
  double poissons_ratio;
};

// Whether the displacement of a component is given, and which it is [m].
struct Motion
{
  bool is_given;
  double displacement;
};

// The nodal forces, with `components` for each vertex of the mesh, that hold a body with what is
// given of its displacement; the rest of it is in balance.
template <int Dim>
Eigen::VectorXd
forcesInBalance(GlobalMesh<Dim> const& mesh, int components, Rock const& rock,
                std::function<Motion(Point<Dim> const&, int component)> const& motion)
{
  const fem::test::Constrained<Dim> body(mesh, {}, components);
  EXPECT_TRUE(body.mesh.vertices == mesh.vertices) << "vertices were renumbered";
  const double bulk_modulus =
    2 * rock.shear_modulus * (1 + rock.poissons_ratio) / (3 * (1 - 2 * rock.poissons_ratio));
  const std::vector<fem::Material> materials(body.mesh.cells.size(),
                                             {1, bulk_modulus, rock.shear_modulus, 0, 0});
  auto const matrices =
    fem::assembleBody<Dim>(body.mesh, body.dofs, body.constraints.frames(), materials);
  auto const K = tnnmg::detail::toEigen(*matrices.stiffness, tnnmg::detail::StoredZeros::keep);
  std::vector<bool> is_given(K.rows());
  Eigen::VectorXd u = Eigen::VectorXd::Zero(K.rows());
  for (int dof = 0; dof < K.rows(); ++dof) {
    auto const given = motion(body.mesh.vertices[dof / components], dof % components);
    is_given[dof] = given.is_given;
    u[dof] = given.is_given ? given.displacement : 0;
  }
  return forcesOfGiven(K, is_given, u);
}
} // namespace asperity::verification
