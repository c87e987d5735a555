#include "fem/detail/CellViews.hpp"

#include "fem/Simplex.hpp"

#include <string>

namespace asperity::fem::detail
{
namespace
{
using HostPolicy = Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace>;

// A view on the device with the values that fill(host view) sets.
template <class View, class Fill, class... Extents>
View filled(std::string const& label, Fill const& fill, Extents... extents)
{
  const View view("asperity::fem::" + label, extents...);
  auto const host = Kokkos::create_mirror_view(view);
  fill(host);
  Kokkos::deep_copy(view, host);
  return view;
}

template <int Dim>
void copyCells(Mesh<Dim> const& mesh, CellViews<Dim>& views)
{
  using Vertices = Kokkos::View<int * [Dim + 1], MemorySpace>;
  using Numbers = Kokkos::View<double*, MemorySpace>;
  using Gradients = Kokkos::View<double * [Dim + 1][Dim], MemorySpace>;
  const auto num_cells = mesh.cells.size();
  const HostPolicy cells(0, static_cast<int>(num_cells));
  views.vertices = filled<Vertices>(
    "vertices",
    [&](auto const& host) {
      Kokkos::parallel_for("asperity::fem::copyCells", cells, [&](int cell) {
        for (int i = 0; i <= Dim; ++i) {
          host(cell, i) = mesh.cells[cell][i];
        }
      });
    },
    num_cells);
  views.measure = filled<Numbers>(
    "measure",
    [&](auto const& measure) {
      views.gradients = filled<Gradients>(
        "gradients",
        [&](auto const& gradients) {
          Kokkos::parallel_for("asperity::fem::simplices", cells, [&](int cell) {
            auto const simplex = simplexOf(mesh, cell);
            measure(cell) = simplex.measure;
            for (int i = 0; i <= Dim; ++i) {
              for (int k = 0; k < Dim; ++k) {
                gradients(cell, i, k) = simplex.gradients[i][k];
              }
            }
          });
        },
        num_cells);
    },
    num_cells);
}

template <int Dim>
void copyTerms(Mesh<Dim> const& mesh, NodalFrames const& frames, CellViews<Dim>& views)
{
  std::vector<int> begin = {0};
  std::vector<VertexTerms::Term> terms;
  for (int vertex = 0; vertex < static_cast<int>(mesh.vertices.size()); ++vertex) {
    auto const of_vertex = frames.terms(vertex);
    terms.insert(terms.end(), of_vertex.begin(), of_vertex.end());
    begin.push_back(static_cast<int>(terms.size()));
  }
  views.terms_begin = toDevice(begin, "asperity::fem::termsBegin");
  views.terms = toDevice(terms, "asperity::fem::terms");
}

// Calls visit(node, corner) for the corners of all cells at owned nodes, ascending in the cell.
template <int Dim, class Visit>
void forEachCorner(Mesh<Dim> const& mesh, NodalFrames const& frames, Visit const& visit)
{
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    for (int i = 0; i <= Dim; ++i) {
      for (auto const& [node, factor] : frames.terms(mesh.cells[cell][i])) {
        if (node < mesh.num_owned) {
          visit(node, Corner{cell, i, factor});
        }
      }
    }
  }
}

template <int Dim>
void copyCorners(Mesh<Dim> const& mesh, NodalFrames const& frames, CellViews<Dim>& views)
{
  std::vector<int> begin(mesh.num_owned + 1, 0);
  forEachCorner(mesh, frames, [&](int node, Corner const&) { ++begin[node + 1]; });
  for (int node = 0; node < mesh.num_owned; ++node) {
    begin[node + 1] += begin[node];
  }
  std::vector<Corner> corners(begin.back());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  forEachCorner(mesh, frames,
                [&](int node, Corner const& corner) { corners[next[node]++] = corner; });
  views.corners_begin = toDevice(begin, "asperity::fem::cornersBegin");
  views.corners = toDevice(corners, "asperity::fem::corners");
}
} // namespace

template <int Dim>
CellViews<Dim> makeCellViews(Mesh<Dim> const& mesh, NodalFrames const& frames,
                             std::vector<Material> const& materials)
{
  CellViews<Dim> views;
  copyCells(mesh, views);
  copyTerms(mesh, frames, views);
  copyCorners(mesh, frames, views);
  views.materials = toDevice(materials, "asperity::fem::materials");
  const int components = frames.components();
  views.frames = filled<Kokkos::View<double***, MemorySpace>>(
    "frames",
    [&](auto const& host) {
      for (int node = 0; node < frames.numNodes(); ++node) {
        for (int i = 0; i < components; ++i) {
          for (int k = 0; k < components; ++k) {
            host(node, i, k) = frames.entry(node, i, k);
          }
        }
      }
    },
    frames.numNodes(), components, components);
  return views;
}

template CellViews<2> makeCellViews(Mesh<2> const&, NodalFrames const&,
                                    std::vector<Material> const&);
template CellViews<3> makeCellViews(Mesh<3> const&, NodalFrames const&,
                                    std::vector<Material> const&);
} // namespace asperity::fem::detail
