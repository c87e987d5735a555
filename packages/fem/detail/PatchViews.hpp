#pragma once

#include "base/Views.hpp"
#include "fem/VolumetricPatches.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "fem/detail/NodeRows.hpp"
#include "mesh/Mesh.hpp"

#include <map>

namespace asperity::fem::detail
{
// The mean volumetric strain of a patch is the sum over its nodes q of b_q . x_q, with the unknowns
// x in nodal frames: b [1/m] of each node.
template <int Dim>
std::map<int, Point<Dim>> meanStrainForm(VolumetricPatches::Patch const& patch,
                                         Mesh<Dim> const& mesh, NodalFrames const& frames);

// Copies b of some entries, (entries, Dim).
template <int Dim>
Kokkos::View<const double* [Dim], MemorySpace>
slopesOnDevice(std::vector<Point<Dim>> const& slopes);

// The forms of all patches. Entries are pairs of a patch and one of its nodes, those of a patch one
// after the other, ascending in the node.
template <int Dim>
struct PatchViews
{
  template <class Value>
  using View = Kokkos::View<Value, MemorySpace>;

  View<const int*> entries_begin;   // (num_patches + 1)
  View<const int*> nodes, patches;  // (num_entries)
  View<const double* [Dim]> slopes; // (num_entries, Dim) b [1/m]
  View<const double*> weights;      // (num_patches) |P| k_P

  View<const int*> at_node_begin; // (num_owned + 1)
  View<const int*> at_node;       // entries of the owned nodes, ascending
};

template <int Dim>
PatchViews<Dim> makePatchViews(Mesh<Dim> const& mesh, NodalFrames const& frames,
                               VolumetricPatches const& patches);

// Adds the stiffness of the patches to the rows of an owned node p.
template <int Dim>
struct AddPatches
{
  PatchViews<Dim> patches;
  LocalMatrix stiffness;

  KOKKOS_FUNCTION void operator()(int p) const
  {
    for (int k = patches.at_node_begin(p); k < patches.at_node_begin(p + 1); ++k) {
      const int entry = patches.at_node(k);
      const int patch = patches.patches(entry);
      for (int other = patches.entries_begin(patch); other < patches.entries_begin(patch + 1);
           ++other) {
        Block<Dim> block;
        for (int i = 0; i < Dim; ++i) {
          for (int j = 0; j < Dim; ++j) {
            block(i, j) = patches.slopes(entry, i) * patches.slopes(other, j);
          }
        }
        addBlock(stiffness, p, placeOf<Dim>(stiffness, p, patches.nodes(other)), block,
                 patches.weights(patch));
      }
    }
  }
};
} // namespace asperity::fem::detail
