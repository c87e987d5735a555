#pragma once

#include "dynamics/State.hpp"
#include "fem/FaultSurface.hpp"

#include <optional>
#include <string>

namespace asperity::dynamics
{
// A value of a state whose square is nan or infinite: norms and energies are made of squares.
struct NotFinite
{
  enum class Place
  {
    body,
    fault,
    cell
  };

  std::string field; // "velocity"
  Place place = Place::body;
  int index = 0; // local: dof of the body, node of the fault, or row of the body's cells
  double value = 0;

  // A local vertex there.
  int vertexIn(Body const& body, fem::FaultSurface const& surface) const;
};

// The first one on this rank, in the order of the state's fields. Not collective.
std::optional<NotFinite> firstNotFinite(State const& state);
// The same for a step that failed: of its end, only the fields for which it has a first guess are
// known.
std::optional<NotFinite> firstNotFiniteAtFault(State const& state);
std::optional<NotFinite> firstNotFinite(std::string const& quantity, RCP<Vector> const& x);
} // namespace asperity::dynamics
