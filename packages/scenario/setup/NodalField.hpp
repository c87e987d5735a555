#pragma once

#include "base/Text.hpp"
#include "mesh/Mesh.hpp"
#include "parameters/fields/Field.hpp"

#include <array>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The values of the entry `name` of a list at some local vertices. Where a vertex lies between
// regions, the first cell that has the vertex decides.
class NodalField
{
public:
  template <int Dim>
  NodalField(ParameterList const& list, std::string const& name, std::string const& path,
             Mesh<Dim> const& mesh, std::vector<int> const& nodes);

  bool dependsOnTime() const { return field_.dependsOnTime(); }
  // (num_nodes) values at the time t [s]. InputError outside the declared range.
  std::vector<double> at(double t) const;

private:
  Field field_;
  std::vector<std::array<double, 3>> places_;
  std::vector<int> regions_;
  std::vector<double> values_; // of a dataset
};

// The values of a field that does not change in time, (num_nodes). Throws InputError if it depends
// on time.
template <int Dim>
std::vector<double> nodalValues(ParameterList const& list, std::string const& name,
                                std::string const& path, Mesh<Dim> const& mesh,
                                std::vector<int> const& nodes);

// A field that is evaluated once, at time zero. Throws InputError if it depends on time.
// region_names: the regions of the mesh.
Field steadyField(ParameterList const& list, std::string const& name, std::string const& path,
                  std::vector<std::string> const& region_names);

// A point as expressions see it: z is 0 in the plane.
template <int Dim>
std::array<double, 3> inSpace(Point<Dim> const& x)
{
  return {x[0], x[1], Dim == 3 ? x[Dim - 1] : 0};
}

// Whether the deck gives the entry, as a parameter or as a list of values per region.
bool isGiven(ParameterList const& list, std::string const& name);
} // namespace asperity::scenario
