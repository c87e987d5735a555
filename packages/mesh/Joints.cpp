#include "mesh/Joints.hpp"

#include "base/Errors.hpp"
#include "mesh/GlobalMesh.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>
#include <map>

namespace asperity::mesh
{
namespace
{
// The pairs of faults that go on.
struct PairsOfMain
{
  explicit PairsOfMain(std::vector<SplitVertex> const& splits)
  {
    for (auto const& pair : splits) {
      if (!pair.is_tip && !pair.is_joint) {
        pluses[pair.minus].push_back(pair.plus);
        minus_of[pair.plus] = pair.minus;
      }
    }
  }

  // The plus vertex of the pair that has this vertex, or -1 if no pair or several have it.
  int mainAt(int vertex) const
  {
    const auto as_plus = minus_of.find(vertex);
    const auto as_minus = pluses.find(as_plus == minus_of.end() ? vertex : as_plus->second);
    return as_minus != pluses.end() && as_minus->second.size() == 1 ? as_minus->second.front() : -1;
  }

  std::map<int, std::vector<int>> pluses;
  std::map<int, int> minus_of;
};
} // namespace

std::vector<Joint> jointsOf(std::vector<SplitVertex> const& splits)
{
  const bool has_joints = std::any_of(splits.begin(), splits.end(),
                                      [](SplitVertex const& pair) { return pair.is_joint; });
  if (!has_joints) {
    return {};
  }
  const PairsOfMain pairs(splits);
  std::vector<Joint> joints;
  for (auto const& pair : splits) {
    if (pair.is_joint) {
      const int main = pairs.mainAt(pair.minus);
      joints.push_back({pair.plus, pair.minus, main, main == pair.minus});
    }
  }
  return joints;
}

template <class AnyMesh>
void checkJoints(AnyMesh const& mesh, std::string const& where)
{
  const PairsOfMain pairs(mesh.splits);
  std::map<int, int> num_at; // pairs of joints, by their minus
  for (auto const& pair : mesh.splits) {
    if (pair.is_joint) {
      ASPERITY_REQUIRE(
        !pair.is_tip && pairs.mainAt(pair.minus) >= 0 && ++num_at[pair.minus] == 1,
        where << ": vertex " << pair.plus << " at "
              << text(mesh.vertices[static_cast<std::size_t>(pair.plus)])
              << " belongs to a branch that slips along another fault, but its minus " << pair.minus
              << " is not the vertex of one fault that goes on there, or belongs to "
                 "another branch, too.");
    }
  }
}

template void checkJoints(GlobalMesh<2> const&, std::string const&);
template void checkJoints(GlobalMesh<3> const&, std::string const&);
template void checkJoints(Mesh<2> const&, std::string const&);
template void checkJoints(Mesh<3> const&, std::string const&);
} // namespace asperity::mesh
