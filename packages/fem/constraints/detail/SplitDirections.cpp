#include "fem/constraints/detail/SplitDirections.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem::detail
{
namespace
{
using Directions = std::vector<Direction>;

Terms scaled(Terms terms, double factor)
{
  for (auto& term : terms) {
    term.second *= factor;
  }
  return terms;
}

Terms sum(Terms a, Terms const& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Whether each condition is on a fault inside the body.
template <int Dim>
std::vector<bool> areOnFaults(std::vector<VelocityCondition<Dim>> const& conditions,
                              Mesh<Dim> const& mesh)
{
  std::vector<bool> result;
  result.reserve(conditions.size());
  for (auto const& condition : conditions) {
    result.push_back(std::count(mesh.faults.begin(), mesh.faults.end(), condition.boundary) > 0);
  }
  return result;
}

template <class Predicate>
Directions those(Directions const& all, Predicate const& are_wanted)
{
  Directions result;
  std::copy_if(all.begin(), all.end(), std::back_inserter(result),
               [&](Direction const& one) { return are_wanted(one.condition); });
  return result;
}

bool areParallel(Direction const& a, Direction const& b)
{
  return 1 - std::abs(dot(a.vector, b.vector)) < parallel;
}

class Pair
{
public:
  Pair(Directions plus, Directions minus) : plus_(std::move(plus)), minus_(std::move(minus)) {}

  // Pairs each direction of the plus side with a parallel one of the minus side, if possible of the
  // same condition.
  void match()
  {
    for (auto const& one : plus_) {
      const auto partner = partnerOf(one);
      if (partner == minus_.end()) {
        alone_.push_back(one);
        continue;
      }
      const double sign = dot(one.vector, partner->vector) < 0 ? -1 : 1;
      mean_.push_back({one.vector, one.condition,
                       sum(scaled(one.terms, 0.5), scaled(partner->terms, 0.5 * sign))});
      jump_.push_back({one.vector, one.condition, sum(one.terms, scaled(partner->terms, -sign))});
      minus_.erase(partner);
    }
    alone_.insert(alone_.end(), minus_.begin(), minus_.end());
  }

  Directions const& mean() const { return mean_; }
  Directions const& jump() const { return jump_; }
  Directions const& alone() const { return alone_; } // on one side only

private:
  Directions::iterator partnerOf(Direction const& one)
  {
    const auto same = std::find_if(minus_.begin(), minus_.end(), [&](Direction const& other) {
      return other.condition == one.condition && areParallel(one, other);
    });
    return same != minus_.end()
             ? same
             : std::find_if(minus_.begin(), minus_.end(),
                            [&](Direction const& other) { return areParallel(one, other); });
  }

  Directions plus_, minus_, mean_, jump_, alone_;
};
} // namespace

template <int Dim>
NodalDirections meansAndJumps(NodalDirections directions, Mesh<Dim> const& mesh,
                              std::vector<VelocityCondition<Dim>> const& conditions)
{
  const auto at = [&](int vertex) {
    const auto found = directions.find(vertex);
    return found == directions.end() ? Directions() : found->second;
  };
  auto const on_fault = areOnFaults(conditions, mesh);
  const auto is_of_body = [&](int condition) { return !on_fault[condition]; };
  for (auto const& split : mesh.splits) {
    if (split.plus >= mesh.num_owned) {
      continue;
    }
    auto jump = those(at(split.plus), [&](int condition) {
      return on_fault[condition] && (!split.is_tip || conditions[condition].holdsAcross());
    });
    if (!split.is_tip) {
      Pair pair(those(at(split.plus), is_of_body), those(at(split.minus), is_of_body));
      pair.match();
      if (!pair.alone().empty()) {
        auto const& condition = conditions[pair.alone().front().condition];
        ASPERITY_REQUIRE(false, condition.name
                                  << " (boundary '" << condition.boundary
                                  << "') holds for one side of a fault alone at x = "
                                  << mesh::text(mesh.vertices[split.plus])
                                  << ", where the fault ends at the boundary. Give a condition in "
                                     "the same direction on the other side of the fault, too.");
      }
      jump.insert(jump.end(), pair.jump().begin(), pair.jump().end());
      directions[split.minus] = pair.mean();
    }
    directions[split.plus] = jump;
  }
  return directions;
}

template NodalDirections meansAndJumps(NodalDirections, Mesh<2> const&,
                                       std::vector<VelocityCondition<2>> const&);
template NodalDirections meansAndJumps(NodalDirections, Mesh<3> const&,
                                       std::vector<VelocityCondition<3>> const&);
} // namespace asperity::fem::detail
