#include "RefinementSamples.hpp"

#include "fem/BodyMatrices.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

using namespace asperity;
using namespace asperity::refinement::test;

namespace
{
// u = G x; antisymmetric, volumetric and shear parts.
constexpr double gradient[3][3] = {{0.3, -0.7, 0.2}, {0.5, 0.1, -0.4}, {-0.6, 0.8, -0.2}};
constexpr double bulk = 5.0, shear = 3.0;

// 1/2 strain : C : strain, per volume; plane strain in the plane.
template <int Dim>
double energyDensity()
{
  double trace = 0.0, squares = 0.0;
  for (int i = 0; i < Dim; ++i) {
    trace += gradient[i][i];
    for (int j = 0; j < Dim; ++j) {
      const double strain = 0.5 * (gradient[i][j] + gradient[j][i]);
      squares += strain * strain;
    }
  }
  return 0.5 * (bulk - 2.0 / 3.0 * shear) * trace * trace + shear * squares;
}

template <class AnyPoint>
bool isInside(AnyPoint const& x)
{
  return std::all_of(x.begin(), x.end(), [](double c) { return c > 1e-9 && c < 1.0 - 1e-9; });
}

// A linear displacement has the energy of a constant strain, and no forces inside.
template <int Dim>
void expectExactForLinearFields(GlobalMesh<Dim> const& coarse)
{
  const auto mesh = refined(coarse, 2);
  const auto comm = rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  const fem::DofMap dofs(mesh.global_ids, mesh.num_owned, Dim, comm);
  const fem::NodalFrames frames(dofs.numLocalNodes(), Dim);
  const std::vector<fem::Material> materials(mesh.cells.size(), {1.0, bulk, shear, 0.0, 0.0});
  const auto body = fem::assembleBody<Dim>(mesh, dofs, frames, materials);
  Vector u(dofs.owned()), forces(dofs.owned());
  {
    const auto values = u.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int v = 0; v < mesh.num_owned; ++v) {
      for (int i = 0; i < Dim; ++i) {
        double sum = 0.0;
        for (int j = 0; j < Dim; ++j) {
          sum += gradient[i][j] * mesh.vertices[v][j];
        }
        values(dofs.dof(v, i), 0) = sum;
      }
    }
  }
  body.stiffness->apply(u, forces);
  EXPECT_NEAR(0.5 * u.dot(forces), energyDensity<Dim>(), 1e-12); // the volume is 1
  const auto values = forces.getLocalViewHost(Tpetra::Access::ReadOnly);
  double largest = 0.0;
  int num_inside = 0;
  for (int v = 0; v < mesh.num_owned; ++v) {
    num_inside += isInside(mesh.vertices[v]) ? 1 : 0;
    for (int i = 0; i < Dim && isInside(mesh.vertices[v]); ++i) {
      largest = std::max(largest, std::abs(values(dofs.dof(v, i), 0)));
    }
  }
  EXPECT_GT(sumOverRanks(num_inside, world()), 40);
  EXPECT_LT(largest, 1e-13);
}
} // namespace

TEST(RefinedBody, IsExactForLinearFieldsInThePlane)
{
  auto mesh = rectangleMesh({1, 1, 3, 3, {}});
  mesh.vertices[5] = {0.4, 0.3};
  expectExactForLinearFields(mesh);
}

TEST(RefinedBody, IsExactForLinearFieldsInSpace) { expectExactForLinearFields(crookedBox(2, 0.3)); }
