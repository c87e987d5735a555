#include "mesh/generation/detail/MarkedSimplex.hpp"

namespace asperity::mesh::detail
{
namespace
{
// The other two of 0, 1, 2, 3.
std::array<std::int8_t, 2> othersThan(int a, int b)
{
  std::array<std::int8_t, 2> others{};
  int count = 0;
  for (int k = 0; k < 4; ++k) {
    if (k != a && k != b) {
      others[count++] = static_cast<std::int8_t>(k);
    }
  }
  return others;
}
} // namespace

MarkedSimplex<3>::MarkedSimplex(std::array<int, 4> const& vertices, IsLonger const& is_longer)
    : vertices_(vertices)
    , ends_{0, 1}
{
  const auto edge = [&](std::array<std::int8_t, 2> const& ends) {
    return Edge{vertices[ends[0]], vertices[ends[1]]};
  };
  for (int face = 0; face < 4; ++face) {
    int apex = face == 0 ? 1 : 0;
    for (int other = apex + 1; other < 4; ++other) {
      if (other != face && is_longer(edge(othersThan(face, other)), edge(othersThan(face, apex)))) {
        apex = other;
      }
    }
    apex_[face] = static_cast<std::int8_t>(apex);
    const auto longest = othersThan(face, apex);
    if (is_longer(edge(longest), edge(ends_))) {
      ends_ = longest;
    }
  }
}

// The face that the child inherits whole keeps its mark, which becomes the refinement edge. The
// faces that were cut in two are marked opposite the midpoint, and so is the new face; if the
// parent is flagged, the mark of the new face joins the midpoint and an end of the child's
// refinement edge.
MarkedSimplex<3> MarkedSimplex<3>::child(int kept, int replaced, int midpoint) const
{
  MarkedSimplex result(*this);
  result.vertices_[replaced] = midpoint;
  result.ends_ = othersThan(replaced, apex_[replaced]);
  for (std::int8_t cut : othersThan(kept, replaced)) {
    result.apex_[cut] = static_cast<std::int8_t>(replaced);
  }
  const bool is_flagged = isPlanar() && is_flagged_;
  result.apex_[kept] = is_flagged ? apex_[replaced] : static_cast<std::int8_t>(replaced);
  result.is_flagged_ = isPlanar() && !is_flagged_;
  return result;
}
} // namespace asperity::mesh::detail
