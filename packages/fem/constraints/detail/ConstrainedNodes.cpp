#include "fem/constraints/detail/ConstrainedNodes.hpp"

#include "base/parallel/Agreement.hpp"
#include "fem/constraints/detail/FaultTurns.hpp"
#include "fem/constraints/detail/JointShares.hpp"
#include "fem/constraints/detail/NodeFrame.hpp"
#include "fem/constraints/detail/SplitDirections.hpp"
#include "fem/constraints/detail/VelocityAgreement.hpp"

#include <Tpetra_MultiVector.hpp>

#include <optional>
#include <utility>

namespace asperity::fem::detail
{
namespace
{
// Collects frames, flags of held dofs and prescribed velocities node by node.
template <int Dim>
class Collector
{
public:
  // Collective.
  Collector(Mesh<Dim> const& mesh, DofMap const& dofs,
            std::vector<VelocityCondition<Dim>> const& conditions)
      : mesh_(mesh)
      , dofs_(dofs)
      , conditions_(conditions)
      , frames_(dofs.numLocalNodes(), dofs.components(), mesh.splits)
      , held_flags_(static_cast<std::size_t>(dofs.numLocalNodes()) * dofs.components(), 0)
  {
    frames_.setShares(jointShares(mesh, dofs));
  }

  // Adds an owned node with the directions of its conditions. Not collective.
  void constrain(int node, std::vector<Direction> const& directions,
                 VelocityAgreement<Dim> const& agreement)
  {
    NodalBasis prescribed;
    for (auto const& [vector, condition, velocity] : directions) {
      Terms terms = velocity;
      if (conditions_[condition].prescribes() && !prescribed.add(vector, terms)) {
        agreement.require(node, condition, terms);
      }
    }
    auto const basis = basisOfFrame(conditions_, directions, prescribed, mesh_, node);
    const int turn = turnAt(conditions_, directions);
    auto const frame = frameFrom(basis, dofs_.components(), turn);
    bool along_axes = turn == 0 || (frame[0] >= 0 && frame[1] >= 0); // the tangent
    for (auto const& vector : basis.vectors()) {
      along_axes = along_axes && axisOf(vector) >= 0;
    }
    if (!along_axes) {
      frames_.set(node, frame);
    }
    prescribe(node, basis, along_axes);
  }

  // Holds all dofs of the nodes that VertexTerms holds.
  void holdNodes()
  {
    for (int node : frames_.vertexTerms().heldNodes()) {
      for (int c = 0; c < dofs_.components(); ++c) {
        held_flags_[dofs_.dof(node, c)] = 1;
      }
    }
  }

  // Gives ghosts the frames and flags of their owners. Collective.
  void shareWithGhosts()
  {
    const int components = dofs_.components();
    // The vectors have one column for each column of the frames, and one more for the flags.
    MultiVector owned(dofs_.owned(), components + 1);
    MultiVector local(dofs_.overlap(), components + 1);
    {
      auto values = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (int node = 0; node < dofs_.numOwnedNodes(); ++node) {
        for (int r = 0; r < components; ++r) {
          for (int c = 0; c < components; ++c) {
            values(dofs_.dof(node, r), c) = frames_.entry(node, r, c);
          }
          values(dofs_.dof(node, r), components) = held_flags_[dofs_.dof(node, r)];
        }
      }
    }
    dofs_.shareWithGhosts(owned, local);
    auto const values = local.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (int node = dofs_.numOwnedNodes(); node < dofs_.numLocalNodes(); ++node) {
      NodalFrames::Matrix frame{};
      for (int r = 0; r < components; ++r) {
        for (int c = 0; c < components; ++c) {
          frame[r * components + c] = values(dofs_.dof(node, r), c);
        }
        held_flags_[dofs_.dof(node, r)] = values(dofs_.dof(node, r), components) != 0;
      }
      frames_.set(node, frame);
    }
  }

  NodalFrames const& frames() const { return frames_; }
  HeldDofs held() const { return {held_flags_, dofs_.numOwnedNodes() * dofs_.components()}; }
  std::vector<PrescribedDof<Dim>> const& prescribedDofs() const { return prescribed_; }

private:
  // Holds the dofs of the node along the directions of its basis that have a velocity.
  void prescribe(int node, NodalBasis const& basis, bool along_axes)
  {
    for (int k = 0; k < basis.size(); ++k) {
      if (basis.velocity(k).empty()) {
        continue;
      }
      const int axis = axisOf(basis.vectors()[k]);
      const int row = along_axes ? axis : dofs_.components() - 1 - k;
      PrescribedDof<Dim> held{dofs_.dof(node, row), mesh_.vertices[node], basis.velocity(k)};
      if (along_axes && basis.vectors()[k][axis] < 0) {
        for (auto& term : held.terms) {
          term.second = -term.second;
        }
      }
      held_flags_[held.dof] = 1;
      prescribed_.push_back(std::move(held));
    }
  }

  Mesh<Dim> const& mesh_;
  DofMap const& dofs_;
  std::vector<VelocityCondition<Dim>> const& conditions_;
  NodalFrames frames_;
  std::vector<int> held_flags_; // (num local dofs)
  std::vector<PrescribedDof<Dim>> prescribed_;
};
} // namespace

template <int Dim>
ConstrainedNodes<Dim> constrainNodes(Mesh<Dim> const& mesh, DofMap const& dofs,
                                     std::vector<VelocityCondition<Dim>> conditions,
                                     std::vector<double> const& sample_times)
{
  auto const& communicator = *dofs.communicator();
  if (Dim == 2 && dofs.components() == 2) {
    chooseTurns(mesh, communicator, conditions);
  }
  Collector<Dim> nodes(mesh, dofs, conditions);
  auto const at_vertices = collectDirections(mesh, conditions, dofs.components());
  const VelocityAgreement<Dim> agreement(mesh, conditions, sample_times, at_vertices, communicator);
  std::optional<PrescribedVelocities<Dim>> velocities;
  // Only the owner of a node sees an error there; all ranks have to throw it.
  onEveryRank(communicator, [&] {
    for (auto const& [node, directions] :
         meansAndJumps(at_vertices, mesh, conditions, nodes.frames().vertexTerms())) {
      nodes.constrain(node, directions, agreement);
    }
    velocities.emplace(conditions, nodes.prescribedDofs());
  });
  nodes.holdNodes();
  nodes.shareWithGhosts();
  return {nodes.frames(), nodes.held(), std::move(*velocities)};
}

template ConstrainedNodes<2> constrainNodes(Mesh<2> const&, DofMap const&,
                                            std::vector<VelocityCondition<2>>,
                                            std::vector<double> const&);
template ConstrainedNodes<3> constrainNodes(Mesh<3> const&, DofMap const&,
                                            std::vector<VelocityCondition<3>>,
                                            std::vector<double> const&);
} // namespace asperity::fem::detail
