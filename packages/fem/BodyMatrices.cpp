#include "fem/BodyMatrices.hpp"

#include "base/Errors.hpp"
#include "base/program/WorkTimers.hpp"
#include "fem/Simplex.hpp"
#include "fem/detail/AssembleRows.hpp"
#include "fem/detail/PatchViews.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>

namespace asperity::fem
{
namespace
{
using Adjacency = std::vector<std::vector<int>>;

// Neighbours (itself included, ascending) of every owned node.
template <int Dim>
Adjacency neighbours(Mesh<Dim> const& mesh, NodalFrames const& frames,
                     VolumetricPatches const& patches)
{
  Adjacency adjacency(mesh.num_owned);
  std::vector<int> nodes;
  auto const note_nodes = [&](int cell) {
    for (int vertex : mesh.cells[cell]) {
      for (auto const& term : frames.terms(vertex)) {
        nodes.push_back(term.node);
      }
    }
  };
  auto const couple_nodes = [&] {
    for (int p : nodes) {
      if (p < mesh.num_owned) {
        adjacency[p].insert(adjacency[p].end(), nodes.begin(), nodes.end());
      }
    }
    nodes.clear();
  };
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    note_nodes(static_cast<int>(cell));
    couple_nodes();
  }
  for (auto const& patch : patches.patches) {
    std::for_each(patch.cells.begin(), patch.cells.end(), note_nodes);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    couple_nodes();
  }
  for (int p = 0; p < mesh.num_owned; ++p) {
    auto& row = adjacency[p];
    row.push_back(p);
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
  }
  return adjacency;
}

RCP<const CrsGraph> graphOf(Adjacency const& adjacency, DofMap const& dofs)
{
  const int components = dofs.components();
  using RowPointers = CrsGraph::local_graph_device_type::row_map_type::non_const_type;
  using Columns = CrsGraph::local_graph_device_type::entries_type::non_const_type;
  RowPointers pointers("asperity::fem::rows", adjacency.size() * components + 1);
  auto const host_pointers = Kokkos::create_mirror_view(pointers);
  std::size_t entries = 0;
  for (std::size_t node = 0; node < adjacency.size(); ++node) {
    for (int c = 0; c < components; ++c) {
      host_pointers(node * components + c) = entries;
      entries += adjacency[node].size() * components;
    }
  }
  host_pointers(adjacency.size() * components) = entries;
  Columns columns("asperity::fem::columns", entries);
  auto const host_columns = Kokkos::create_mirror_view(columns);
  std::size_t entry = 0;
  for (auto const& row : adjacency) {
    for (int c = 0; c < components; ++c) {
      for (int neighbour : row) {
        for (int k = 0; k < components; ++k) {
          host_columns(entry++) = dofs.dof(neighbour, k);
        }
      }
    }
  }
  Kokkos::deep_copy(pointers, host_pointers);
  Kokkos::deep_copy(columns, host_columns);
  auto graph = rcp(new CrsGraph(dofs.owned(), dofs.overlap(), pointers, columns));
  graph->expertStaticFillComplete(dofs.owned(), dofs.owned());
  return graph;
}

// M, C and K of materials without relaxation on a graph.
template <int Dim, int Components>
BodyMatrices assembleOnGraph(RCP<const CrsGraph> const& graph, Mesh<Dim> const& mesh,
                             DofMap const& dofs, NodalFrames const& frames,
                             std::vector<Material> const& materials,
                             VolumetricPatches const& patches)
{
  auto mass = rcp(new CrsMatrix(graph));
  auto viscosity = rcp(new CrsMatrix(graph));
  auto stiffness = rcp(new CrsMatrix(graph));
  Kokkos::parallel_for("asperity::fem::assembleRows", RangePolicy(0, mesh.num_owned),
                       detail::AssembleRows<Dim, Components>{
                         detail::makeCellViews(mesh, frames, patches.ownMaterials(materials)),
                         mass->getLocalMatrixDevice(), viscosity->getLocalMatrixDevice(),
                         stiffness->getLocalMatrixDevice()});
  if constexpr (Components == Dim) {
    if (!patches.empty()) {
      Kokkos::parallel_for("asperity::fem::addPatches", RangePolicy(0, mesh.num_owned),
                           detail::AddPatches<Dim>{detail::makePatchViews(mesh, frames, patches),
                                                   stiffness->getLocalMatrixDevice()});
    }
  }
  ExecutionSpace().fence();
  mass->fillComplete(dofs.owned(), dofs.owned());
  viscosity->fillComplete(dofs.owned(), dofs.owned());
  stiffness->fillComplete(dofs.owned(), dofs.owned());
  return {mass, viscosity, stiffness};
}

template <int Dim, int Components>
BodyMatrices assembleMatrices(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                              std::vector<Material> const& materials,
                              std::vector<MaxwellBranch> const& branches,
                              VolumetricPatches const& patches)
{
  ASPERITY_TIME_WORK("assembly");
  ASPERITY_ASSERT(dofs.components() == Components && materials.size() == mesh.cells.size());
  auto const graph = graphOf(neighbours(mesh, frames, patches), dofs);
  auto result = assembleOnGraph<Dim, Components>(graph, mesh, dofs, frames,
                                                 longTerm(materials, branches), patches);
  for (auto const& branch : branches) {
    auto const of_branch =
      assembleOnGraph<Dim, Components>(graph, mesh, dofs, frames, materialsOf(branch), {});
    result.branches.push_back({branch.time, of_branch.stiffness});
  }
  return result;
}
} // namespace

template <int Dim, int Components>
RCP<Vector> assembleGravity(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                            std::vector<Material> const& materials,
                            std::array<double, Components> const& acceleration)
{
  auto load = rcp(new Vector(dofs.owned()));
  auto values = load->getLocalViewHost(Tpetra::Access::OverwriteAll);
  Kokkos::deep_copy(values, 0.);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const double share =
      materials[cell].density * simplexOf(mesh, static_cast<int>(cell)).measure / (Dim + 1);
    for (int vertex : mesh.cells[cell]) {
      for (auto const& [p, factor] : frames.terms(vertex)) {
        if (p < mesh.num_owned) {
          std::array<double, Components> local{};
          frames.toFrame(p, acceleration.data(), local.data());
          for (int c = 0; c < Components; ++c) {
            values(dofs.dof(p, c), 0) += factor * share * local[c];
          }
        }
      }
    }
  }
  return load;
}

namespace
{
// result += factor matrix, whose graph is a part of that of the result. Columns are sorted in both.
void addEntries(CrsMatrix::local_matrix_device_type const& result, double factor,
                CrsMatrix::local_matrix_device_type const& matrix)
{
  Kokkos::parallel_for(
    "asperity::fem::addEntries", RangePolicy(0, matrix.numRows()), KOKKOS_LAMBDA(int row) {
      auto to = result.graph.row_map(row);
      for (auto from = matrix.graph.row_map(row); from < matrix.graph.row_map(row + 1); ++from) {
        while (result.graph.entries(to) != matrix.graph.entries(from)) {
          ++to;
        }
        result.values(to) += factor * matrix.values(from);
      }
    });
}

void leaveDiagonalOfHeld(CrsMatrix::local_matrix_device_type const& matrix,
                         ConstFlagView const& held)
{
  Kokkos::parallel_for(
    "asperity::fem::leaveDiagonalOfHeld", RangePolicy(0, matrix.numRows()), KOKKOS_LAMBDA(int row) {
      for (auto entry = matrix.graph.row_map(row); entry < matrix.graph.row_map(row + 1); ++entry) {
        const int column = matrix.graph.entries(entry);
        if (column != row && (held(row) || held(column))) {
          matrix.values(entry) = 0;
        } else if (column == row && held(row) && matrix.values(entry) == 0) {
          matrix.values(entry) = 1; // the jump at a tip of a fault, to which no cell contributes
        }
      }
    });
}

RCP<CrsMatrix> combineEntries(BodyMatrices const& body, Weights const& weights)
{
  ASPERITY_ASSERT(body.mass->getColMap()->isSameAs(*body.stiffness->getColMap()) &&
                  body.viscosity->getColMap()->isSameAs(*body.stiffness->getColMap()));
  auto result = rcp(new CrsMatrix(body.stiffness->getCrsGraph()));
  auto const to = result->getLocalMatrixDevice();
  Kokkos::deep_copy(to.values, 0.);
  addEntries(to, weights.mass, body.mass->getLocalMatrixDevice());
  addEntries(to, weights.viscosity, body.viscosity->getLocalMatrixDevice());
  addEntries(to, weights.stiffness, body.stiffness->getLocalMatrixDevice());
  for (std::size_t k = 0; k < weights.branches.size(); ++k) {
    addEntries(to, weights.branches[k], body.branches[k].stiffness->getLocalMatrixDevice());
  }
  return result;
}

RCP<CrsMatrix> finished(RCP<CrsMatrix> const& matrix)
{
  ExecutionSpace().fence();
  auto const graph = matrix->getCrsGraph();
  matrix->fillComplete(graph->getDomainMap(), graph->getRangeMap());
  return matrix;
}
} // namespace

Weights massWeights() { return {1, 0, 0}; }
Weights viscosityWeights() { return {0, 1, 0}; }

Weights branchWeights(BodyMatrices const& body, std::size_t branch)
{
  Weights weights = {0, 0, 0, std::vector<double>(body.branches.size(), 0.)};
  weights.branches[branch] = 1;
  return weights;
}

Weights elasticityWeights(BodyMatrices const& body)
{
  return {0, 0, 1, std::vector<double>(body.branches.size(), 1.)};
}

RCP<CrsMatrix> combine(BodyMatrices const& body, Weights const& weights)
{
  return finished(combineEntries(body, weights));
}

RCP<CrsMatrix> combine(BodyMatrices const& body, Weights const& weights, HeldDofs const& held)
{
  auto const result = combineEntries(body, weights);
  leaveDiagonalOfHeld(result->getLocalMatrixDevice(), held.flagsOnDevice());
  return finished(result);
}

template <int Dim>
BodyMatrices assembleBody(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                          std::vector<Material> const& materials,
                          std::vector<MaxwellBranch> const& branches,
                          VolumetricPatches const& patches)
{
  if constexpr (Dim == 2) {
    if (dofs.components() == 1) {
      ASPERITY_ASSERT(patches.patch_of_cell.empty());
      return assembleMatrices<2, 1>(mesh, dofs, frames, materials, branches, {});
    }
  }
  return assembleMatrices<Dim, Dim>(mesh, dofs, frames, materials, branches, patches);
}

template <int Dim>
RCP<Vector> assembleGravity(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                            std::vector<Material> const& materials,
                            std::array<double, Dim> const& acceleration)
{
  return dofs.components() == Dim
           ? assembleGravity<Dim, Dim>(mesh, dofs, frames, materials, acceleration)
           : rcp(new Vector(dofs.owned()));
}

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template BodyMatrices assembleBody<DIM>(                                                         \
    Mesh<DIM> const&, DofMap const&, NodalFrames const&, std::vector<Material> const&,             \
    std::vector<MaxwellBranch> const&, VolumetricPatches const&);                                  \
  template RCP<Vector> assembleGravity<DIM>(Mesh<DIM> const&, DofMap const&, NodalFrames const&,   \
                                            std::vector<Material> const&,                          \
                                            std::array<double, DIM> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE

template RCP<Vector> assembleGravity<2, 1>(Mesh<2> const&, DofMap const&, NodalFrames const&,
                                           std::vector<Material> const&,
                                           std::array<double, 1> const&);
template RCP<Vector> assembleGravity<2, 2>(Mesh<2> const&, DofMap const&, NodalFrames const&,
                                           std::vector<Material> const&,
                                           std::array<double, 2> const&);
template RCP<Vector> assembleGravity<3, 3>(Mesh<3> const&, DofMap const&, NodalFrames const&,
                                           std::vector<Material> const&,
                                           std::array<double, 3> const&);
} // namespace asperity::fem
