#include "fem/detail/PatchViews.hpp"

#include "fem/Simplex.hpp"

namespace asperity::fem::detail
{
template <int Dim>
std::map<int, Point<Dim>> meanStrainForm(VolumetricPatches::Patch const& patch,
                                         Mesh<Dim> const& mesh, NodalFrames const& frames)
{
  std::map<int, Point<Dim>> form;
  for (const int cell : patch.cells) {
    auto const simplex = simplexOf(mesh, cell);
    for (int corner = 0; corner <= Dim; ++corner) {
      for (auto const& [node, factor] : frames.terms(mesh.cells[cell][corner])) {
        auto& slope = form[node];
        for (int c = 0; c < Dim; ++c) {
          for (int axis = 0; axis < Dim; ++axis) {
            slope[c] += simplex.measure / patch.measure * factor * frames.entry(node, c, axis) *
                        simplex.gradients[corner][axis];
          }
        }
      }
    }
  }
  return form;
}

template <int Dim>
Kokkos::View<const double* [Dim], MemorySpace>
slopesOnDevice(std::vector<Point<Dim>> const& slopes) {
  const Kokkos::View<double* [Dim], MemorySpace> view("asperity::fem::slopesOfPatches",
                                                      slopes.size());
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t entry = 0; entry < slopes.size(); ++entry) {
    for (int c = 0; c < Dim; ++c) {
      host(entry, c) = slopes[entry][c];
    }
  }
  Kokkos::deep_copy(view, host);
  return view;
}

template <int Dim>
PatchViews<Dim> makePatchViews(Mesh<Dim> const& mesh, NodalFrames const& frames,
                               VolumetricPatches const& patches)
{
  std::vector<int> begin = {0}, nodes, of_entries;
  std::vector<double> weights;
  std::vector<Point<Dim>> slopes;
  std::vector<int> at_node_begin(mesh.num_owned + 1, 0);
  for (auto const& patch : patches.patches) {
    for (auto const& [node, slope] : meanStrainForm(patch, mesh, frames)) {
      nodes.push_back(node);
      slopes.push_back(slope);
      of_entries.push_back(static_cast<int>(weights.size()));
      if (node < mesh.num_owned) {
        ++at_node_begin[node + 1];
      }
    }
    begin.push_back(static_cast<int>(nodes.size()));
    weights.push_back(patch.measure * patch.modulus);
  }
  for (int node = 0; node < mesh.num_owned; ++node) {
    at_node_begin[node + 1] += at_node_begin[node];
  }
  std::vector<int> at_node(at_node_begin.back());
  std::vector<int> next(at_node_begin.begin(), at_node_begin.end() - 1);
  for (std::size_t entry = 0; entry < nodes.size(); ++entry) {
    if (nodes[entry] < mesh.num_owned) {
      at_node[next[nodes[entry]]++] = static_cast<int>(entry);
    }
  }
  return {toDevice(begin, "asperity::fem::entriesOfPatches"),
          toDevice(nodes, "asperity::fem::nodesOfPatches"),
          toDevice(of_entries, "asperity::fem::patchesOfEntries"),
          slopesOnDevice<Dim>(slopes),
          toDevice(weights, "asperity::fem::weightsOfPatches"),
          toDevice(at_node_begin, "asperity::fem::patchesAtNodesBegin"),
          toDevice(at_node, "asperity::fem::patchesAtNodes")};
}

template std::map<int, Point<2>> meanStrainForm<2>(VolumetricPatches::Patch const&, Mesh<2> const&,
                                                   NodalFrames const&);
template std::map<int, Point<3>> meanStrainForm<3>(VolumetricPatches::Patch const&, Mesh<3> const&,
                                                   NodalFrames const&);
template Kokkos::View<const double* [2], MemorySpace>
slopesOnDevice<2>(std::vector<Point<2>> const&);
template Kokkos::View<const double* [3], MemorySpace>
slopesOnDevice<3>(std::vector<Point<3>> const&);
template PatchViews<2> makePatchViews(Mesh<2> const&, NodalFrames const&, VolumetricPatches const&);
template PatchViews<3> makePatchViews(Mesh<3> const&, NodalFrames const&, VolumetricPatches const&);
} // namespace asperity::fem::detail
