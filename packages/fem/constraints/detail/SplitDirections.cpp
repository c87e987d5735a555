#include "fem/constraints/detail/SplitDirections.hpp"

#include "base/Errors.hpp"
#include "mesh/Crossings.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

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

bool areParallel(Direction const& a, Direction const& b)
{
  return isAlong(dot(a.vector, b.vector));
}

// The directions of conditions on other boundaries at N vertices of one place.
template <std::size_t N>
class Copies
{
public:
  explicit Copies(std::array<Directions, N> of_vertices) : of_vertices_(std::move(of_vertices))
  {
    match();
  }

  // For each direction that all vertices have: sum_k factors[k] v_k along it.
  Directions combined(std::array<double, N> const& factors) const
  {
    Directions result;
    for (auto const& of_vertices : matched_) {
      auto direction = of_vertices[0];
      direction.terms.clear();
      for (std::size_t k = 0; k < N; ++k) {
        const double sign = dot(direction.vector, of_vertices[k].vector) < 0 ? -1 : 1;
        direction.terms =
          sum(std::move(direction.terms), scaled(of_vertices[k].terms, sign * factors[k]));
      }
      result.push_back(std::move(direction));
    }
    return result;
  }

  Directions const& alone() const { return alone_; } // that some vertices do not have

private:
  // Finds for each direction of the first vertex a parallel one of the others, if possible of the
  // same condition.
  void match()
  {
    for (auto const& one : of_vertices_[0]) {
      std::array<Direction, N> found;
      found[0] = one;
      bool is_everywhere = true;
      for (std::size_t k = 1; k < N && is_everywhere; ++k) {
        const auto partner = partnerOf(one, of_vertices_[k]);
        is_everywhere = partner != of_vertices_[k].end();
        if (is_everywhere) {
          found[k] = *partner;
          of_vertices_[k].erase(partner);
        }
      }
      if (is_everywhere) {
        matched_.push_back(found);
      } else {
        alone_.push_back(one);
      }
    }
    for (std::size_t k = 1; k < N; ++k) {
      alone_.insert(alone_.end(), of_vertices_[k].begin(), of_vertices_[k].end());
    }
  }

  static Directions::iterator partnerOf(Direction const& one, Directions& others)
  {
    const auto same = std::find_if(others.begin(), others.end(), [&](Direction const& other) {
      return other.condition == one.condition && areParallel(one, other);
    });
    return same != others.end()
             ? same
             : std::find_if(others.begin(), others.end(),
                            [&](Direction const& other) { return areParallel(one, other); });
  }

  std::array<Directions, N> of_vertices_;
  std::vector<std::array<Direction, N>> matched_;
  Directions alone_;
};

template <int Dim>
class MeansAndJumps
{
public:
  MeansAndJumps(NodalDirections const& at_vertices, Mesh<Dim> const& mesh,
                std::vector<VelocityCondition<Dim>> const& conditions, VertexTerms const& terms)
      : mesh_(mesh)
      , conditions_(conditions)
      , terms_(terms)
      , on_fault_(areOnFaults(conditions, mesh))
      , at_vertices_(at_vertices)
      , result_(at_vertices)
  {
  }

  NodalDirections run()
  {
    std::set<int> at_crossings; // means
    for (auto const& crossing : mesh::crossingsOf(mesh_.splits)) {
      at_crossings.insert(crossing.mean);
      if (crossing.mean < mesh_.num_owned) {
        addCrossing(crossing);
      }
    }
    for (std::size_t i = 0; i < terms_.joints().size(); ++i) {
      if (terms_.joints()[i].plus < mesh_.num_owned) {
        addJoint(terms_.joints()[i], terms_.share(i));
      }
    }
    for (auto const& split : mesh_.splits) {
      if (split.plus >= mesh_.num_owned || split.is_joint) {
        continue;
      }
      if (split.is_tip) {
        result_[split.plus] = across(split.plus);
      } else if (at_crossings.count(split.minus) == 0) {
        addPair(split);
      }
    }
    return std::move(result_);
  }

private:
  void addPair(SplitVertex const& split)
  {
    const auto [plus, minus] = std::make_pair(split.plus, split.minus);
    const Copies<2> copies({ofBody(plus), ofBody(minus)});
    requireBothSides(copies.alone(), plus);
    result_[plus] = withFault(plus, copies.combined({1., -1.}));
    result_[minus] = copies.combined({0.5, 0.5});
  }

  // Over the branch; both vertices together are then one side of the main fault.
  void addJoint(mesh::Joint const& joint, double share)
  {
    const Copies<2> copies({ofBody(joint.plus), ofBody(joint.minus)});
    requireBothSides(copies.alone(), joint.plus);
    joined_[joint.minus] = copies.combined({share, 1 - share});
    auto& jump = result_[joint.plus] = across(joint.plus);
    const auto of_main = across(joint.main);
    jump.insert(jump.end(), of_main.begin(), of_main.end());
    const auto slip = slipAlong(jump, joint.plus);
    jump.insert(jump.end(), slip.begin(), slip.end());
    const auto of_body = copies.combined({1., -1.});
    jump.insert(jump.end(), of_body.begin(), of_body.end());
  }

  // The directions across the fault, whether they are held or free.
  Directions across(int plus) const
  {
    return those(plus, [this](int condition) {
      auto const& one = conditions_[condition];
      return on_fault_[condition] && (one.holdsAcross() || !one.prescribes());
    });
  }

  // What conditions on the fault at this plus vertex prescribe for its slip: in space the part at
  // right angles to the directions across, in antiplane motion all.
  Directions slipAlong(Directions const& across, int plus) const
  {
    const auto given = those(plus, [this](int condition) {
      auto const& one = conditions_[condition];
      return on_fault_[condition] && one.prescribes() && !one.holdsAcross();
    });
    if (given.empty() || across.empty()) {
      return given;
    }
    NodalBasis held;
    for (auto const& direction : across) {
      Terms none;
      held.add(direction.vector, none);
    }
    const auto components = static_cast<int>(given.front().vector.size());
    if (held.size() != components - 1) { // in plane strain nothing is left
      return {};
    }
    Direction along{completing(held.vectors(), components), given.front().condition, {}};
    for (auto const& one : given) {
      along.terms = sum(std::move(along.terms), scaled(one.terms, dot(one.vector, along.vector)));
    }
    return {along};
  }

  void addCrossing(mesh::Crossing const& crossing)
  {
    auto const& [mean, plus, both] = crossing;
    const Copies<4> copies({ofBody(mean), ofBody(plus[0]), ofBody(plus[1]), ofBody(both)});
    requireBothSides(copies.alone(), mean);
    result_[mean] = copies.combined({0.25, 0.25, 0.25, 0.25});
    result_[plus[0]] = withFault(plus[0], copies.combined({-0.5, 0.5, -0.5, 0.5}));
    result_[plus[1]] = withFault(plus[1], copies.combined({-0.5, -0.5, 0.5, 0.5}));
    // What is held there has to be zero by the conditions, too.
    auto& held = result_[both] = {};
    for (auto const& direction : copies.combined({1., -1., -1., 1.})) {
      if (conditions_[direction.condition].prescribes()) {
        held.push_back({direction.vector, direction.condition, {}});
        held.push_back(direction);
      }
    }
  }

  template <class Predicate>
  Directions those(int vertex, Predicate const& are_wanted) const
  {
    Directions result;
    const auto found = at_vertices_.find(vertex);
    if (found != at_vertices_.end()) {
      std::copy_if(found->second.begin(), found->second.end(), std::back_inserter(result),
                   [&](Direction const& one) { return are_wanted(one.condition); });
    }
    return result;
  }

  Directions ofBody(int vertex) const
  {
    const auto joined = joined_.find(vertex);
    if (joined != joined_.end()) {
      return joined->second;
    }
    return those(vertex, [this](int condition) { return !on_fault_[condition]; });
  }

  // The conditions on the fault at this plus vertex, then those on its jump.
  Directions withFault(int plus, Directions const& jump) const
  {
    auto all = those(plus, [this](int condition) { return on_fault_[condition]; });
    all.insert(all.end(), jump.begin(), jump.end());
    return all;
  }

  void requireBothSides(Directions const& alone, int vertex) const
  {
    if (!alone.empty()) {
      auto const& condition = conditions_[alone.front().condition];
      ASPERITY_REQUIRE(false, condition.name
                                << " (boundary '" << condition.boundary
                                << "') holds for one side of a fault alone at x = "
                                << mesh::text(mesh_.vertices[vertex])
                                << ", where the fault ends at the boundary. Give a condition in "
                                   "the same direction on the other side of the fault, too.");
    }
  }

  Mesh<Dim> const& mesh_;
  std::vector<VelocityCondition<Dim>> const& conditions_;
  VertexTerms const& terms_;
  std::vector<bool> on_fault_;
  NodalDirections const& at_vertices_;
  NodalDirections result_;
  NodalDirections joined_; // of the body, at the minus of joints: for the sides of the main fault
};
} // namespace

template <int Dim>
NodalDirections meansAndJumps(NodalDirections const& directions, Mesh<Dim> const& mesh,
                              std::vector<VelocityCondition<Dim>> const& conditions,
                              VertexTerms const& terms)
{
  return MeansAndJumps<Dim>(directions, mesh, conditions, terms).run();
}

template NodalDirections meansAndJumps(NodalDirections const&, Mesh<2> const&,
                                       std::vector<VelocityCondition<2>> const&,
                                       VertexTerms const&);
template NodalDirections meansAndJumps(NodalDirections const&, Mesh<3> const&,
                                       std::vector<VelocityCondition<3>> const&,
                                       VertexTerms const&);
} // namespace asperity::fem::detail
