#pragma once

#include "tnnmg/correction/MultigridCorrection.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <vector>

namespace asperity::tnnmg::test
{
// A rectangle of gelatine, 1 m wide, of P1 triangles: Z = (2/tau) M + C + (tau/2) K. Its lower side
// is the fault, its right side is held. Nodes are numbered column by column, so that ranks share
// the fault.
struct ElasticModelOptions
{
  int cells_x = 40;
  int cells_y = 12;
  double tau = 1e-3;  // s
  int components = 2; // 1 is antiplane
  int tangents = 1;   // nonlinear components of a fault node; with 2 of 2, nothing is held there
  std::vector<int> walls = {};   // fault nodes whose second tangential component is held after all
  std::vector<int> sliding = {}; // columns of nodes whose second component is held from y = 0 up
  bool components_are_coupled = true; // if not, Z has stored zeros where x would meet y
};

struct ElasticModel
{
  explicit ElasticModel(ElasticModelOptions const& options);

  MultigridProblem problem() const;

  // Of a vector given on all ranks, this rank's part, and back.
  Vector scatter(Eigen::VectorXd const& global) const;
  Eigen::VectorXd gather(Vector const& local) const;

  ElasticModelOptions options;
  Eigen::SparseMatrix<double> global;      // Z, on every rank
  std::vector<int> constrained;            // global rows, on every rank
  std::vector<std::vector<int>> nonlinear; // global rows of each fault node, on every rank
  std::vector<int> mine;                   // the fault nodes of this rank
  RCP<const Map> map;
  RCP<const CrsMatrix> Z;
  RCP<const MultiVector> near_null_space;
  IndexView held_rows;  // local
  NonlinearNodes nodes; // of this rank
  // The same with further rows held: further(num_nodes, T) 1.
  NonlinearNodes nodesWith(std::vector<std::vector<int>> const& further) const;

private:
  void chooseRows();
  void makeViews();
};

// Off-diagonal entries of the marked rows and columns become zeros, which stay stored.
void decouple(Eigen::SparseMatrix<double>& matrix, std::vector<bool> const& marked);

// The entries of a matrix on one rank.
ConstBlockView denseCopyOf(CrsMatrix const& matrix);

// In [-1, 1), the same on every rank and in every run.
double pseudorandom(int index, int sequence);
Eigen::VectorXd pseudorandomVector(int size, int sequence);
} // namespace asperity::tnnmg::test
