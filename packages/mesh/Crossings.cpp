#include "mesh/Crossings.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>
#include <map>

namespace asperity::mesh
{
namespace
{
// The pluses of the pairs of faults that go on, ascending, by their minus.
std::map<int, std::vector<int>> plusesOf(std::vector<SplitVertex> const& splits)
{
  std::map<int, std::vector<int>> pluses;
  for (auto const& pair : splits) {
    if (!pair.is_tip && !pair.is_joint) {
      pluses[pair.minus].push_back(pair.plus);
    }
  }
  return pluses;
}
} // namespace

std::vector<Crossing> crossingsOf(std::vector<SplitVertex> const& splits)
{
  std::vector<Crossing> crossings;
  for (auto const& [mean, plus] : plusesOf(splits)) {
    if (plus.size() == 3) {
      crossings.push_back({mean, {plus[0], plus[1]}, plus[2]});
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](Crossing const& a, Crossing const& b) { return a.plus[0] < b.plus[0]; });
  return crossings;
}

template <template <int> class AnyMesh, int Dim>
void checkCrossings(AnyMesh<Dim> const& mesh, std::string const& where)
{
  for (auto const& [minus, plus] : plusesOf(mesh.splits)) {
    ASPERITY_REQUIRE(plus.size() == 1 || plus.size() == 3,
                     where << ": vertex " << minus << " at " << text(mesh.vertices[minus])
                           << " is the minus of " << plus.size()
                           << " pairs at faults. It may be that of one pair, or of three where two "
                              "faults cross.");
  }
}

template void checkCrossings(GlobalMesh<2> const&, std::string const&);
template void checkCrossings(GlobalMesh<3> const&, std::string const&);
template void checkCrossings(Mesh<2> const&, std::string const&);
template void checkCrossings(Mesh<3> const&, std::string const&);
} // namespace asperity::mesh
