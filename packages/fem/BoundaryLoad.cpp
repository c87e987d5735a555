#include "fem/BoundaryLoad.hpp"

#include "base/parallel/Agreement.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <Tpetra_Vector.hpp>

#include <cmath>

namespace asperity::fem
{
namespace
{
// Barycentric coordinates of points of equal weight on a facet: Gauss' two on a segment (degree 3),
// three on a triangle (degree 2).
template <int Dim>
std::array<std::array<double, Dim>, Dim> quadraturePoints()
{
  if constexpr (Dim == 2) {
    const double near = (1 + 1 / std::sqrt(3.)) / 2;
    return {{{near, 1 - near}, {1 - near, near}}};
  } else {
    return {{{2. / 3, 1. / 6, 1. / 6}, {1. / 6, 2. / 3, 1. / 6}, {1. / 6, 1. / 6, 2. / 3}}};
  }
}

template <int Dim>
std::array<double, 3> padded(Point<Dim> const& x)
{
  std::array<double, 3> result{};
  std::copy(x.begin(), x.end(), result.begin());
  return result;
}
} // namespace

template <int Dim>
BoundaryLoad::BoundaryLoad(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                           std::vector<BoundaryTraction> const& tractions)
{
  auto const quadrature = quadraturePoints<Dim>();
  for (auto const& traction : tractions) {
    boundaryMeasure(mesh, traction.boundary, *dofs.communicator()); // refuses one without facets
    auto& points = traction.depends_on_time ? varying_ : steady_;
    for (auto const& facet : mesh::boundaryFacets(mesh, traction.boundary)) {
      auto const corners = mesh::corners(mesh, facet);
      const double weight = mesh::facetMeasure(corners) / quadrature.size();
      auto const normal = mesh::areaNormal(corners);
      const double size = std::sqrt(mesh::dot<Dim>(normal, normal));
      for (auto const& shape : quadrature) {
        Point point{{}, padded<Dim>(normal), traction.value, {}};
        for (int k = 0; k < Dim; ++k) {
          for (int d = 0; d < Dim; ++d) {
            point.x[d] += shape[k] * corners[k][d];
          }
          for (auto const& [node, factor] : frames.terms(facet[k])) {
            for (int r = 0; node < mesh.num_owned && r < dofs.components(); ++r) {
              Share share{dofs.dof(node, r), {}};
              for (int c = 0; c < dofs.components(); ++c) {
                share.factors[c] = weight * shape[k] * factor * frames.entry(node, r, c);
              }
              point.shares.push_back(share);
            }
          }
        }
        for (double& component : point.n) {
          component /= size;
        }
        if (!point.shares.empty()) {
          points.push_back(std::move(point));
        }
      }
    }
  }
  onEveryRank(*dofs.communicator(), [&] {
    for (auto const* points : {&steady_, &varying_}) {
      for (auto const& point : *points) {
        point.value(point.x, point.n, 0);
      }
    }
  });
}

void BoundaryLoad::add(std::vector<Point> const& points, double t, Vector& load)
{
  auto const values = load.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (auto const& point : points) {
    auto const traction = point.value(point.x, point.n, t);
    for (auto const& [dof, factors] : point.shares) {
      for (int c = 0; c < 3; ++c) {
        values(dof, 0) += factors[c] * traction[c];
      }
    }
  }
}

void BoundaryLoad::addSteady(Vector& load) const
{
  if (!steady_.empty()) {
    add(steady_, 0, load);
  }
}

void BoundaryLoad::addVarying(double t, Vector& load) const
{
  if (!varying_.empty()) {
    add(varying_, t, load);
  }
}

template BoundaryLoad::BoundaryLoad(Mesh<2> const&, DofMap const&, NodalFrames const&,
                                    std::vector<BoundaryTraction> const&);
template BoundaryLoad::BoundaryLoad(Mesh<3> const&, DofMap const&, NodalFrames const&,
                                    std::vector<BoundaryTraction> const&);
} // namespace asperity::fem
