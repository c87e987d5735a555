#include "fem/motions/RigidBodyMotions.hpp"

#include "base/parallel/Reductions.hpp"

#include <Tpetra_MultiVector.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace asperity::fem
{
namespace
{
template <int Dim>
struct Box
{
  Point<Dim> centre{};
  double half_size = 0; // half the length of its longest side

  Box(Mesh<Dim> const& mesh, Communicator const& communicator)
  {
    // These are the lowest coordinates, and the highest ones with the opposite sign.
    std::vector<double> mine(2 * Dim, std::numeric_limits<double>::max());
    for (int node = 0; node < mesh.num_owned; ++node) {
      for (int d = 0; d < Dim; ++d) {
        mine[d] = std::min(mine[d], mesh.vertices[node][d]);
        mine[Dim + d] = std::min(mine[Dim + d], -mesh.vertices[node][d]);
      }
    }
    auto const all = minOverRanks(mine, communicator);
    for (int d = 0; d < Dim; ++d) {
      centre[d] = (all[d] - all[Dim + d]) / 2;
      half_size = std::max(half_size, -(all[d] + all[Dim + d]) / 2);
    }
  }
};

// The rotations that the periods of the mesh admit, each given by the two axes of its plane.
template <int Dim>
std::vector<std::pair<int, int>> rotations(Mesh<Dim> const& mesh)
{
  std::vector<std::pair<int, int>> planes;
  for (int first = 0; first < Dim; ++first) {
    for (int second = first + 1; second < Dim; ++second) {
      if (mesh.period[first] == 0 && mesh.period[second] == 0) {
        planes.emplace_back(first, second);
      }
    }
  }
  return planes;
}
} // namespace

template <int Dim>
RCP<const MultiVector> rigidBodyMotions(Mesh<Dim> const& mesh, DofMap const& dofs,
                                        NodalFrames const& frames)
{
  const int components = dofs.components();
  auto const planes = components == 1 ? decltype(rotations(mesh)){} : rotations(mesh);
  const Box<Dim> box(mesh, *dofs.communicator());
  auto motions = rcp(new MultiVector(dofs.owned(), components + planes.size()));
  auto const values = motions->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (int node = 0; node < dofs.numOwnedNodes(); ++node) {
    if (frames.vertexTerms().isJump(node)) {
      for (std::size_t motion = 0; motion < components + planes.size(); ++motion) {
        for (int c = 0; c < components; ++c) {
          values(dofs.dof(node, c), motion) = 0;
        }
      }
      continue;
    }
    auto const store = [&](int motion, Point<3> const& along_axes) {
      Point<3> local{};
      frames.toFrame(node, along_axes.data(), local.data());
      for (int c = 0; c < components; ++c) {
        values(dofs.dof(node, c), motion) = local[c];
      }
    };
    for (int c = 0; c < components; ++c) {
      Point<3> translation{};
      translation[c] = 1;
      store(c, translation);
    }
    for (std::size_t k = 0; k < planes.size(); ++k) {
      auto const [first, second] = planes[k];
      Point<3> rotation{};
      rotation[first] = -(mesh.vertices[node][second] - box.centre[second]) / box.half_size;
      rotation[second] = (mesh.vertices[node][first] - box.centre[first]) / box.half_size;
      store(components + static_cast<int>(k), rotation);
    }
  }
  return motions;
}

template RCP<const MultiVector> rigidBodyMotions(Mesh<2> const&, DofMap const&, NodalFrames const&);
template RCP<const MultiVector> rigidBodyMotions(Mesh<3> const&, DofMap const&, NodalFrames const&);
} // namespace asperity::fem
