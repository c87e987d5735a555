#include "base/Errors.hpp"
#include "dynamics/condensation/StaticCondensation.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <functional>
#include <numeric>

// The condensed model of StaticCondensation.
namespace asperity::dynamics
{
namespace
{
// The given columns of each row, and its diagonal.
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
  // visit(column, value) for the entries of a row of F in columns that move, and on the diagonal
  const auto visitRow = [&](int row, auto const& visit) {
    for (auto k = C.graph.row_map(kept_[row]); k < C.graph.row_map(kept_[row] + 1); ++k) {
      const int column = place_[C.graph.entries(k)];
      if (column >= 0 && (moves_[column] || column == row)) {
        visit(column, C.values(k));
      }
    }
  };
  auto const matrix = zeroMatrix(graphOf(map, [&](int row) {
    std::vector<int> columns;
    if (row < numKept()) {
      visitRow(row, [&](int column, double value) {
        if (value != 0 && column != row) {
          columns.push_back(column);
        }
      });
    }
    return columns;
  }));
  for (int row = 0; row < numKept(); ++row) {
    visitRow(row, [&](int column, double value) { add(*matrix, row, column, value); });
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
  return gather(whole_.initial, body, amplitudesAt(0));
}

ReactionSinceStart StaticCondensation::condensedReaction(ReactionSinceStart const& of_whole,
                                                         Body const& body) const
{
  auto const& reaction = of_whole.reaction;
  if (!reaction) {
    return {};
  }
  auto dofs = reaction->dofs();
  for (int& dof : dofs) {
    dof = place_[dof];
  }
  return {std::make_shared<NormalReaction>(*reaction, body, dofs), of_whole.at_start};
}

void StaticCondensation::condense()
{
  auto const body = condensedBody();
  auto const& fault = whole_.fault;
  model_ = std::make_unique<Model>(
    Model{body, Fault(condensedSurface(body.held), fault.laws(), fault.normalStress()),
          condensedState(body), condensedReaction(whole_.reaction, body)});
}
} // namespace asperity::dynamics
