#include "tnnmg/direct/SchurComplement.hpp"

#include "ElasticModel.hpp"
#include "unit/base/Refusal.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace asperity::tnnmg
{
using namespace tnnmg::test;

namespace
{
ElasticModel modelOf(int components = 2, int tangents = 1)
{
  ElasticModelOptions options;
  options.cells_x = 14;
  options.cells_y = 5;
  options.tau = 1;
  options.components = components;
  options.tangents = tangents;
  return ElasticModel(options);
}

std::vector<int> faultRows(ElasticModel const& model)
{
  std::vector<int> rows;
  for (auto const& dofs : model.nonlinear) {
    rows.insert(rows.end(), dofs.begin(), dofs.end());
  }
  return rows;
}

std::vector<int> otherRows(ElasticModel const& model, std::vector<int> const& rows)
{
  std::vector<int> others;
  for (int row = 0; row < model.global.rows(); ++row) {
    if (std::find(rows.begin(), rows.end(), row) == rows.end()) {
      others.push_back(row);
    }
  }
  return others;
}

Eigen::MatrixXd dense(ConstBlockView const& S)
{
  const auto host = toHost(S);
  return Eigen::Map<const Eigen::MatrixXd>(host.data(), host.extent_int(0), host.extent_int(1));
}

Eigen::VectorXd valuesOf(Vector const& x)
{
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  return Eigen::Map<const Eigen::VectorXd>(view.data(), view.extent(0));
}

Eigen::VectorXd expanded(CondensedRightSide const& b, ElasticModel const& model,
                         Eigen::VectorXd const& kept)
{
  Vector from(b.kept().getMap());
  for (int i = 0; i < kept.size(); ++i) {
    from.replaceLocalValue(i, kept(i));
  }
  Vector result(model.map);
  b.expand(from, result);
  return model.gather(result);
}

void checkAgainstDense(ElasticModel const& model, std::vector<int> const& rows)
{
  const Eigen::MatrixXd Z = model.global;
  const auto others = otherRows(model, rows);
  const SchurComplement schur(*model.Z, rows);
  const Eigen::LLT<Eigen::MatrixXd> inner(Z(others, others));
  const Eigen::MatrixXd S = Z(rows, rows) - Z(rows, others) * inner.solve(Z(others, rows));
  EXPECT_LE((dense(schur.matrix()) - S).norm(), 1e-13 * Z.norm());
  EXPECT_EQ(dense(schur.matrix()), dense(schur.matrix()).transpose());

  // S v = b_F - Z_FI Z_II^-1 b_I and its expansion solve Z v = b, for two b at the same time.
  const auto size = static_cast<int>(Z.rows());
  const Eigen::VectorXd bs[] = {pseudorandomVector(size, 1), pseudorandomVector(size, 2)};
  const CondensedRightSide condensed[] = {schur.condense(model.scatter(bs[0])),
                                          schur.condense(model.scatter(bs[1]))};
  for (int i : {0, 1}) {
    const Eigen::VectorXd kept = S.llt().solve(valuesOf(condensed[i].kept()));
    const Eigen::VectorXd v = expanded(condensed[i], model, kept);
    const Eigen::VectorXd exact = Z.llt().solve(bs[i]);
    EXPECT_LE((v - exact).norm(), 1e-11 * exact.norm());
  }
}
} // namespace

TEST(SchurComplement, MeetsDenseEliminationOfTheFault)
{
  for (auto const& [components, tangents] : {std::pair(1, 1), {2, 1}, {2, 2}}) {
    const auto model = modelOf(components, tangents);
    checkAgainstDense(model, faultRows(model));
  }
}

TEST(SchurComplement, KeepsRowsInTheOrderTheyAreGiven)
{
  const auto model = modelOf();
  auto rows = faultRows(model);
  std::reverse(rows.begin(), rows.end());
  std::swap(rows[2], rows[7]);
  checkAgainstDense(model, rows);
  checkAgainstDense(model, {37});
}

TEST(SchurComplement, EliminatesAllOrNothing)
{
  const auto model = modelOf(1, 1);
  const int size = static_cast<int>(model.global.rows());
  const SchurComplement everything(*model.Z, {});
  const auto b = pseudorandomVector(size, 3);
  const auto condensed = everything.condense(model.scatter(b));
  EXPECT_EQ(condensed.kept().getGlobalLength(), 0U);
  const Eigen::VectorXd v = expanded(condensed, model, Eigen::VectorXd(0));
  EXPECT_LE((model.global * v - b).norm(), 1e-12 * model.global.norm() * v.norm());

  std::vector<int> all(size);
  for (int row = 0; row < size; ++row) {
    all[row] = row;
  }
  checkAgainstDense(model, all);
}

// Values that do not solve S v = b: the other dofs still minimise.
TEST(SchurComplement, ExpandsAnyValuesByTheMinimiserOfTheOthers)
{
  const auto model = modelOf();
  const auto rows = faultRows(model);
  const SchurComplement schur(*model.Z, rows);
  const auto b = pseudorandomVector(static_cast<int>(model.global.rows()), 4);
  const auto kept = pseudorandomVector(static_cast<int>(rows.size()), 5);
  const Eigen::VectorXd v = expanded(schur.condense(model.scatter(b)), model, kept);
  const Eigen::VectorXd residual = b - model.global * v;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(v(rows[i]), kept(i));
  }
  for (int row : otherRows(model, rows)) {
    EXPECT_NEAR(residual(row), 0, 1e-11 * model.global.norm() * v.norm());
  }
}

TEST(SchurComplement, CountsWhatItStores)
{
  const auto model = modelOf();
  const SchurComplement schur(*model.Z, faultRows(model));
  const auto size = static_cast<std::size_t>(model.global.rows());
  EXPECT_GE(schur.factorEntries(), (model.global.nonZeros() - size) / 4);
  EXPECT_LE(schur.factorEntries(), size * (size + 1) / 2);
  EXPECT_GE(schur.bytes(), 8 * schur.factorEntries());
}

TEST(SchurComplement, RefusesAMatrixThatIsNotDefinite)
{
  const auto model = modelOf();
  const auto rows = faultRows(model);
  for (int row : {rows[3], otherRows(model, rows)[11]}) {
    CrsMatrix broken(*model.Z, Teuchos::Copy);
    broken.resumeFill();
    const double value = -1;
    broken.replaceLocalValues(row, 1, &value, &row);
    broken.fillComplete();
    SCOPED_TRACE(row);
    asperity::test::expectRefusal<SolveError>([&] { SchurComplement(broken, rows); },
                                              {"not positive definite"});
  }
}
// To the last bit, whichever matrix was first: a restart sets other step sizes up first.
TEST(SchurComplement, TakesTheOrderOfAMatrixWithTheSameEntries)
{
  const auto model = modelOf();
  const auto rows = faultRows(model);
  CrsMatrix other(*model.Z, Teuchos::Copy);
  other.resumeFill();
  other.scale(3);
  other.fillComplete();
  EliminationOrder order;
  const SchurComplement first(other, rows, order);
  const SchurComplement shared(*model.Z, rows, order), alone(*model.Z, rows);
  EXPECT_EQ(shared.factorEntries(), alone.factorEntries());
  EXPECT_EQ(dense(shared.matrix()), dense(alone.matrix()));
  // Another set of rows asks for another order.
  const SchurComplement reversed(*model.Z, {rows.rbegin(), rows.rend()}, order);
  EXPECT_NEAR(dense(reversed.matrix())(0, 0), dense(alone.matrix()).bottomRightCorner(1, 1)(0, 0),
              1e-12 * dense(alone.matrix()).norm());
}

TEST(EliminationOrder, KnowsItsMatrixAgain)
{
  // A path 0 - 1 - 2 - 3 - 4, and one whose ends meet.
  EliminationOrder order;
  const EliminationOrder::Pattern path{{0, 2, 5, 8, 11, 13},
                                       {0, 1, 0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4}};
  auto const* const where = order.positions(path, {2}).data();
  EXPECT_EQ(order.positions(path, {2}).data(), where) << "found anew";
  EXPECT_EQ(order.positions(path, {2})[2], 4);
  EXPECT_EQ(order.positions(path, {4, 0})[4], 3);
  EXPECT_EQ(order.positions(path, {4, 0})[0], 4);
  auto positions = order.positions(path, {});
  std::sort(positions.begin(), positions.end());
  EXPECT_EQ(positions, (std::vector<int>{0, 1, 2, 3, 4}));
}
} // namespace asperity::tnnmg
