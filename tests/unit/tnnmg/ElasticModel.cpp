#include "ElasticModel.hpp"

#include "fem/Colouring.hpp"
#include "portability/Renamed.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>

#include <array>
#include <cmath>
#include <random>

namespace asperity::tnnmg::test
{
namespace
{
using Triplets = std::vector<Eigen::Triplet<double>>;
using Corner = std::array<double, 2>;

constexpr double density = 950;         // kg/m^3
constexpr double shear_modulus = 2.3e4; // Pa
constexpr double first_lame = 3.5e4;    // Pa
constexpr double viscosity = 1;         // Pa s

// Gradients (2 x 3) of the barycentric coordinates, and the area.
Eigen::Matrix<double, 2, 3> gradients(std::array<Corner, 3> const& corner, double& area)
{
  Eigen::Matrix2d edges;
  edges << corner[1][0] - corner[0][0], corner[2][0] - corner[0][0], corner[1][1] - corner[0][1],
    corner[2][1] - corner[0][1];
  area = 0.5 * edges.determinant();
  Eigen::Matrix<double, 2, 3> reference;
  reference << -1, 1, 0, -1, 0, 1;
  return edges.inverse().transpose() * reference;
}

// 2/tau M + C + tau/2 K of one triangle; dof = 2 corner + component, or corner if antiplane.
Eigen::MatrixXd cellMatrix(std::array<Corner, 3> const& corner, ElasticModelOptions const& options)
{
  double area = 0;
  const auto gradient = gradients(corner, area);
  const double shear = viscosity + 0.5 * options.tau * shear_modulus;
  const double lame = 0.5 * options.tau * first_lame;
  const double inertia = 2 / options.tau * density;
  const int components = options.components;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * components, 3 * components);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector2d a = gradient.col(i);
      const Eigen::Vector2d b = gradient.col(j);
      Eigen::Matrix2d block = shear * (a.dot(b) * Eigen::Matrix2d::Identity() + b * a.transpose()) +
                              lame * a * b.transpose();
      block =
        components == 1 ? Eigen::Matrix2d(shear * a.dot(b) * Eigen::Matrix2d::Identity()) : block;
      block += inertia * (i == j ? 2.0 : 1.0) / 12 * Eigen::Matrix2d::Identity();
      matrix.block(components * i, components * j, components, components) =
        area * block.topLeftCorner(components, components);
    }
  }
  return matrix;
}

int nodeAt(ElasticModelOptions const& options, int x, int y)
{
  return x * (options.cells_y + 1) + y;
}

void addCell(ElasticModelOptions const& options, std::array<std::array<int, 2>, 3> const& at,
             Triplets& triplets)
{
  const double h = 1.0 / options.cells_x;
  std::array<Corner, 3> corner;
  for (int i = 0; i < 3; ++i) {
    corner[i] = {h * at[i][0], h * at[i][1]};
  }
  const auto cell = cellMatrix(corner, options);
  const int components = options.components;
  const auto dof = [&](int k) {
    auto const& [x, y] = at[k / components];
    return nodeAt(options, x, y) * components + k % components;
  };
  for (int i = 0; i < cell.rows(); ++i) {
    for (int j = 0; j < cell.cols(); ++j) {
      triplets.emplace_back(dof(i), dof(j), cell(i, j));
    }
  }
}

Eigen::SparseMatrix<double> assemble(ElasticModelOptions const& options)
{
  Triplets triplets;
  for (int x = 0; x < options.cells_x; ++x) {
    for (int y = 0; y < options.cells_y; ++y) {
      addCell(options, {{{x, y}, {x + 1, y}, {x + 1, y + 1}}}, triplets);
      addCell(options, {{{x, y}, {x + 1, y + 1}, {x, y + 1}}}, triplets);
    }
  }
  const int size = (options.cells_x + 1) * (options.cells_y + 1) * options.components;
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

// What is left of an elastic body is one of two scalars: still symmetric positive definite.
void decoupleComponents(Eigen::SparseMatrix<double>& matrix)
{
  for (int column = 0; column < matrix.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
      entry.valueRef() = (entry.row() - column) % 2 == 0 ? entry.value() : 0;
    }
  }
}

RCP<const Map> makeMap(int num_nodes, int components)
{
  const RCP<const Communicator> comm = rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  const int rank = comm->getRank();
  const int ranks = comm->getSize();
  const int begin = num_nodes * rank / ranks;
  const int end = num_nodes * (rank + 1) / ranks;
  return rcp(new Map(num_nodes * components, (end - begin) * components, 0, comm));
}

RCP<const CrsMatrix> spread(Eigen::SparseMatrix<double> const& matrix, RCP<const Map> const& map)
{
  const auto result = rcp(new CrsMatrix(map, 20));
  for (int column = 0; column < matrix.outerSize(); ++column) { // symmetric: columns are rows
    if (!map->isNodeGlobalElement(column)) {
      continue;
    }
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
      const GlobalOrdinal other = entry.row();
      const double value = entry.value();
      result->insertGlobalValues(column, 1, &value, &other);
    }
  }
  result->fillComplete();
  return result;
}

RCP<const MultiVector> rigidMotions(ElasticModelOptions const& options, RCP<const Map> const& map)
{
  const auto result = rcp(new MultiVector(map, options.components == 1 ? 1 : 3));
  const double h = 1.0 / options.cells_x;
  for (std::size_t row = 0; row < numLocalElements(*map); ++row) {
    const auto dof = static_cast<int>(map->getGlobalElement(static_cast<int>(row)));
    const int node = dof / options.components;
    const int component = dof % options.components;
    const int column = node / (options.cells_y + 1);
    const double x = h * column;
    const double y = h * (node % (options.cells_y + 1));
    result->replaceLocalValue(static_cast<int>(row), component, 1.0);
    if (options.components == 2) {
      result->replaceLocalValue(static_cast<int>(row), 2, component == 0 ? -y : x);
    }
  }
  return result;
}
} // namespace

ElasticModel::ElasticModel(ElasticModelOptions const& given)
    : options(given)
    , global(assemble(given))
{
  if (!options.components_are_coupled) {
    decoupleComponents(global);
  }
  chooseRows();
  map = makeMap(static_cast<int>(global.rows()) / options.components, options.components);
  Z = spread(global, map);
  near_null_space = rigidMotions(options, map);
  makeViews();
}

// Who is held, who is nonlinear; and holds.
void ElasticModel::chooseRows()
{
  std::vector<bool> held(global.rows(), false);
  for (int k = 0; k < (options.cells_y + 1) * options.components; ++k) {
    held[nodeAt(options, options.cells_x, 0) * options.components + k] = true;
  }
  for (int x = 0; x < options.cells_x; ++x) {
    nonlinear.emplace_back();
    for (int c = 0; c < options.components; ++c) {
      const int row = nodeAt(options, x, 0) * options.components + c;
      if (c < options.tangents) {
        nonlinear.back().push_back(row);
      } else {
        held[row] = true; // bilateral contact
      }
    }
  }
  for (int node : options.walls) {
    held[nonlinear[node][1]] = true;
  }
  for (int x : options.sliding) {
    for (int y = 0; y <= options.cells_y; ++y) {
      held[nodeAt(options, x, y) * options.components + 1] = true;
    }
  }
  decouple(global, held);
  for (int row = 0; row < global.rows(); ++row) {
    if (held[row]) {
      constrained.push_back(row);
    }
  }
}

void ElasticModel::makeViews()
{
  std::vector<int> rows;
  for (int row : constrained) {
    if (map->isNodeGlobalElement(row)) {
      rows.push_back(map->getLocalElement(row));
    }
  }
  const Kokkos::View<LocalOrdinal*, MemorySpace> held("constrained", rows.size());
  const Kokkos::View<int*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> host_held(rows.data(),
                                                                                 rows.size());
  Kokkos::deep_copy(held, host_held);
  held_rows = held;

  std::vector<int> dofs;
  for (std::size_t node = 0; node < nonlinear.size(); ++node) {
    if (map->isNodeGlobalElement(nonlinear[node][0])) {
      mine.push_back(static_cast<int>(node));
      for (int row : nonlinear[node]) {
        dofs.push_back(map->getLocalElement(row));
      }
    }
  }
  using HostDofs =
    Kokkos::View<int**, Kokkos::LayoutRight, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>;
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> tangential(
    "dofs", mine.size(), options.tangents);
  Kokkos::deep_copy(tangential, HostDofs(dofs.data(), mine.size(), options.tangents));
  nodes.dofs = tangential;
  nodes = nodesWith({});
}

NonlinearNodes ElasticModel::nodesWith(std::vector<std::vector<int>> const& further) const
{
  std::vector<int> held(numLocalElements(*map), 0);
  for (int row : constrained) {
    if (map->isNodeGlobalElement(row)) {
      held[map->getLocalElement(row)] = 1;
    }
  }
  const auto dofs = toHost(nodes.dofs);
  for (std::size_t node = 0; node < further.size(); ++node) {
    for (int k = 0; k < dofs.extent_int(1); ++k) {
      held[dofs(node, k)] |= further[node][k];
    }
  }
  return {nodes.dofs, toDevice(held, "held"),
          fem::colourFreeNodes(*Z->getCrsGraph(), nodes.dofs, held)};
}

MultigridProblem ElasticModel::problem() const
{
  return {Z, options.components, near_null_space, held_rows, nodes};
}

Vector ElasticModel::scatter(Eigen::VectorXd const& vector) const
{
  Vector local(map);
  for (std::size_t row = 0; row < numLocalElements(*map); ++row) {
    local.replaceLocalValue(static_cast<int>(row),
                            vector(map->getGlobalElement(static_cast<int>(row))));
  }
  return local;
}

Eigen::VectorXd ElasticModel::gather(Vector const& local) const
{
  Eigen::VectorXd part = Eigen::VectorXd::Zero(global.rows());
  const auto host = local.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t row = 0; row < numLocalElements(*map); ++row) {
    part(map->getGlobalElement(static_cast<int>(row))) = host(row, 0);
  }
  Eigen::VectorXd all(part.size());
  Teuchos::reduceAll(*map->getComm(), Teuchos::REDUCE_SUM, static_cast<int>(part.size()),
                     part.data(), all.data());
  return all;
}

void decouple(Eigen::SparseMatrix<double>& matrix, std::vector<bool> const& marked)
{
  for (int column = 0; column < matrix.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
      if (entry.row() != column && (marked[entry.row()] || marked[column])) {
        entry.valueRef() = 0;
      }
    }
  }
}

ConstBlockView denseCopyOf(CrsMatrix const& matrix)
{
  const auto local = matrix.getLocalMatrixHost();
  const BlockView result("dense", local.numRows(), local.numRows());
  const auto host = Kokkos::create_mirror_view(result);
  for (int row = 0; row < local.numRows(); ++row) {
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      host(row, local.graph.entries(k)) = local.values(k);
    }
  }
  Kokkos::deep_copy(result, host);
  return result;
}

double pseudorandom(int index, int sequence)
{
  std::mt19937_64 generator(static_cast<std::uint64_t>(index) * 64 +
                            static_cast<std::uint64_t>(sequence));
  return std::ldexp(static_cast<double>(generator() >> 11), -52) - 1.0;
}

Eigen::VectorXd pseudorandomVector(int size, int sequence)
{
  Eigen::VectorXd result(size);
  for (int index = 0; index < size; ++index) {
    result(index) = pseudorandom(index, sequence);
  }
  return result;
}
} // namespace asperity::tnnmg::test
