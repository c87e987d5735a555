#include "fem/constraints/Constraints.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/constraints/detail/FaultTurns.hpp"
#include "fem/constraints/detail/SplitDirections.hpp"
#include "mesh/PointText.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::fem
{
using detail::axisOf;
using detail::NodalBasis;
using detail::Terms;

namespace
{
using Vectors = std::vector<std::vector<double>>;

// The frame whose last rows are these orthonormal directions. Its first rows are the tangents, in
// the order of the axes that they are near to. It is not always right-handed.
NodalFrames::Matrix frameFrom(Vectors basis, int components, int turn)
{
  auto frame = NodalFrames::identity(components);
  const int given = static_cast<int>(basis.size());
  while (static_cast<int>(basis.size()) < components) {
    basis.push_back(basis.size() == 1 && turn != 0 ? detail::tangentOf(basis[0], turn)
                                                   : detail::completing(basis, components));
  }
  for (int k = 0; k < components; ++k) {
    const int row = k < given ? components - 1 - k : k - given;
    for (int c = 0; c < components; ++c) {
      frame[row * components + c] = basis[k][c];
    }
  }
  return frame;
}

// x(dofs) := values
void set(Vector& x, IndexView const& dofs, ConstNodeView const& values)
{
  auto const target = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::fem::prescribe", RangePolicy(0, dofs.extent_int(0)),
    KOKKOS_LAMBDA(int k) { target(dofs(k), 0) = values(k); });
}
} // namespace

template <int Dim>
Constraints<Dim>::Constraints(Mesh<Dim> const& mesh, DofMap const& dofs,
                              std::vector<VelocityCondition<Dim>> conditions,
                              std::vector<double> const& sample_times)
    : conditions_(std::move(conditions))
    , sample_times_(sample_times)
    , frames_(dofs.numLocalNodes(), dofs.components(), mesh.splits)
    , held_flags_(static_cast<std::size_t>(dofs.numLocalNodes()) * dofs.components(), 0)
    , owned_vertices_(mesh.vertices.begin(), mesh.vertices.begin() + mesh.num_owned)
{
  if (Dim == 2 && dofs.components() == 2) {
    detail::chooseTurns(mesh, *dofs.communicator(), conditions_);
  }
  auto const at_vertices = detail::collectDirections(mesh, conditions_, dofs.components());
  largest_ = largestVelocities(at_vertices, *dofs.communicator());
  // Only the owner of a node sees an error there; all ranks have to throw it.
  onEveryRank(*dofs.communicator(), [&] {
    for (auto const& [node, of_node] : detail::meansAndJumps(at_vertices, mesh, conditions_)) {
      constrain(dofs, node, of_node);
    }
    moveToDevice();
  });
  holdNodes(dofs);
  shareWithGhosts(dofs);
  held_.emplace(std::move(held_flags_), dofs.numOwnedNodes() * dofs.components());
}

// The scale for differences of velocities: at a corner the prescribed velocity itself may be zero
// up to rounding.
template <int Dim>
std::vector<double> Constraints<Dim>::largestVelocities(NodalDirections const& directions,
                                                        Communicator const& communicator) const
{
  std::vector<double> mine(conditions_.size(), 0.);
  for (auto const& [node, of_node] : directions) {
    for (auto const& direction : of_node) {
      for (double t : sample_times_) {
        auto& largest = mine[direction.condition];
        largest = std::max(
          largest, std::abs(conditions_[direction.condition].velocity(owned_vertices_[node], t)));
      }
    }
  }
  return maxOverRanks(mine, communicator);
}

template <int Dim>
void Constraints<Dim>::constrain(DofMap const& dofs, int node,
                                 std::vector<Direction> const& directions)
{
  const int components = frames_.components();
  NodalBasis prescribed;
  for (auto const& [vector, condition, velocity] : directions) {
    Terms terms = velocity;
    if (conditions_[condition].prescribes() && !prescribed.add(vector, terms)) {
      requireAgreement(node, condition, terms);
    }
  }
  auto const basis = makeFrame(node, directions, prescribed);
  const int turn = turnAt(directions);
  auto const frame = frameFrom(basis.vectors(), components, turn);

  bool along_axes = turn == 0 || (frame[0] >= 0 && frame[1] >= 0); // the tangent
  for (auto const& vector : basis.vectors()) {
    along_axes = along_axes && axisOf(vector) >= 0;
  }
  if (!along_axes) {
    frames_.set(node, frame);
  }
  for (int k = 0; k < basis.size(); ++k) {
    if (basis.velocity(k).empty()) {
      continue;
    }
    const int axis = axisOf(basis.vectors()[k]);
    const int row = along_axes ? axis : components - 1 - k;
    FixedRow fixed{dofs.dof(node, row), node, basis.velocity(k)};
    if (along_axes && basis.vectors()[k][axis] < 0) {
      for (auto& term : fixed.terms) {
        term.second = -term.second;
      }
    }
    held_flags_[fixed.dof] = 1;
    rows_.push_back(fixed);
  }
}

template <int Dim>
void Constraints<Dim>::holdNodes(DofMap const& dofs)
{
  for (int node : frames_.vertexTerms().heldNodes()) {
    for (int c = 0; c < dofs.components(); ++c) {
      held_flags_[dofs.dof(node, c)] = 1;
    }
  }
}

// The first condition that prescribes a velocity neither along nor across one of the directions. If
// none is found because of rounding, it is the first condition that prescribes a velocity.
template <int Dim>
int Constraints<Dim>::obliqueCondition(std::vector<Direction> const& directions,
                                       std::vector<std::vector<double>> const& to) const
{
  auto const is_oblique = [&](Direction const& direction) {
    return conditions_[direction.condition].prescribes() &&
           std::any_of(to.begin(), to.end(), [&direction](auto const& vector) {
             const double share = std::abs(detail::dot(direction.vector, vector));
             return share >= detail::parallel && 1 - share >= detail::parallel;
           });
  };
  auto const found = std::find_if(directions.begin(), directions.end(), is_oblique);
  if (found != directions.end()) {
    return found->condition;
  }
  auto const first =
    std::find_if(directions.begin(), directions.end(), [this](auto const& direction) {
      return conditions_[direction.condition].prescribes();
    });
  return first->condition;
}

// The turn for the first direction of makeFrame().
template <int Dim>
int Constraints<Dim>::turnAt(std::vector<Direction> const& directions) const
{
  if (directions.empty()) {
    return 0;
  }
  const auto is_free = [&](Direction const& one) {
    return !conditions_[one.condition].prescribes();
  };
  const auto free = std::find_if(directions.begin(), directions.end(), is_free);
  auto const& first =
    conditions_[(free != directions.end() ? *free : directions.front()).condition];
  return first.isTurned() ? 0 : first.turn;
}

// The directions that a node's frame follows, each with its prescribed velocity; a free direction
// has none.
template <int Dim>
NodalBasis Constraints<Dim>::makeFrame(int node, std::vector<Direction> const& directions,
                                       NodalBasis const& prescribed) const
{
  NodalBasis basis;
  int of_frame = -1;
  for (auto const& [vector, condition, velocity] : directions) {
    Terms none;
    if (!conditions_[condition].prescribes() && basis.add(vector, none)) {
      of_frame = condition;
    }
  }
  if (of_frame < 0) {
    basis = prescribed;
    basis.orient(turnAt(directions));
    return basis;
  }
  auto const free = basis.vectors();
  for (auto const& vector : prescribed.vectors()) {
    Terms none;
    basis.add(vector, none);
  }
  for (int k = 0; k < basis.size(); ++k) {
    auto const& vector = basis.vectors()[k];
    const double share = prescribed.share(vector);
    if (share < detail::parallel) {
      continue;
    }
    ASPERITY_REQUIRE(std::abs(share - 1) < detail::parallel,
                     conditions_[obliqueCondition(directions, free)].name
                       << " prescribes a velocity neither along nor across the boundary '"
                       << conditions_[of_frame].boundary << "' at "
                       << "x = " << mesh::text(owned_vertices_[node]) << ", where "
                       << conditions_[of_frame].name
                       << " leaves the body free to move across it. Prescribe the velocity along "
                          "or across it there, or in both directions.");
    basis.setVelocity(k, prescribed.velocityAlong(vector));
  }
  basis.orient(turnAt(directions));
  return basis;
}

template <int Dim>
void Constraints<Dim>::requireAgreement(int node, int condition, Terms const& terms) const
{
  auto const& x = owned_vertices_[node];
  for (double t : sample_times_) {
    double difference = 0;
    double scale = 0;
    for (auto const& [other, coefficient] : terms) {
      difference += coefficient * conditions_[other].velocity(x, t);
      scale = std::max(scale, std::abs(coefficient) * largest_[other]);
    }
    int first = condition;
    for (auto const& [other, coefficient] : terms) {
      first = other != condition ? other : first;
    }
    ASPERITY_REQUIRE(std::abs(difference) <= 1e-10 * scale,
                     conditions_[condition].name
                       << " (boundary '" << conditions_[condition].boundary << "') contradicts "
                       << conditions_[first].name << " (boundary '" << conditions_[first].boundary
                       << "') at "
                       << "x = " << mesh::text(x) << ", t = " << t
                       << " s: both prescribe the velocity in the same direction, and the values "
                          "differ by "
                       << difference << " m/s. Remove one of them.");
  }
}

template <int Dim>
void Constraints<Dim>::prescribedVelocity(double t, Vector& v) const
{
  std::vector<double> values;
  for (auto const& row : rows_) {
    values.push_back(velocity(row, t));
  }
  v.putScalar(0);
  set(v, constant_dofs_, constant_velocities_);
  set(v, dofs_of_rows_, toDevice(values, "asperity::fem::prescribedValues"));
}

template <int Dim>
bool Constraints<Dim>::dependsOnTime(FixedRow const& row) const
{
  return std::any_of(row.terms.begin(), row.terms.end(),
                     [&](auto const& term) { return conditions_[term.first].dependsOnTime(); });
}

template <int Dim>
double Constraints<Dim>::velocity(FixedRow const& row, double t) const
{
  double sum = 0;
  for (auto const& [condition, coefficient] : row.terms) {
    sum += coefficient * conditions_[condition].velocity(owned_vertices_[row.node], t);
  }
  return sum;
}

// Keeps the velocities that do not depend on time there, so that a step copies the others alone.
template <int Dim>
void Constraints<Dim>::moveToDevice()
{
  auto const first_constant = std::stable_partition(
    rows_.begin(), rows_.end(), [&](FixedRow const& row) { return dependsOnTime(row); });
  std::vector<int> dofs;
  std::vector<double> velocities;
  for (auto row = first_constant; row != rows_.end(); ++row) {
    dofs.push_back(row->dof);
    velocities.push_back(velocity(*row, 0));
  }
  constant_dofs_ = toDevice(dofs, "asperity::fem::constantDofs");
  constant_velocities_ = toDevice(velocities, "asperity::fem::constantVelocities");
  rows_.erase(first_constant, rows_.end());
  dofs_of_rows_ = toDevice(dofsThatVary(), "asperity::fem::dofsThatVary");
}

template <int Dim>
std::vector<int> Constraints<Dim>::dofsThatVary() const
{
  std::vector<int> result;
  for (auto const& row : rows_) {
    result.push_back(row.dof);
  }
  return result;
}

template <int Dim>
void Constraints<Dim>::shareWithGhosts(DofMap const& dofs)
{
  const int components = dofs.components();
  // The vectors have one column for each column of the frames, and one more for the flags.
  MultiVector owned(dofs.owned(), components + 1);
  MultiVector local(dofs.overlap(), components + 1);
  {
    auto values = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < dofs.numOwnedNodes(); ++node) {
      for (int r = 0; r < components; ++r) {
        for (int c = 0; c < components; ++c) {
          values(dofs.dof(node, r), c) = frames_.entry(node, r, c);
        }
        values(dofs.dof(node, r), components) = held_flags_[dofs.dof(node, r)];
      }
    }
  }
  dofs.shareWithGhosts(owned, local);
  auto const values = local.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int node = dofs.numOwnedNodes(); node < dofs.numLocalNodes(); ++node) {
    NodalFrames::Matrix frame{};
    for (int r = 0; r < components; ++r) {
      for (int c = 0; c < components; ++c) {
        frame[r * components + c] = values(dofs.dof(node, r), c);
      }
      held_flags_[dofs.dof(node, r)] = values(dofs.dof(node, r), components) != 0;
    }
    frames_.set(node, frame);
  }
}

template class Constraints<2>;
template class Constraints<3>;
} // namespace asperity::fem
