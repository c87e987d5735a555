#pragma once

#include "assembly/ForeignMesh.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// Adds the group of those sides of cells whose corners are all in a set of nodes. Where a fault
// bends, a set of its nodes may have all corners of a side on the outside, and a set of an outer
// boundary those of a side within: of the two kinds, outside and inside, the more frequent one is
// taken. False, and nothing is added, if there are no sides, as of a set of points or edges, or if
// the set has whole cells, as one of a volume has.
bool addNodeSet(ForeignMesh& mesh, std::string const& name, std::vector<int> const& nodes);

// Prints which sets were left out for that.
void tellOfEmptySets(std::vector<std::string> const& names);
} // namespace asperity::geometry
