#include "fem/constraints/detail/JointShares.hpp"

#include "mesh/SimplexGeometry.hpp"
#include "mesh/SplitVertices.hpp"

#include <Tpetra_MultiVector.hpp>

#include <unordered_map>

namespace asperity::fem::detail
{
namespace
{
// Complete for the joints that the part owns.
template <int Dim>
std::vector<double> ownShares(Mesh<Dim> const& mesh, std::vector<mesh::Joint> const& joints)
{
  std::unordered_multimap<int, std::size_t> of_main;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    of_main.emplace(joints[i].main, i);
  }
  std::vector<double> beside(joints.size(), 0.), all(joints.size(), 0.);
  const mesh::FaultSides<Dim> sides(mesh);
  for (auto const& name : mesh.faults) {
    for (auto const& facet : mesh.boundaries.at(name)) {
      for (int corner = 0; corner < Dim; ++corner) {
        const auto [first, last] = of_main.equal_range(facet[corner]);
        for (auto entry = first; entry != last; ++entry) {
          auto const& joint = joints[entry->second];
          const auto of_cell =
            joint.is_on_plus_side ? sides.plusSide(facet) : sides.minusSide(facet);
          const double measure = mesh::facetMeasure(mesh::corners(mesh, facet));
          all[entry->second] += measure;
          beside[entry->second] += of_cell[corner] == joint.plus ? measure : 0;
        }
      }
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    beside[i] /= all[i] > 0 ? all[i] : 1;
  }
  return beside;
}
} // namespace

template <int Dim>
std::vector<double> jointShares(Mesh<Dim> const& mesh, DofMap const& dofs)
{
  if (mesh.faults.empty()) { // on all ranks
    return {};
  }
  const auto joints = mesh::jointsOf(mesh.splits);
  auto shares = ownShares(mesh, joints);
  MultiVector owned(dofs.owned(), 1), local(dofs.overlap(), 1);
  {
    auto const values = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    Kokkos::deep_copy(values, 0.);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (joints[i].plus < mesh.num_owned) {
        values(dofs.dof(joints[i].plus, 0), 0) = shares[i];
      }
    }
  }
  dofs.shareWithGhosts(owned, local);
  auto const values = local.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    shares[i] = values(dofs.dof(joints[i].plus, 0), 0);
  }
  return shares;
}

template std::vector<double> jointShares(Mesh<2> const&, DofMap const&);
template std::vector<double> jointShares(Mesh<3> const&, DofMap const&);
} // namespace asperity::fem::detail
