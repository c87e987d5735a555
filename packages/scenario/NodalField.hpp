#pragma once

#include "base/Field.hpp"
#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The entry `name` of a list, a field that does not change in time, at some local vertices.
// Where a vertex lies between regions the first cell that has it decides.
std::vector<double> nodalValues(ParameterList const& list, std::string const& name,
                                std::string const& path, Mesh<2> const& mesh,
                                std::vector<int> const& nodes);

// A field that is read once, at time zero. InputError if it depends on time.
Field steadyField(ParameterList const& list, std::string const& name, std::string const& path,
                  Mesh<2> const& mesh);

// Whether the deck gives the entry, as a parameter or as a list of values per region.
bool isGiven(ParameterList const& list, std::string const& name);
} // namespace asperity::scenario
