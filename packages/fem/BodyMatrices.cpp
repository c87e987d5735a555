#include "fem/BodyMatrices.hpp"

#include "base/Errors.hpp"
#include "base/program/WorkTimers.hpp"
#include "fem/Simplex.hpp"

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
Adjacency neighbours(Mesh<Dim> const& mesh, NodalFrames const& frames)
{
  Adjacency adjacency(mesh.num_owned);
  std::vector<int> nodes;
  for (auto const& cell : mesh.cells) {
    nodes.clear();
    for (int vertex : cell) {
      for (auto const& term : frames.terms(vertex)) {
        nodes.push_back(term.node);
      }
    }
    for (int p : nodes) {
      if (p < mesh.num_owned) {
        adjacency[p].insert(adjacency[p].end(), nodes.begin(), nodes.end());
      }
    }
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
  std::size_t entries = 0;
  for (std::size_t node = 0; node < adjacency.size(); ++node) {
    for (int c = 0; c < components; ++c) {
      pointers(node * components + c) = entries;
      entries += adjacency[node].size() * components;
    }
  }
  pointers(adjacency.size() * components) = entries;
  Columns columns("asperity::fem::columns", entries);
  std::size_t entry = 0;
  for (auto const& row : adjacency) {
    for (int c = 0; c < components; ++c) {
      for (int neighbour : row) {
        for (int k = 0; k < components; ++k) {
          columns(entry++) = dofs.dof(neighbour, k);
        }
      }
    }
  }
  auto graph = rcp(new CrsGraph(dofs.owned(), dofs.overlap(), pointers, columns));
  graph->expertStaticFillComplete(dofs.owned(), dofs.owned());
  return graph;
}

template <int Components>
using Block = std::array<double, Components * Components>;

// Coupling of basis functions p and q by an isotropic tensor with Lame constants first and second.
template <int Dim, int Components>
Block<Components> isotropic(Point<Dim> const& gp, Point<Dim> const& gq, double first, double second)
{
  double dot = 0;
  for (int i = 0; i < Dim; ++i) {
    dot += gp[i] * gq[i];
  }
  Block<Components> block{};
  if constexpr (Components == 1) {
    block[0] = second * dot;
  } else {
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) {
        block[i * Dim + j] = first * gp[i] * gq[j] + second * gp[j] * gq[i];
      }
      block[i * Dim + i] += second * dot;
    }
  }
  return block;
}

// frame_p * block * frame_q^T of two nodes
template <int Components>
Block<Components> rotate(Block<Components> const& block, NodalFrames const& frames, int p, int q)
{
  Block<Components> half{};
  Block<Components> rotated{};
  for (int i = 0; i < Components; ++i) {
    for (int j = 0; j < Components; ++j) {
      for (int k = 0; k < Components; ++k) {
        half[i * Components + j] += frames.entry(p, i, k) * block[k * Components + j];
      }
    }
  }
  for (int i = 0; i < Components; ++i) {
    for (int j = 0; j < Components; ++j) {
      for (int k = 0; k < Components; ++k) {
        rotated[i * Components + j] += half[i * Components + k] * frames.entry(q, j, k);
      }
    }
  }
  return rotated;
}

// Where the blocks of one owned node's neighbours stand in the values of a matrix.
template <int Components>
class BlockWriter
{
public:
  BlockWriter(Adjacency const& adjacency, CrsMatrix& matrix)
      : adjacency_(adjacency)
      , values_(matrix.getLocalMatrixHost().values)
      , rows_(matrix.getLocalMatrixHost().graph.row_map)
  {
  }

  void add(int p, int q, Block<Components> const& block, double factor)
  {
    auto const& row = adjacency_[p];
    auto const place = std::lower_bound(row.begin(), row.end(), q) - row.begin();
    for (int i = 0; i < Components; ++i) {
      const auto first = rows_(p * Components + i) + place * Components;
      for (int j = 0; j < Components; ++j) {
        values_(first + j) += factor * block[i * Components + j];
      }
    }
  }

private:
  Adjacency const& adjacency_;
  decltype(std::declval<CrsMatrix>().getLocalMatrixHost().values) values_;
  decltype(std::declval<CrsMatrix>().getLocalMatrixHost().graph.row_map) rows_;
};
} // namespace

template <int Dim, int Components>
BodyMatrices assembleBody(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                          std::vector<Material> const& materials)
{
  ASPERITY_TIME_WORK("assembly");
  ASPERITY_ASSERT(dofs.components() == Components && materials.size() == mesh.cells.size());
  auto const adjacency = neighbours(mesh, frames);
  auto const graph = graphOf(adjacency, dofs);
  auto mass = rcp(new CrsMatrix(graph));
  auto viscosity = rcp(new CrsMatrix(graph));
  auto stiffness = rcp(new CrsMatrix(graph));
  {
    BlockWriter<Components> write_mass(adjacency, *mass);
    BlockWriter<Components> write_viscosity(adjacency, *viscosity);
    BlockWriter<Components> write_stiffness(adjacency, *stiffness);
    auto const unit = [] {
      Block<Components> block{};
      for (int c = 0; c < Components; ++c) {
        block[c * Components + c] = 1;
      }
      return block;
    }();
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      auto const simplex = simplexOf(mesh, static_cast<int>(cell));
      auto const& m = materials[cell];
      const double lame_elastic = m.bulk_modulus - 2. / 3 * m.shear_modulus;
      const double lame_viscous = m.bulk_viscosity - 2. / 3 * m.shear_viscosity;
      for (int i = 0; i <= Dim; ++i) {
        for (int j = 0; j <= Dim; ++j) {
          auto const& gp = simplex.gradients[i];
          auto const& gq = simplex.gradients[j];
          const double share = (i == j ? 2. : 1.) / ((Dim + 1) * (Dim + 2));
          auto const viscous = isotropic<Dim, Components>(gp, gq, lame_viscous, m.shear_viscosity);
          auto const elastic = isotropic<Dim, Components>(gp, gq, lame_elastic, m.shear_modulus);
          for (auto const& [p, factor_p] : frames.terms(mesh.cells[cell][i])) {
            if (p >= mesh.num_owned) {
              continue;
            }
            for (auto const& [q, factor_q] : frames.terms(mesh.cells[cell][j])) {
              const double measure = factor_p * factor_q * simplex.measure;
              write_mass.add(p, q, rotate<Components>(unit, frames, p, q),
                             m.density * measure * share);
              write_viscosity.add(p, q, rotate<Components>(viscous, frames, p, q), measure);
              write_stiffness.add(p, q, rotate<Components>(elastic, frames, p, q), measure);
            }
          }
        }
      }
    }
  }
  mass->fillComplete(dofs.owned(), dofs.owned());
  viscosity->fillComplete(dofs.owned(), dofs.owned());
  stiffness->fillComplete(dofs.owned(), dofs.owned());
  return {mass, viscosity, stiffness};
}

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

RCP<CrsMatrix> combine(BodyMatrices const& body, double factor_mass, double factor_viscosity,
                       double factor_stiffness, HeldDofs const& held)
{
  auto const graph = body.mass->getCrsGraph();
  auto result = rcp(new CrsMatrix(graph));
  {
    auto const m = body.mass->getLocalMatrixHost().values;
    auto const c = body.viscosity->getLocalMatrixHost().values;
    auto const k = body.stiffness->getLocalMatrixHost().values;
    auto const local = result->getLocalMatrixHost();
    auto const rows = local.graph.row_map;
    for (int row = 0; row < local.numRows(); ++row) {
      for (auto entry = rows(row); entry < rows(row + 1); ++entry) {
        const int column = local.graph.entries(entry);
        const bool kept = column == row || (!held[row] && !held[column]);
        local.values(entry) =
          kept ? factor_mass * m(entry) + factor_viscosity * c(entry) + factor_stiffness * k(entry)
               : 0;
        if (column == row && held[row] && local.values(entry) == 0) {
          local.values(entry) = 1; // the jump at a tip of a fault, of which no cell knows
        }
      }
    }
  }
  result->fillComplete(graph->getDomainMap(), graph->getRangeMap());
  return result;
}

template <int Dim>
BodyMatrices assembleBody(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                          std::vector<Material> const& materials)
{
  if (dofs.components() == Dim) {
    return assembleBody<Dim, Dim>(mesh, dofs, frames, materials);
  }
  ASPERITY_ASSERT(Dim == 2 && dofs.components() == 1);
  if constexpr (Dim == 2) {
    return assembleBody<2, 1>(mesh, dofs, frames, materials);
  }
  return {};
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

#define ASPERITY_INSTANTIATE(DIM, COMPONENTS)                                                      \
  template BodyMatrices assembleBody<DIM, COMPONENTS>(                                             \
    Mesh<DIM> const&, DofMap const&, NodalFrames const&, std::vector<Material> const&);            \
  template RCP<Vector> assembleGravity<DIM, COMPONENTS>(                                           \
    Mesh<DIM> const&, DofMap const&, NodalFrames const&, std::vector<Material> const&,             \
    std::array<double, COMPONENTS> const&);

ASPERITY_INSTANTIATE(2, 1)
ASPERITY_INSTANTIATE(2, 2)
ASPERITY_INSTANTIATE(3, 3)
#undef ASPERITY_INSTANTIATE

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template BodyMatrices assembleBody<DIM>(Mesh<DIM> const&, DofMap const&, NodalFrames const&,     \
                                          std::vector<Material> const&);                           \
  template RCP<Vector> assembleGravity<DIM>(Mesh<DIM> const&, DofMap const&, NodalFrames const&,   \
                                            std::vector<Material> const&,                          \
                                            std::array<double, DIM> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::fem
