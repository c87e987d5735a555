#include "dynamics/condensation/StaticCondensation.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <cmath>
#include <functional>
#include <numeric>

namespace asperity::dynamics
{
namespace
{
// Unbalanced forces of at most this share of the largest forces count as rounding.
constexpr double rounding = 1e-9;

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

// The given columns of each row and its diagonal.
RCP<const CrsGraph> graphOf(RCP<const Map> const& map,
                            std::function<std::vector<int>(int)> const& columnsOf)
{
  const int size = static_cast<int>(numLocalElements(*map));
  auto const graph = rcp(new CrsGraph(map, map, size));
  for (int row = 0; row < size; ++row) {
    auto columns = columnsOf(row);
    columns.push_back(row);
    graph->insertLocalIndices(row, static_cast<int>(columns.size()), columns.data());
  }
  graph->fillComplete();
  return graph;
}

RCP<CrsMatrix> zeroMatrix(RCP<const CrsGraph> const& graph)
{
  auto const matrix = rcp(new CrsMatrix(graph));
  matrix->setAllToScalar(0);
  return matrix;
}

// Adds to an entry, which the graph of the matrix must have unless the value is zero.
void add(CrsMatrix& matrix, int row, int column, double value)
{
  if (value != 0) {
    ASPERITY_ASSERT(matrix.sumIntoLocalValues(row, 1, &value, &column) == 1);
  }
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
      *fem::combine(body.matrices, fem::ofElasticity(body.matrices),
                    fem::HeldDofs(flags, body.numOwnedDofs())),
      kept_);
  } catch (SolveError const&) {
    return false;
  }

  body.prescribed_velocity(0, *pattern_);
  Vector forces(pattern_->getMap());
  {
    auto const values = pattern_->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (int i = 0; i < numKept(); ++i) {
      moves_[i] = !body.held[kept_[i]] || values(kept_[i], 0) != 0;
      values(kept_[i], 0) = 0;
    }
    for (auto const& node : whole_.fault.surface()) {
      for (int dof : node.dofs) {
        moves_[place_[dof]] = true;
      }
    }
  }
  is_driven_ = pattern_->normInf() > 0;
  body.matrices.stiffness->apply(*pattern_, forces, Teuchos::NO_TRANS, -1, 0);
  body.clearHeld(forces);
  Vector inside(pattern_->getMap());
  factor_->condense(forces).expand(Vector(factor_->map()), inside);
  pattern_->update(1, inside, 1);
  no_forces_ =
    std::make_unique<tnnmg::CondensedRightSide>(factor_->condense(Vector(pattern_->getMap())));
  return isInEquilibrium(*pattern_);
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
  return rest <= rounding * largest;
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

// The Schur complement S at F; in the row and column of s, K P at F and P'KP. The other dofs of the
// last vertex have no stiffness. Columns of dofs that never move are left out: half of all in plane
// strain.
RCP<const CrsMatrix> StaticCondensation::condensedStiffness(RCP<const Map> const& map) const
{
  Vector forces(pattern_->getMap());
  whole_.body.matrices.stiffness->apply(*pattern_, forces);
  const double of_pattern = pattern_->dot(forces);
  auto const at = forces.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const S = toHost(factor_->matrix());
  const int s = numKept();
  std::vector<int> moving;
  for (int i = 0; i < s; ++i) {
    if (moves_[i]) {
      moving.push_back(i);
    }
  }
  moving.push_back(s);
  const std::vector<int> none;
  auto const matrix = zeroMatrix(graphOf(map, [&](int row) { return row <= s ? moving : none; }));
  for (int row = 0; row < s; ++row) {
    for (int column = 0; column < s; ++column) {
      if (moves_[column] || column == row) {
        add(*matrix, row, column, S(row, column));
      }
    }
    add(*matrix, row, s, at(kept_[row], 0));
    if (moves_[row]) {
      add(*matrix, s, row, at(kept_[row], 0));
    }
  }
  add(*matrix, s, s, of_pattern);
  matrix->fillComplete();
  return matrix;
}

RCP<const CrsMatrix> StaticCondensation::condensedViscosity(RCP<const Map> const& map) const
{
  auto const C = whole_.body.matrices.viscosity->getLocalMatrixHost();
  auto const coupled = graphOf(map, [&](int row) {
    std::vector<int> columns;
    for (auto k = row < numKept() ? C.graph.row_map(kept_[row]) : 0;
         row < numKept() && k < C.graph.row_map(kept_[row] + 1); ++k) {
      const int column = place_[C.graph.entries(k)];
      if (column >= 0 && moves_[column] && C.values(k) != 0) {
        columns.push_back(column);
      }
    }
    return columns;
  });
  auto const matrix = zeroMatrix(coupled);
  for (int row = 0; row < numKept(); ++row) {
    for (auto k = C.graph.row_map(kept_[row]); k < C.graph.row_map(kept_[row] + 1); ++k) {
      const int column = place_[C.graph.entries(k)];
      if (column >= 0 && (moves_[column] || column == row)) {
        add(*matrix, row, column, C.values(k));
      }
    }
  }
  matrix->fillComplete();
  return matrix;
}

fem::HeldDofs StaticCondensation::condensedHeld(int num_dofs) const
{
  std::vector<int> flags(num_dofs, 1);
  for (int i = 0; i < numKept(); ++i) {
    flags[i] = whole_.body.held[kept_[i]] ? 1 : 0;
  }
  return {flags, num_dofs};
}

Body StaticCondensation::condensedBody() const
{
  const int components = whole_.body.dofs->components();
  const int num_nodes = numKept() / components + 1;
  std::vector<GlobalOrdinal> ids(num_nodes);
  std::iota(ids.begin(), ids.end(), 0);
  auto const dofs =
    std::make_shared<fem::DofMap>(ids, num_nodes, components, whole_.body.dofs->communicator());
  auto const mass = zeroMatrix(graphOf(dofs->owned(), [](int) { return std::vector<int>(); }));
  mass->fillComplete();
  auto const work = whole_.body.vector();
  const double rate = is_driven_ ? 1 : 0;
  return {dofs,
          {mass, condensedViscosity(dofs->owned()), condensedStiffness(dofs->owned()), true, {}},
          condensedHeld(num_nodes * components),
          Teuchos::null,
          [this, work](double t, Vector& load) {
            whole_.body.load(t, *work);
            gather(*work, load);
          },
          [this, work, rate](double t, Vector& v) {
            whole_.body.prescribed_velocity(t, *work);
            gather(*work, v);
            v.replaceLocalValue(numKept(), rate);
          }};
}

std::shared_ptr<const fem::FaultSurface>
StaticCondensation::condensedSurface(fem::HeldDofs const& held) const
{
  auto const& surface = whole_.fault.surface();
  std::vector<fem::FaultNode> nodes;
  std::vector<double> rates;
  for (int i = 0; i < surface.numNodes(); ++i) {
    auto node = surface[i];
    node.copies = {i};
    for (int& dof : node.dofs) {
      dof = place_[dof];
    }
    for (int k = 0; k < surface.numTangents(); ++k) {
      rates.push_back(surface.plateRate(i, k));
    }
    nodes.push_back(std::move(node));
  }
  auto const result = std::make_shared<fem::FaultSurface>(
    surface.name(), std::move(nodes), surface.numTangents(), held, surface.colours(),
    surface.otherSide(), surface.communicator());
  return surface.hasPlateRate() ? result->withPlateRate(rates) : result;
}

State StaticCondensation::condensedState(Body const& body) const
{
  auto const prescribed = body.vector();
  body.prescribed_velocity(0, *prescribed);
  return gather(whole_.initial, body, {0, prescribed->getData()[numKept()], 0, 0});
}

ReactionSinceStart StaticCondensation::condensedReaction(Body const& body) const
{
  auto const& reaction = whole_.reaction.reaction;
  if (!reaction) {
    return {};
  }
  auto dofs = reaction->dofs();
  for (int& dof : dofs) {
    dof = place_[dof];
  }
  return {std::make_shared<NormalReaction>(*reaction, body, dofs), whole_.reaction.at_start};
}

void StaticCondensation::condense()
{
  auto const body = condensedBody();
  auto const& fault = whole_.fault;
  model_ = std::make_unique<Model>(
    Model{body, Fault(condensedSurface(body.held), fault.laws(), fault.normalStress()),
          condensedState(body), condensedReaction(body)});
}
} // namespace asperity::dynamics
