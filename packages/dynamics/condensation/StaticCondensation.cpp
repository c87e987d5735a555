#include "dynamics/condensation/StaticCondensation.hpp"

#include "base/Errors.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::dynamics
{
namespace
{
// Unbalanced forces of at most this share of the largest forces count as rounding.
constexpr double unbalanced_share = 1e-9;

// All dofs at the vertices of the fault.
std::vector<int> dofsOfFault(fem::FaultSurface const& surface, fem::DofMap const& dofs)
{
  std::vector<int> result;
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int c = 0; c < dofs.components(); ++c) {
      result.push_back(dofs.dof(surface.vertex(node), c));
    }
  }
  return result;
}
} // namespace

StaticCondensation::~StaticCondensation() = default;

StaticCondensation::StaticCondensation(Model const& whole)
    : whole_(whole)
    , kept_(dofsOfFault(whole.fault.surface(), *whole.body.dofs))
    , place_(whole.body.numOwnedDofs(), -1)
    , moves_(kept_.size(), true)
    , pattern_(whole.body.vector())
{
  for (int i = 0; i < numKept(); ++i) {
    place_[kept_[i]] = i;
  }
}

std::unique_ptr<StaticCondensation> StaticCondensation::make(Model const& whole)
{
  ASPERITY_ASSERT(whole.body.dofs->communicator()->getSize() == 1);
  std::unique_ptr<StaticCondensation> result(new StaticCondensation(whole));
  const bool is_exact = whole.body.matrices.is_massless && whole.body.matrices.branches.empty() &&
                        whole.initial.u->normInf() == 0 &&
                        result->isFaultAlone(*whole.body.matrices.viscosity) &&
                        result->findPattern() && result->balancesMotionOfFault();
  if (!is_exact) {
    return nullptr;
  }
  result->condense();
  return result;
}

bool StaticCondensation::isFaultAlone(CrsMatrix const& viscosity) const
{
  auto const C = viscosity.getLocalMatrixHost();
  for (int row = 0; row < C.numRows(); ++row) {
    for (auto k = C.graph.row_map(row); k < C.graph.row_map(row + 1); ++k) {
      const bool at_fault = place_[row] >= 0 && place_[C.graph.entries(k)] >= 0;
      if (!at_fault && C.values(k) != 0) {
        return false;
      }
    }
  }
  return true;
}

// Computes the factor and P. False if the body can move without resistance while its fault rests.
bool StaticCondensation::findPattern()
{
  if (!factorise()) {
    return false;
  }
  auto const& body = whole_.body;
  body.prescribed_velocity(0, *pattern_);
  noteMovingDofs(*pattern_);
  {
    auto const values = pattern_->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (int dof : kept_) {
      values(dof, 0) = 0;
    }
  }
  is_driven_ = pattern_->normInf() > 0;
  Vector forces(pattern_->getMap()), inside(pattern_->getMap());
  body.matrices.stiffness->apply(*pattern_, forces, Teuchos::NO_TRANS, -1, 0);
  body.clearHeld(forces);
  factor_->condense(forces).expand(Vector(factor_->map()), inside);
  pattern_->update(1, inside, 1);
  no_forces_ =
    std::make_unique<tnnmg::CondensedRightSide>(factor_->condense(Vector(pattern_->getMap())));
  return isInEquilibrium(*pattern_);
}

// False if K without the rows and columns of D is singular.
bool StaticCondensation::factorise()
{
  auto const& body = whole_.body;
  auto const K = body.matrices.stiffness->getLocalMatrixHost();
  auto flags = body.held.flags();
  for (int dof : kept_) {
    double stiffness = 0;
    for (auto k = K.graph.row_map(dof); k < K.graph.row_map(dof + 1); ++k) {
      stiffness = std::max(stiffness, std::abs(K.values(k)));
    }
    // The jump at a tip of a fault belongs to no cell and has no stiffness: it is held at rest.
    flags[dof] = stiffness == 0 ? 1 : 0;
  }
  try {
    factor_ = std::make_unique<tnnmg::SchurComplement>(
      *fem::combine(body.matrices, fem::elasticityWeights(body.matrices),
                    fem::HeldDofs(flags, body.numOwnedDofs())),
      kept_);
  } catch (SolveError const&) {
    return false;
  }
  return true;
}

// A dof of F moves if it is not held or has a prescribed velocity. A tangential dof always counts,
// since its prescribed velocity may change in time.
void StaticCondensation::noteMovingDofs(Vector const& prescribed_velocity)
{
  auto const values = prescribed_velocity.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int i = 0; i < numKept(); ++i) {
    moves_[i] = !whole_.body.held[kept_[i]] || values(kept_[i], 0) != 0;
  }
  for (auto const& node : whole_.fault.surface()) {
    for (int dof : node.dofs) {
      moves_[place_[dof]] = true;
    }
  }
}

// Whether K u vanishes at I, compared with the sums of the magnitudes of its terms.
bool StaticCondensation::isInEquilibrium(Vector const& u) const
{
  auto const K = whole_.body.matrices.stiffness->getLocalMatrixHost();
  auto const values = u.getLocalViewHost(Tpetra::Access::ReadOnly);
  double largest = 0;
  double rest = 0;
  for (int row = 0; row < K.numRows(); ++row) {
    double sum = 0;
    double magnitude = 0;
    for (auto k = K.graph.row_map(row); k < K.graph.row_map(row + 1); ++k) {
      const double force = K.values(k) * values(K.graph.entries(k), 0);
      sum += force;
      magnitude += std::abs(force);
    }
    largest = std::max(largest, magnitude);
    if (place_[row] < 0 && !whole_.body.held[row]) {
      rest = std::max(rest, std::abs(sum));
    }
  }
  return rest <= unbalanced_share * largest;
}

// Tests one motion, in which all dofs of the fault take part.
bool StaticCondensation::balancesMotionOfFault() const
{
  Vector x(factor_->map());
  {
    auto const values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int i = 0; i < numKept(); ++i) {
      values(i, 0) = std::cos(i);
    }
  }
  Vector u(pattern_->getMap());
  no_forces_->expand(x, u);
  return isInEquilibrium(u);
}

int StaticCondensation::numEliminated() const { return whole_.body.numOwnedDofs() - numKept(); }

void StaticCondensation::expand(Vector const& x, Vector& whole) const
{
  Vector at_fault(factor_->map());
  double s = 0;
  {
    auto const from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    auto const to = at_fault.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int i = 0; i < numKept(); ++i) {
      to(i, 0) = from(i, 0);
    }
    s = from(numKept(), 0);
  }
  no_forces_->expand(at_fault, whole);
  whole.update(s, *pattern_, 1);
}

// Z is symmetric, so that the unit vector's forces on F are -K_FI K_II^-1 e, a row of E.
std::vector<double> StaticCondensation::recoveryRow(int dof) const
{
  Vector unit(pattern_->getMap());
  unit.replaceLocalValue(dof, 1);
  auto const condensed = factor_->condense(unit);
  std::vector<double> row(whole_.body.dofs->components() + numKept(), 0.);
  {
    auto const values = condensed.kept().getLocalViewHost(Tpetra::Access::ReadOnly);
    std::copy_n(values.data(), numKept(), row.begin());
  }
  row[numKept()] = pattern_->getLocalViewHost(Tpetra::Access::ReadOnly)(dof, 0);
  return row;
}

std::size_t StaticCondensation::factorEntries() const { return factor_->factorEntries(); }

void StaticCondensation::gather(Vector const& whole, Vector& x) const
{
  auto const from = whole.getLocalViewHost(Tpetra::Access::ReadOnly);
  x.putScalar(0);
  auto const to = x.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int i = 0; i < numKept(); ++i) {
    to(i, 0) = from(kept_[i], 0);
  }
}

State StaticCondensation::expand(State const& state) const
{
  State whole = state.clone();
  State::visitBody(
    [&](FieldInfo const&, auto const& from, auto& to) {
      to = whole_.body.vector();
      expand(*from, *to);
    },
    state, whole);
  return whole;
}

State StaticCondensation::gather(State const& whole, Amplitudes const& boundary_amplitudes) const
{
  return gather(whole, model_->body, boundary_amplitudes);
}

State StaticCondensation::gather(State const& whole, Body const& condensed,
                                 Amplitudes const& boundary_amplitudes) const
{
  ASPERITY_ASSERT(boundary_amplitudes.size() == whole.numBodyFields());
  State state = whole.clone();
  auto amplitude = boundary_amplitudes.begin();
  State::visitBody(
    [&](FieldInfo const&, auto const& from, auto& to) {
      to = condensed.vector();
      gather(*from, *to);
      to->replaceLocalValue(numKept(), *amplitude++);
    },
    whole, state);
  return state;
}

StaticCondensation::Amplitudes StaticCondensation::amplitudes(State const& state) const
{
  Amplitudes result;
  State::visitBody(
    [&](FieldInfo const&, auto const& field) {
      result.push_back(field->getLocalViewHost(Tpetra::Access::ReadOnly)(numKept(), 0));
    },
    state);
  return result;
}

StaticCondensation::Amplitudes StaticCondensation::amplitudesAt(double time) const
{
  const double rate = is_driven_ ? 1 : 0;
  auto const& shape = whole_.initial;
  Amplitudes result;
  State::visitBody(
    [&](FieldInfo const&, auto const& field) {
      result.push_back(&field == &shape.u ? rate * time : &field == &shape.v ? rate : 0);
    },
    shape);
  return result;
}
} // namespace asperity::dynamics
