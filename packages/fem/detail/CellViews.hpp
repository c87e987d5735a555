#pragma once

#include "base/Views.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "mesh/Mesh.hpp"

namespace asperity::fem::detail
{
// Corner number `corner` of a cell; the vector there contains the unknowns of a node times
// `factor`.
struct Corner
{
  int cell;
  int corner;
  double factor;
};

// The cells as assembly needs them, copied to the device. Lists that belong to nodes or vertices
// are stored one after the other: that of number i has the places begin(i) to begin(i + 1) - 1.
template <int Dim>
struct CellViews
{
  template <class Value>
  using View = Kokkos::View<Value, MemorySpace>;

  View<const int * [Dim + 1]> vertices;          // (num_cells, Dim + 1)
  View<const double*> measure;                   // (num_cells) m^Dim
  View<const double * [Dim + 1][Dim]> gradients; // (num_cells, Dim + 1, Dim) 1/m
  View<const Material*> materials;               // (num_cells)

  View<const int*> corners_begin; // (num_owned + 1)
  View<const Corner*> corners;    // of the owned nodes, ascending in the cell
  View<const int*> terms_begin;   // (num_vertices + 1)
  View<const VertexTerms::Term*> terms;

  Kokkos::View<const double***, MemorySpace> frames; // (num_nodes, components, components)
};

template <int Dim>
CellViews<Dim> makeCellViews(Mesh<Dim> const& mesh, NodalFrames const& frames,
                             std::vector<Material> const& materials);
} // namespace asperity::fem::detail
