#pragma once

#include "fem/detail/CellViews.hpp"
#include "fem/detail/ElementBlocks.hpp"
#include "fem/detail/NodeRows.hpp"

namespace asperity::fem::detail
{
// The rows of M, C and K of one owned node p: the sum over its cells, in their order, and over the
// nodes q of each. No two nodes write to one entry, so that the result is the same on any backend.
template <int Dim, int Components>
struct AssembleRows
{
  CellViews<Dim> cells;
  LocalMatrix mass, viscosity, stiffness; // on one graph

  KOKKOS_FUNCTION void operator()(int p) const
  {
    for (int c = cells.corners_begin(p); c < cells.corners_begin(p + 1); ++c) {
      for (int j = 0; j <= Dim; ++j) {
        addPair(p, cells.corners(c), j);
      }
    }
  }

  // The coupling of node p with the nodes of corner j of the cell.
  KOKKOS_FUNCTION void addPair(int p, Corner const& corner, int j) const
  {
    const int cell = corner.cell;
    auto const& m = cells.materials(cell);
    double gp[Dim], gq[Dim];
    for (int k = 0; k < Dim; ++k) {
      gp[k] = cells.gradients(cell, corner.corner, k);
      gq[k] = cells.gradients(cell, j, k);
    }
    const double share = (corner.corner == j ? 2. : 1.) / ((Dim + 1) * (Dim + 2));
    auto const viscous = isotropicBlock<Dim, Components>(
      gp, gq, m.bulk_viscosity - 2. / 3 * m.shear_viscosity, m.shear_viscosity);
    auto const elastic = isotropicBlock<Dim, Components>(
      gp, gq, m.bulk_modulus - 2. / 3 * m.shear_modulus, m.shear_modulus);
    const int vertex = cells.vertices(cell, j);
    for (int t = cells.terms_begin(vertex); t < cells.terms_begin(vertex + 1); ++t) {
      const int q = cells.terms(t).node;
      const double measure = corner.factor * cells.terms(t).factor * cells.measure(cell);
      const int place = placeOf<Components>(mass, p, q);
      addBlock(mass, p, place, inFrames(unitBlock<Components>(), cells.frames, p, q),
               m.density * measure * share);
      addBlock(viscosity, p, place, inFrames(viscous, cells.frames, p, q), measure);
      addBlock(stiffness, p, place, inFrames(elastic, cells.frames, p, q), measure);
    }
  }
};
} // namespace asperity::fem::detail
