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

// The directions of the walls and other boundaries that one side of the fault ends at.
template <int Dim>
Directions ofTheBody(Directions const& all, std::vector<VelocityCondition<Dim>> const& conditions)
{
  Directions result;
  std::copy_if(all.begin(), all.end(), std::back_inserter(result), [&](Direction const& one) {
    return conditions[one.condition].normal() != Normal::of_fault;
  });
  return result;
}

// Those that hold for the jump: all of the fault, at a tip the normal alone.
template <int Dim>
Directions ofTheFault(Directions const& all, std::vector<VelocityCondition<Dim>> const& conditions,
                      bool is_tip)
{
  Directions result;
  std::copy_if(all.begin(), all.end(), std::back_inserter(result), [&](Direction const& one) {
    auto const& condition = conditions[one.condition];
    return condition.normal() == Normal::of_fault && (!is_tip || condition.holdsAcross());
  });
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

  // Takes each direction of the plus side with its partner on the minus side, first the one of the
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
      jump_.push_back(
        {one.vector, one.condition, sum(one.terms, scaled(partner->terms, -sign))});
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
  for (auto const& split : mesh.splits) {
    if (split.plus >= mesh.num_owned) {
      continue;
    }
    auto jump = ofTheFault(at(split.plus), conditions, split.is_tip);
    if (!split.is_tip) {
      Pair pair(ofTheBody(at(split.plus), conditions), ofTheBody(at(split.minus), conditions));
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
