#pragma once

#include "base/parameters/Parameters.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/Fault.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/RateSolver.hpp"
#include "fem/BoundaryNodes.hpp"
#include "fem/Constraints.hpp"
#include "fem/Material.hpp"
#include "fem/RigidBodyMotions.hpp"
#include "scenario/setup/BoundarySetup.hpp"
#include "scenario/setup/InitialSetup.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::scenario
{
// What a deck describes, discretised: the body, its fault and the state it starts from. It refers
// to itself: neither copied nor moved.
template <int Dim>
struct Problem
{
  // `deck` is completed. Collective.
  Problem(ParameterList const& deck, RCP<const Communicator> const& communicator);
  Problem(Problem const&) = delete;
  Problem& operator=(Problem const&) = delete;

  RCP<const Communicator> communicator;
  int components; // of the displacement
  BoundaryConditions<Dim> boundary;
  Mesh<Dim> mesh;
  std::unique_ptr<fem::Constraints<Dim>> constraints;
  fem::BoundaryNodes<Dim> fault_nodes;
  dynamics::Body body;
  dynamics::Fault fault;
  std::vector<fem::Material> fault_materials; // (num fault nodes) of the body beside the fault
  std::vector<double>
    radiation_damping; // (num fault nodes) eta [Pa s/m]; zero unless quasi-dynamic
  dynamics::RateSolverSettings solver;
  dynamics::State initial;
  std::vector<std::string> remarks; // what the user should know, for the log

  // Displacements along the axes (num_owned, components) of a vector in nodal frames.
  void alongAxes(Vector const& x, std::vector<double>& result) const;

private:
  void makeBody(ParameterList const& bulk, std::vector<fem::Material> const& materials);
  void makeFault(ParameterList const& deck, std::vector<fem::Material> const& materials);
  void makeLoads(ParameterList const& deck, std::vector<fem::Material> const& materials);
  void makeInitialState(ParameterList const& deck);
  void makeNormalStress(ParameterList const& friction, bool start_static);
  std::vector<double> reactionPressure(Vector const& u) const;
  InitialFault startOfFault(ParameterList const& friction) const;
  RCP<Vector> prescribedAcceleration(double dt) const;

  RCP<Vector> gravity_load_;
};
} // namespace asperity::scenario
