#include "fem/NodalDamping.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/BoundaryCells.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::fem
{
namespace
{
// F_p (across n n^T + along (1 - n n^T)) F_q^T with the frames of two nodes. With one component it
// is `along`.
template <int Dim, int Components>
std::array<double, 9> dashpot(NodalFrames const& frames, int p, int q, Point<Dim> const& normal,
                              double across, double along)
{
  std::array<double, 9> block{};
  if constexpr (Components == 1) {
    block[0] = along;
  } else {
    std::array<double, Components> n_p{};
    std::array<double, Components> n_q{};
    frames.toFrame(p, normal.data(), n_p.data());
    frames.toFrame(q, normal.data(), n_q.data());
    for (int i = 0; i < Components; ++i) {
      for (int j = 0; j < Components; ++j) {
        double identity = p == q && i == j ? 1 : 0;
        for (int c = 0; c < Components && p != q; ++c) {
          identity += frames.entry(p, i, c) * frames.entry(q, j, c);
        }
        block[i * Components + j] = along * identity + (across - along) * n_p[i] * n_q[j];
      }
    }
  }
  return block;
}

void requireResistance(BoundaryResistance const& resistance, BoundaryResistance::Value const& value,
                       std::array<double, 3> const& x)
{
  for (const double number : {value.across, value.along}) {
    ASPERITY_REQUIRE(number >= 0 && std::isfinite(number),
                     "Asperity / Boundary Conditions: the boundary '"
                       << resistance.boundary << "' resists motion by " << number << " per metre"
                       << (resistance.against == BoundaryResistance::Against::velocity
                             ? " per second at ("
                             : " at (")
                       << x[0] << ", " << x[1] << ", " << x[2]
                       << ") m. It needs a finite number that is not negative.");
  }
}

template <int Dim, int Components>
NodalDampers blocksOf(Mesh<Dim> const& mesh, BoundaryResistance const& resistance,
                      NodalFrames const& frames, std::vector<Material> const& materials)
{
  auto const cells = cellsBeside(mesh, resistance.boundary);
  auto const& facets = mesh.boundaries.at(resistance.boundary);
  NodalDampers dampers;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    auto const corners = mesh::corners(mesh, facets[i]);
    auto const normal = mesh::facetNormal(corners);
    const double share = mesh::facetMeasure(corners) / Dim;
    for (int vertex : facets[i]) {
      std::array<double, 3> x{};
      std::copy_n(mesh.vertices[vertex].begin(), Dim, x.begin());
      auto const value = resistance.value(x, materials[cells[i]]);
      requireResistance(resistance, value, x);
      const double across = share * value.across;
      const double along = share * value.along;
      for (auto const& [p, factor_p] : frames.terms(vertex)) {
        for (auto const& [q, factor_q] : frames.terms(vertex)) {
          if (p < mesh.num_owned) {
            auto const block = dashpot<Dim, Components>(frames, p, q, normal, across, along);
            auto& sum = dampers[{p, q}];
            for (std::size_t k = 0; k < sum.size(); ++k) {
              sum[k] += factor_p * factor_q * block[k];
            }
          }
        }
      }
    }
  }
  return dampers;
}
} // namespace

template <int Dim>
NodalDampers resistanceOf(Mesh<Dim> const& mesh, BoundaryResistance const& resistance,
                          NodalFrames const& frames, std::vector<Material> const& materials)
{
  if constexpr (Dim == 2) {
    if (frames.components() == 1) {
      return blocksOf<2, 1>(mesh, resistance, frames, materials);
    }
  }
  return blocksOf<Dim, Dim>(mesh, resistance, frames, materials);
}

BoundaryResistance absorbingBoundary(std::string const& boundary)
{
  const auto impedance = [](std::array<double, 3> const&, Material const& beside) {
    return BoundaryResistance::Value{beside.compressionalImpedance(), beside.shearImpedance()};
  };
  return {boundary, BoundaryResistance::Against::velocity, impedance, true};
}

NodalDampers radiationDampers(FaultSurface const& fault, DofMap const& dofs,
                              std::vector<double> const& eta)
{
  const int components = dofs.components();
  NodalDampers dampers;
  for (int i = 0; i < fault.numNodes(); ++i) {
    const int node = fault.vertex(i);
    auto& block = dampers[{node, node}];
    for (int dof : fault[i].dofs) {
      const int row = dof - dofs.dof(node, 0);
      block[row * components + row] = fault[i].weight * eta[i] * fault.slipFactor();
    }
  }
  return dampers;
}

void addRadiationOfPlates(FaultSurface const& fault, std::vector<double> const& eta, Vector& load)
{
  auto const values = load.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int i = 0; i < fault.numNodes(); ++i) {
    for (int k = 0; k < fault.numTangents(); ++k) {
      values(fault[i].dofs[k], 0) -= fault[i].weight * eta[i] * fault.plateRate(i, k);
    }
  }
}

RCP<const CrsMatrix> withDampers(CrsMatrix const& viscosity, DofMap const& dofs,
                                 NodalDampers const& dampers)
{
  auto result = rcp(new CrsMatrix(viscosity.getCrsGraph()));
  const int components = dofs.components();
  {
    auto const local = result->getLocalMatrixHost();
    Kokkos::deep_copy(local.values, viscosity.getLocalMatrixHost().values);
    for (auto const& [nodes, block] : dampers) {
      for (int i = 0; i < components; ++i) {
        const int row = dofs.dof(nodes.first, i);
        for (auto entry = local.graph.row_map(row); entry < local.graph.row_map(row + 1); ++entry) {
          const int k = local.graph.entries(entry) - dofs.dof(nodes.second, 0);
          if (k >= 0 && k < components) {
            local.values(entry) += block[i * components + k];
          }
        }
      }
    }
  }
  result->fillComplete(viscosity.getDomainMap(), viscosity.getRangeMap());
  return result;
}

RCP<const CrsMatrix> zeroLike(CrsMatrix const& matrix)
{
  auto result = rcp(new CrsMatrix(matrix.getCrsGraph()));
  result->setAllToScalar(0);
  result->fillComplete(matrix.getDomainMap(), matrix.getRangeMap());
  return result;
}

RCP<const CrsMatrix> withoutZeros(RCP<const CrsMatrix> const& matrix)
{
  auto const local = matrix->getLocalMatrixHost();
  std::vector<std::size_t> in_row(local.numRows(), 0);
  const auto forEachEntry = [&](int row, auto const& work) {
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      if (local.values(k) != 0) {
        work(local.graph.entries(k), local.values(k));
      }
    }
  };
  double num_entries = 0;
  for (int row = 0; row < local.numRows(); ++row) {
    forEachEntry(row, [&](int, double) { ++in_row[row]; });
    num_entries += static_cast<double>(in_row[row]);
  }
  num_entries = sumOverRanks(num_entries, *matrix->getComm());
  if (num_entries > 0.5 * static_cast<double>(matrix->getGlobalNumEntries())) {
    return matrix;
  }
  auto result = rcp(new CrsMatrix(matrix->getRowMap(), matrix->getColMap(),
                                  Teuchos::ArrayView<const std::size_t>(in_row)));
  for (int row = 0; row < local.numRows(); ++row) {
    forEachEntry(
      row, [&](int column, double value) { result->insertLocalValues(row, 1, &value, &column); });
  }
  result->fillComplete(matrix->getDomainMap(), matrix->getRangeMap());
  return result;
}

template NodalDampers resistanceOf(Mesh<2> const&, BoundaryResistance const&, NodalFrames const&,
                                   std::vector<Material> const&);
template NodalDampers resistanceOf(Mesh<3> const&, BoundaryResistance const&, NodalFrames const&,
                                   std::vector<Material> const&);
} // namespace asperity::fem
