#include "fem/FaultSurface.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "fem/Colouring.hpp"
#include "mesh/SplitVertices.hpp"

#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <set>
#include <unordered_map>

namespace asperity::fem
{
namespace
{
// The tangential dofs of each node and, with_across, the one across.
NodeDofView dofView(std::vector<FaultNode> const& nodes, int num_tangents, bool with_across)
{
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> view(
    "asperity::fem::faultDofs", nodes.size(), num_tangents + (with_across ? 1 : 0));
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    for (int k = 0; k < num_tangents; ++k) {
      host(node, k) = nodes[node].dofs[k];
    }
    if (with_across) {
      host(node, num_tangents) = nodes[node].across;
    }
  }
  Kokkos::deep_copy(view, host);
  return view;
}
} // namespace

FaultSurface::FaultSurface(std::string name, std::vector<FaultNode> nodes, int num_tangents,
                           HeldDofs held, std::vector<IndexView> colours,
                           OtherSide const& other_side, RCP<const Communicator> const& communicator)
    : name_(std::move(name))
    , nodes_(std::move(nodes))
    , num_tangents_(num_tangents)
    , held_(std::move(held))
    , colours_(std::move(colours))
    , other_side_(other_side)
    , communicator_(communicator)
    , dofs_(dofView(nodes_, num_tangents, false))
    , unknowns_(mayOpen() ? dofView(nodes_, num_tangents, true) : dofs_)
{
  ASPERITY_ASSERT(std::is_sorted(nodes_.begin(), nodes_.end(), [](auto const& a, auto const& b) {
    return a.copies.front() < b.copies.front();
  }));
  std::vector<double> weights;
  std::vector<int> sliding, counted;
  double mine = 0;
  for (int node = 0; node < numNodes(); ++node) {
    weights.push_back(nodes_[node].weight);
    sliding.push_back(slides(node) ? 1 : 0);
    counted.push_back(counts(node) ? 1 : 0);
    mine += nodes_[node].weight;
  }
  sliding_ = toDevice(sliding, "asperity::fem::slidingNodes");
  counted_ = toDevice(counted, "asperity::fem::countedNodes");
  if (mayOpen()) {
    std::vector<int> opening, across;
    std::vector<double> signs;
    for (int node = 0; node < numNodes(); ++node) {
      opening.push_back(opens(node) ? 1 : 0);
      across.push_back(nodes_[node].across);
      signs.push_back(nodes_[node].opening_sign);
    }
    opening_ = toDevice(opening, "asperity::fem::openingNodes");
    across_ = toDevice(across, "asperity::fem::dofsAcross");
    opening_signs_ = toDevice(signs, "asperity::fem::openingSigns");
  }
  weights_ = toDevice(weights, "asperity::fem::faultWeights");
  slip_factors_ =
    toDevice(std::vector<double>(nodes_.size(), slipFactor()), "asperity::fem::slipFactors");
  total_weight_ = sumOverRanks(mine, *communicator_);
  num_global_nodes_ = sumOverRanks(static_cast<std::int64_t>(nodes_.size()), *communicator_);
  num_sliding_ = sumOverRanks(
    static_cast<std::int64_t>(std::count(sliding.begin(), sliding.end(), 1)), *communicator_);
}

std::shared_ptr<const FaultSurface>
FaultSurface::withPlateRate(std::vector<double> const& rates) const
{
  ASPERITY_ASSERT(rates.size() == nodes_.size() * num_tangents_);
  auto result = std::make_shared<FaultSurface>(*this);
  result->has_plate_rate_ = true;
  result->plate_rate_ = rates;
  result->plate_rates_ = toDevice(rates, "asperity::fem::plateRates");
  return result;
}

std::vector<int> FaultSurface::vertices() const
{
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(numNodes()));
  for (int node = 0; node < numNodes(); ++node) {
    result.push_back(vertex(node));
  }
  return result;
}

int FaultSurface::nodeAt(int vertex) const
{
  auto const place =
    std::lower_bound(nodes_.begin(), nodes_.end(), vertex, [](FaultNode const& node, int wanted) {
      return node.copies.front() < wanted;
    });
  return place != nodes_.end() && place->copies.front() == vertex
           ? static_cast<int>(place - nodes_.begin())
           : -1;
}

bool FaultSurface::slides(int node) const
{
  for (int k = 0; k < num_tangents_; ++k) {
    if (!held(node, k)) {
      return true;
    }
  }
  return false;
}

std::vector<int> FaultSurface::unknownsOf(int node) const
{
  auto result = nodes_[node].dofs;
  if (mayOpen()) {
    result.push_back(nodes_[node].across);
  }
  return result;
}

void addTraction(FaultSurface const& surface, std::vector<double> const& traction, Vector& load)
{
  auto const values = load.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const given = toDevice(traction, "asperity::fem::traction");
  auto const dofs = surface.dofs();
  auto const weights = surface.weights();
  Kokkos::parallel_for(
    "asperity::fem::addTraction", RangePolicy(0, surface.numNodes()), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < dofs.extent_int(1); ++k) {
        values(dofs(node, k), 0) += weights(node) * given(node * dofs.extent_int(1) + k);
      }
    });
}

namespace
{
// The vertices at the place of a node of the fault, its own first.
std::vector<int> copiesOf(mesh::FaultPairs const& pairs,
                          std::unordered_multimap<int, int> const& joints_of_main, int vertex)
{
  if (auto const* of = pairs.findCrossing(vertex)) {
    return {vertex, of->crossing.mean, of->other(), of->crossing.both};
  }
  auto const* split = pairs.find(vertex);
  auto copies = split ? std::vector<int>{vertex, split->minus} : std::vector<int>{vertex};
  const auto [first, last] = joints_of_main.equal_range(vertex);
  for (auto joint = first; joint != last; ++joint) {
    copies.push_back(joint->second);
  }
  return copies;
}

// Sets the unknown across a node whose tangential components are these. The minus side lies where
// the normal points: the sides part where the plus side moves against it.
void setAcross(NodalFrames const& frames, DofMap const& dofs, std::vector<int> const& tangential,
               FaultNode& node)
{
  const int vertex = node.copies.front();
  for (int component = 0; component < frames.components(); ++component) {
    if (std::find(tangential.begin(), tangential.end(), component) == tangential.end()) {
      double outward = 0; // 1 or -1, since the frame follows the normal
      for (int d = 0; d < frames.components(); ++d) {
        outward += frames.entry(vertex, component, d) * node.normal[d];
      }
      node.across = dofs.dof(vertex, component);
      node.opening_sign = outward > 0 ? -1 : 1;
    }
  }
}
} // namespace

template <int Dim>
std::shared_ptr<const FaultSurface>
makeFaultSurface(Mesh<Dim> const& mesh, std::string const& boundary,
                 Constraints<Dim> const& constraints, DofMap const& dofs, CrsGraph const& graph,
                 OtherSide const& other_side, Boundaries const& given_slip)
{
  constexpr int num_tangents = Dim - 1;
  if (boundary.empty()) {
    return std::make_shared<FaultSurface>(boundary, std::vector<FaultNode>(), num_tangents,
                                          constraints.held(), std::vector<IndexView>(), other_side,
                                          dofs.communicator());
  }
  const mesh::FaultPairs pairs(mesh.splits);
  std::unordered_multimap<int, int> joints_of_main; // plus vertices
  for (auto const& joint : mesh::jointsOf(mesh.splits)) {
    joints_of_main.emplace(joint.main, joint.plus);
  }
  std::set<int> with_given_slip; // vertices
  for (auto const& name : given_slip) {
    for (auto const& facet : mesh.boundaries.at(name)) {
      with_given_slip.insert(facet.begin(), facet.end());
    }
  }
  std::vector<FaultNode> nodes;
  for (auto const& measure : boundaryMeasure(mesh, boundary, *dofs.communicator())) {
    FaultNode node;
    node.copies = copiesOf(pairs, joints_of_main, measure.node);
    node.weight = measure.weight;
    node.has_given_slip = with_given_slip.count(measure.node) > 0;
    for (int i = 0; i < Dim; ++i) {
      node.place[i] = mesh.vertices[measure.node][i];
      node.normal[i] = measure.normal[i];
    }
    auto const& frames = constraints.frames();
    auto const tangential = tangentialComponents(frames, measure.node, measure.normal);
    for (int component : tangential) {
      node.dofs.push_back(dofs.dof(measure.node, component));
      node.tangents.push_back(frames.row(measure.node, component));
    }
    if (other_side.may_open) {
      setAcross(frames, dofs, tangential, node);
    }
    nodes.push_back(std::move(node));
  }
  auto const& held = constraints.held();
  auto colours =
    colourFreeNodes(graph, dofView(nodes, num_tangents, other_side.may_open), held.flags());
  return std::make_shared<FaultSurface>(boundary, std::move(nodes), num_tangents, held,
                                        std::move(colours), other_side, dofs.communicator());
}

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template std::shared_ptr<const FaultSurface> makeFaultSurface(                                   \
    Mesh<DIM> const&, std::string const&, Constraints<DIM> const&, DofMap const&, CrsGraph const&, \
    OtherSide const&, Boundaries const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::fem
