#pragma once

#include "base/Parameters.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/Fault.hpp"
#include "dynamics/RateSolver.hpp"
#include "dynamics/State.hpp"
#include "fem/BoundaryNodes.hpp"
#include "fem/Constraints.hpp"
#include "scenario/BoundarySetup.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Initial State`.
RCP<const ParameterList> initialStateParameters();

// What a deck describes, discretised: the body, its fault and the state it starts from. It refers
// to itself: neither copied nor moved.
struct Problem
{
  // `deck` is completed. Collective.
  Problem(ParameterList const& deck, RCP<const Communicator> const& communicator);
  Problem(Problem const&) = delete;
  Problem& operator=(Problem const&) = delete;

  RCP<const Communicator> communicator;
  Mesh<2> mesh;
  int components; // of the displacement
  BoundaryConditions boundary;
  std::unique_ptr<fem::Constraints<2>> constraints;
  fem::BoundaryNodes<2> fault_nodes;
  dynamics::Body body;
  dynamics::Fault fault;
  dynamics::RateSolverSettings solver;
  dynamics::State initial;
  std::vector<std::string> remarks; // what the user should know, for the log

  // Displacements along the axes (num_owned, components) of a vector in nodal frames.
  void alongAxes(Vector const& x, std::vector<double>& result) const;

private:
  void makeLoads(ParameterList const& deck, std::vector<fem::Material> const& materials);
  void makeInitialState(ParameterList const& deck);
  RCP<Vector> initialVelocity(ParameterList const& list) const;
  std::vector<double> reactionPressure(Vector const& u) const;

  RCP<Vector> gravity_load_, load_;
};
} // namespace asperity::scenario
