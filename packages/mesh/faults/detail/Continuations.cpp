#include "mesh/faults/detail/Continuations.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace asperity::mesh::detail
{
namespace
{
// Angles in degrees.
constexpr double largest_bend = 30.0;        // of faults that go on through another one
constexpr double largest_bend_of_two = 60.0; // of the two of three ends that go on
constexpr double clearly = 10.0;             // that these bend less than the other pairs

// A ridge, and its facets in the order of their faults with their directions around the ridge.
template <int Dim>
struct Joint
{
  Ridge<Dim> ridge;
  std::vector<int> facets;
  std::vector<double> angles;
};

// From the ridge into a facet; in space at right angles to the ridge.
Point<2> away(GlobalMesh<2> const& mesh, Ridge<2> const& ridge, int corner)
{
  return difference<2>(mesh.vertices[corner], mesh.vertices[ridge[0]]);
}
Point<3> away(GlobalMesh<3> const& mesh, Ridge<3> const& ridge, int corner)
{
  auto const& end = mesh.vertices[ridge[0]];
  const auto along = difference<3>(mesh.vertices[ridge[1]], end);
  auto direction = difference<3>(mesh.vertices[corner], end);
  const double share = dot<3>(direction, along) / dot<3>(along, along);
  for (int d = 0; d < 3; ++d) {
    direction[d] -= share * along[d];
  }
  return direction;
}

double angle(GlobalMesh<2> const&, Ridge<2> const&, Point<2> const&, Point<2> const& direction)
{
  return std::atan2(direction[1], direction[0]);
}
// From the first direction, to the left about the ridge.
double angle(GlobalMesh<3> const& mesh, Ridge<3> const& ridge, Point<3> const& first,
             Point<3> const& direction)
{
  const auto along = difference<3>(mesh.vertices[ridge[1]], mesh.vertices[ridge[0]]);
  const double length = std::sqrt(dot<3>(along, along));
  return std::atan2(dot<3>(cross(along, first), direction) / length, dot<3>(first, direction));
}

template <int Dim>
Joint<Dim> jointOf(GlobalMesh<Dim> const& mesh, std::vector<FaultFacet<Dim>> const& all,
                   Ridge<Dim> const& ridge, std::vector<int> facets)
{
  std::stable_sort(facets.begin(), facets.end(),
                   [&](int a, int b) { return all[a].fault < all[b].fault; });
  Joint<Dim> joint{ridge, facets, {}};
  Point<Dim> first{};
  for (int facet : facets) {
    auto const& key = all[facet].key;
    const int corner = *std::find_if(key.begin(), key.end(), [&](int vertex) {
      return std::find(ridge.begin(), ridge.end(), vertex) == ridge.end();
    });
    const auto direction = away(mesh, ridge, corner);
    if (joint.angles.empty()) {
      first = direction;
    }
    const double degrees = angle(mesh, ridge, first, direction) * 180.0 / std::acos(-1.0);
    joint.angles.push_back(degrees < 0.0 ? degrees + 360.0 : degrees);
  }
  return joint;
}

// The joints along which the same faults meet.
template <int Dim>
class Line
{
public:
  using Pair = std::array<int, 2>; // places among the facets of a joint

  Line(std::vector<int> const& faults, std::vector<Joint<Dim> const*> joints)
      : joints_(std::move(joints))
  {
    for (int i = 0; i < static_cast<int>(faults.size()); ++i) {
      const bool has_before = i > 0 && faults[i - 1] == faults[i];
      const bool has_after = i + 1 < static_cast<int>(faults.size()) && faults[i + 1] == faults[i];
      if (has_after) {
        go_on_.push_back({i, i + 1});
      } else if (!has_before) {
        ends_.push_back(i);
      }
    }
  }

  // The pairs of ends that go on into each other.
  std::vector<Pair> continuations()
  {
    std::vector<Pair> found;
    while (go_on_.size() < 2 && ends_.size() >= 2) {
      const auto pair = straightest();
      if (!pair) {
        break;
      }
      found.push_back(*pair);
      go_on_.push_back(*pair);
      for (int end : *pair) {
        ends_.erase(std::find(ends_.begin(), ends_.end(), end));
      }
    }
    return found;
  }

private:
  std::optional<Pair> straightest() const
  {
    std::optional<Pair> best;
    double bend = std::numeric_limits<double>::infinity(), next = bend;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      for (std::size_t j = i + 1; j < ends_.size(); ++j) {
        const Pair pair = {ends_[i], ends_[j]};
        if (!go_on_.empty() && !areOpposite(pair, go_on_.front())) {
          continue;
        }
        const double its = bendOf(pair);
        if (its < bend) {
          next = bend;
          bend = its;
          best = pair;
        } else {
          next = std::min(next, its);
        }
      }
    }
    const bool are_three_ends = go_on_.empty() && ends_.size() == 3;
    const bool goes_on =
      are_three_ends ? bend <= largest_bend_of_two && next - bend >= clearly : bend <= largest_bend;
    return goes_on ? best : std::nullopt;
  }

  double bendOf(Pair const& pair) const
  {
    double sum = 0.0;
    for (auto const* joint : joints_) {
      sum += std::abs(180.0 - std::abs(joint->angles[pair[0]] - joint->angles[pair[1]]));
    }
    return sum / static_cast<double>(joints_.size());
  }

  // Whether the two lie on different sides of the other two, everywhere.
  bool areOpposite(Pair const& pair, Pair const& others) const
  {
    return std::all_of(joints_.begin(), joints_.end(), [&](auto const* joint) {
      auto const& angles = joint->angles;
      const auto [low, high] = std::minmax(angles[others[0]], angles[others[1]]);
      const auto is_between = [&, low = low, high = high](int place) {
        return low < angles[place] && angles[place] < high;
      };
      return is_between(pair[0]) != is_between(pair[1]);
    });
  }

  std::vector<Joint<Dim> const*> joints_;
  std::vector<Pair> go_on_;
  std::vector<int> ends_;
};

// All joints, with the faults that meet at each.
template <int Dim>
struct Joints
{
  std::vector<Joint<Dim>> all;
  std::vector<std::vector<int>> faults; // (num_joints) of the facets, in their order

  Joints(GlobalMesh<Dim> const& mesh, std::vector<FaultFacet<Dim>> const& facets,
         std::map<Ridge<Dim>, std::vector<int>> const& facets_of_ridges)
  {
    for (auto const& [ridge, numbers] : facets_of_ridges) {
      all.push_back(jointOf(mesh, facets, ridge, numbers));
      std::vector<int> there;
      for (int facet : all.back().facets) {
        there.push_back(facets[facet].fault);
      }
      faults.push_back(std::move(there));
    }
  }

  // The numbers of the joints in lines: those of a line have the same faults, and each has a vertex
  // in common with one before it. Lines are in the order of their first joints.
  std::vector<std::vector<int>> lines() const
  {
    const auto neighbours = byFaultsAndVertex();
    std::vector<std::vector<int>> result;
    std::vector<bool> is_taken(all.size(), false);
    for (std::size_t first = 0; first < all.size(); ++first) {
      if (is_taken[first]) {
        continue;
      }
      std::vector<int> line = {static_cast<int>(first)};
      is_taken[first] = true;
      for (std::size_t next = 0; next < line.size(); ++next) {
        for (int vertex : all[line[next]].ridge) {
          for (int other : neighbours.at({faults[first], vertex})) {
            if (!is_taken[other]) {
              is_taken[other] = true;
              line.push_back(other);
            }
          }
        }
      }
      result.push_back(std::move(line));
    }
    return result;
  }

private:
  std::map<std::pair<std::vector<int>, int>, std::vector<int>> byFaultsAndVertex() const
  {
    std::map<std::pair<std::vector<int>, int>, std::vector<int>> numbers;
    for (std::size_t joint = 0; joint < all.size(); ++joint) {
      for (int vertex : all[joint].ridge) {
        numbers[{faults[joint], vertex}].push_back(static_cast<int>(joint));
      }
    }
    return numbers;
  }
};
} // namespace

template <int Dim>
std::vector<Continuation<Dim>> continuations(GlobalMesh<Dim> const& mesh,
                                             std::vector<FaultFacet<Dim>> const& facets,
                                             std::map<Ridge<Dim>, std::vector<int>> const& ridges)
{
  const Joints<Dim> joints(mesh, facets, ridges);
  std::vector<Continuation<Dim>> result;
  for (auto const& line : joints.lines()) {
    std::vector<Joint<Dim> const*> of_line;
    for (int number : line) {
      of_line.push_back(&joints.all[number]);
    }
    const auto pairs = Line<Dim>(joints.faults[line.front()], of_line).continuations();
    for (auto const& [a, b] : pairs) {
      for (auto const* joint : of_line) {
        result.push_back({joint->ridge, {joint->facets[a], joint->facets[b]}});
      }
    }
  }
  return result;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::vector<Continuation<Dim>> continuations(                                           \
    GlobalMesh<Dim> const&, std::vector<FaultFacet<Dim>> const&,                                   \
    std::map<Ridge<Dim>, std::vector<int>> const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh::detail
