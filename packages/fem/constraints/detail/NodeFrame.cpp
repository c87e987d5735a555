#include "fem/constraints/detail/NodeFrame.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem::detail
{
namespace
{
// The first condition that prescribes a velocity neither along nor across one of the directions. If
// none is found because of rounding, it is the first condition that prescribes a velocity.
template <int Dim>
VelocityCondition<Dim> const&
obliqueCondition(std::vector<VelocityCondition<Dim>> const& conditions,
                 std::vector<Direction> const& directions,
                 std::vector<std::vector<double>> const& to)
{
  const auto prescribes = [&](Direction const& direction) {
    return conditions[direction.condition].prescribes();
  };
  const auto is_oblique = [&](Direction const& direction) {
    return prescribes(direction) && std::any_of(to.begin(), to.end(), [&](auto const& vector) {
             const double cosine = dot(direction.vector, vector);
             return !isAcross(cosine) && !isAlong(cosine);
           });
  };
  const auto found = std::find_if(directions.begin(), directions.end(), is_oblique);
  const auto first = std::find_if(directions.begin(), directions.end(), prescribes);
  return conditions[(found != directions.end() ? found : first)->condition];
}
} // namespace

template <int Dim>
int turnAt(std::vector<VelocityCondition<Dim>> const& conditions,
           std::vector<Direction> const& directions)
{
  if (directions.empty()) {
    return 0;
  }
  const auto is_free = [&](Direction const& one) {
    return !conditions[one.condition].prescribes();
  };
  const auto free = std::find_if(directions.begin(), directions.end(), is_free);
  auto const& first = conditions[(free != directions.end() ? *free : directions.front()).condition];
  return first.isTurned() ? 0 : first.turn;
}

template <int Dim>
NodalBasis basisOfFrame(std::vector<VelocityCondition<Dim>> const& conditions,
                        std::vector<Direction> const& directions, NodalBasis const& prescribed,
                        Mesh<Dim> const& mesh, int node)
{
  NodalBasis basis;
  VelocityCondition<Dim> const* of_frame = nullptr;
  for (auto const& direction : directions) {
    auto const& condition = conditions[direction.condition];
    Terms none;
    if (!condition.prescribes() && basis.add(direction.vector, none)) {
      of_frame = &condition;
    }
  }
  if (of_frame == nullptr) {
    basis = prescribed;
    basis.orient(turnAt(conditions, directions));
    return basis;
  }
  auto const free = basis.vectors();
  for (auto const& vector : prescribed.vectors()) {
    Terms none;
    basis.add(vector, none);
  }
  for (int k = 0; k < basis.size(); ++k) {
    auto const& vector = basis.vectors()[k];
    const double cosine = prescribed.share(vector);
    if (isAcross(cosine)) {
      continue;
    }
    ASPERITY_REQUIRE(isAlong(cosine),
                     obliqueCondition(conditions, directions, free).name
                       << " prescribes a velocity neither along nor across the boundary '"
                       << of_frame->boundary << "' at "
                       << "x = " << mesh::text(mesh.vertices[node]) << ", where " << of_frame->name
                       << " leaves the body free to move across it. Prescribe the velocity along "
                          "or across it there, or in both directions.");
    basis.setVelocity(k, prescribed.velocityAlong(vector));
  }
  basis.orient(turnAt(conditions, directions));
  return basis;
}

NodalFrames::Matrix frameFrom(NodalBasis const& basis, int components, int turn)
{
  auto vectors = basis.vectors();
  auto frame = NodalFrames::identity(components);
  while (static_cast<int>(vectors.size()) < components) {
    vectors.push_back(vectors.size() == 1 && turn != 0 ? tangentOf(vectors[0], turn)
                                                       : completing(vectors, components));
  }
  for (int k = 0; k < components; ++k) {
    const int row = k < basis.size() ? components - 1 - k : k - basis.size();
    for (int c = 0; c < components; ++c) {
      frame[row * components + c] = vectors[k][c];
    }
  }
  return frame;
}

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template int turnAt(std::vector<VelocityCondition<DIM>> const&, std::vector<Direction> const&);  \
  template NodalBasis basisOfFrame(std::vector<VelocityCondition<DIM>> const&,                     \
                                   std::vector<Direction> const&, NodalBasis const&,               \
                                   Mesh<DIM> const&, int);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::fem::detail
