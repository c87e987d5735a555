#pragma once

#include "dynamics/coupling/CoupledStep.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "fem/bulk/BulkLaw.hpp"
#include "fem/constraints/Constraints.hpp"
#include "mesh/GlobalMesh.hpp"

#include <Eigen/Dense>
#include <Tpetra_CrsMatrix.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::dynamics::test
{
// A small body with a fault, in two or three dimensions, put together from fem and dynamics without
// a deck.
template <int Dim>
struct OptionsIn
{
  int components = Dim; // 1 is antiplane
  GlobalMesh<Dim> mesh;
  std::string fault = "bottom"; // but for antiplane motion with v . n = 0
  std::vector<fem::VelocityCondition<Dim>> conditions;
  fem::Material material = {900, 0.05e6, 0.023e6, 1e3, 1e3}; // gelatine
  std::vector<fem::RelaxingShare> relaxation = {};
  std::string yield = {};                  // a law of bulk, in all cells
  std::vector<double> strength = {};       // its parameters
  std::vector<double> initial_stress = {}; // Pa, components of a tensor; 0 if empty
  std::array<double, Dim> gravity = {};    // m/s^2, but for antiplane motion
  double traction = 0;                     // Pa, along the first tangent
  // Instead of that, along the axes; what is normal to the fault does nothing.
  std::array<double, Dim> traction_along_axes = {}; // Pa

  double sigma_n = 2000; // Pa
  // Instead of sigma_n, where the normal stress changes: in x and t [s].
  std::function<double(Point<Dim> const&, double)> normal_stress = {};
  double cohesion = 0; // Pa
  double a = 0.01, b = 0.015, L = 25e-6, reference_rate = 50e-6, reference_friction = 0.7;
  double stress_sensitivity = 0; // c / b of Linker and Dieterich's term
  // L_pc [m] and T_pc [s] of a regularised normal stress.
  std::optional<std::array<double, 2>> regularisation = {};
  // Made of the surface, in addition to the laws.
  std::function<FaultProcesses(fem::FaultSurface const&)> processes = {};
  fem::OtherSide other_side = fem::OtherSide::rigid_foundation;
  std::string law = "Regularised", state_law = "Ageing";
};

template <int Dim>
struct ModelIn
{
  ModelIn(OptionsIn<Dim> const& options, RCP<const Communicator> const& communicator);
  ModelIn(ModelIn const&) = delete;
  ModelIn& operator=(ModelIn const&) = delete;

  // At rest, alpha = 0; v and a of the fixed dofs are those prescribed at t = 0.
  State restingState() const;
  // Values at the fault nodes.
  NodeView nodeView(std::function<double(Point<Dim> const&)> const& value) const;
  // On the fault at a local node of the mesh and a time, Pa.
  double normalStress(int node, double t) const;
  // Gives the free dofs the values of a function of place along the axes.
  void setFree(Vector& x, std::function<Point<Dim>(Point<Dim> const&)> const& value) const;
  // Along the axes, at an owned node.
  Point<Dim> valueAt(Vector const& x, int node) const;

  OptionsIn<Dim> options;
  Mesh<Dim> mesh;
  std::shared_ptr<const fem::DofMap> dofs;
  std::shared_ptr<const fem::Constraints<Dim>> constraints;
  fem::BodyMatrices matrices;
  std::shared_ptr<const fem::FaultSurface> surface;
  Body body;
  Fault fault;

private:
  Body makeBody() const;
  Fault makeFault() const;
  RCP<const Vector> makeLoad() const;
};

using ModelOptions = OptionsIn<2>;
using Model = ModelIn<2>;

// Solved as far as rounding allows.
RateSolverSettings tightSettings(Correction correction = Correction::direct);
CouplingSettings tightCoupling();

// What steps a model.
struct Stepper
{
  template <int Dim>
  Stepper(ModelIn<Dim> const& model, RateUpdate const& update, DyadicTime const& time,
          CouplingSettings const& coupling = tightCoupling(),
          RateSolverSettings const& settings = tightSettings(), std::size_t budget = 1u << 30)
      : clock(time)
      , step(model.body, model.fault, {update, clock, coupling, settings, budget})
  {
  }

  DyadicTime clock;
  CoupledStep step;
  SolveCount count;
};

// Everything of a vector on one rank, or of a matrix.
Eigen::VectorXd denseOf(Vector const& x);
Eigen::VectorXd denseOf(ConstNodeView const& x);
Eigen::MatrixXd denseOf(CrsMatrix const& matrix);
} // namespace asperity::dynamics::test
