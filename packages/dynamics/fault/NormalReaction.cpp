#include "dynamics/fault/NormalReaction.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"

#include <Teuchos_OrdinalTraits.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>

namespace asperity::dynamics
{
namespace
{
// The component of a node's frame that none of its tangential dofs has.
int componentAcross(fem::FaultNode const& node, int first_dof, int components)
{
  for (int component = 0; component < components; ++component) {
    if (std::find(node.dofs.begin(), node.dofs.end(), first_dof + component) == node.dofs.end()) {
      return component;
    }
  }
  ASPERITY_ASSERT(false);
  return 0;
}
} // namespace

NormalReaction::NormalReaction(Body const& body, fem::FaultSurface const& surface,
                               fem::NodalFrames const& frames, std::vector<double> const& support)
    : body_(body)
    , map_(rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), surface.numNodes(),
                       0, surface.communicator())))
{
  const int components = body.dofs->components();
  ASPERITY_ASSERT(components > 1);
  std::vector<double> per_force;
  for (int i = 0; i < surface.numNodes(); ++i) {
    const int vertex = surface.vertex(i);
    const int component = componentAcross(surface[i], body.dofs->dof(vertex, 0), components);
    dofs_.push_back(body.dofs->dof(vertex, component));
    double outward = 0; // 1 or -1, since the frame follows the normal
    for (int d = 0; d < components; ++d) {
      outward += frames.entry(vertex, component, d) * surface[i].normal[d];
    }
    const bool counts = surface.slides(i) || surface.opens(i);
    ASPERITY_ASSERT(!counts || surface.opens(i) || body.held[dofs_.back()]);
    const double sign = outward > 0 ? 1 : -1;
    per_force.push_back(counts ? -sign / support[i] : 0);
  }
  dofs_on_device_ = toDevice(dofs_, "asperity::dynamics::dofsAcross");
  per_force_ = toDevice(per_force, "asperity::dynamics::compressionPerForce");
}

NormalReaction::NormalReaction(NormalReaction const& other, Body const& body,
                               std::vector<int> const& dofs)
    : NormalReaction(other)
{
  ASPERITY_ASSERT(dofs.size() == dofs_.size());
  body_ = body;
  dofs_ = dofs;
  dofs_on_device_ = toDevice(dofs_, "asperity::dynamics::dofsAcross");
}

void NormalReaction::compression(Vector const& l, Motion const& motion, NodeView const& R) const
{
  Vector rest(body_.dofs->owned());
  body_.residual(l, motion, rest);
  rest.scale(-1);
  gather(rest, R);
  compression(R, R);
}

RCP<const CrsMatrix> NormalReaction::rows(fem::Weights const& weights) const
{
  auto const Z = fem::combine(body_.matrices, weights);
  auto const graph = Z->getCrsGraph();
  auto result = rcp(new CrsMatrix(map_, graph->getColMap(), maxLocalRowEntries(*graph)));
  auto const local = Z->getLocalMatrixHost();
  std::vector<int> columns;
  std::vector<double> values;
  for (std::size_t i = 0; i < dofs_.size(); ++i) {
    columns.clear();
    values.clear();
    for (auto entry = local.graph.row_map(dofs_[i]); entry < local.graph.row_map(dofs_[i] + 1);
         ++entry) {
      if (!body_.held[local.graph.entries(entry)]) {
        columns.push_back(local.graph.entries(entry));
        values.push_back(local.values(entry));
      }
    }
    result->insertLocalValues(static_cast<int>(i), static_cast<int>(columns.size()), values.data(),
                              columns.data());
  }
  result->fillComplete(graph->getDomainMap(), map_);
  return result;
}

void NormalReaction::gather(Vector const& x, NodeView const& r) const
{
  auto const values = x.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const dofs = dofs_on_device_;
  Kokkos::parallel_for(
    "asperity::dynamics::gatherAcross", RangePolicy(0, dofs.extent_int(0)),
    KOKKOS_LAMBDA(int node) { r(node) = values(dofs(node), 0); });
}

void NormalReaction::compression(ConstNodeView const& r, NodeView const& R) const
{
  auto const per_force = per_force_;
  Kokkos::parallel_for(
    "asperity::dynamics::compression", RangePolicy(0, per_force.extent_int(0)),
    KOKKOS_LAMBDA(int node) { R(node) = per_force(node) * r(node); });
}

void NormalReaction::addCompression(ConstNodeView const& stress, Vector& b) const
{
  auto const values = b.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const dofs = dofs_on_device_;
  auto const per_force = per_force_;
  Kokkos::parallel_for(
    "asperity::dynamics::addCompression", RangePolicy(0, dofs.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      if (per_force(node) != 0) {
        values(dofs(node), 0) -= stress(node) / per_force(node);
      }
    });
}

ReactionSinceStart reactionSince(Motion const& start, Body const& body,
                                 std::shared_ptr<const NormalReaction> const& reaction)
{
  auto const load = body.vector();
  body.load(0, *load);
  const NodeView at_start("asperity::dynamics::reactionAtStart", reaction->dofs().size());
  reaction->compression(*load, start, at_start);
  return {reaction, at_start};
}
} // namespace asperity::dynamics
