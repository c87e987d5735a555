#include "refinement/detail/PartEdges.hpp"

#include "refinement/detail/RedRule.hpp"

#include <numeric>

namespace asperity::refinement::detail
{
namespace
{
template <int Dim, class Visit>
void forEdges(Mesh<Dim> const& part, std::vector<Edge> const& others, Visit visit)
{
  for (auto const& cell : part.cells) {
    for (auto const& [i, j] : RedRule<Dim>::edges) {
      visit(cell[i], cell[j]);
    }
  }
  for (auto const& [a, b] : others) {
    visit(a, b);
  }
}
} // namespace

template <int Dim>
PartEdges<Dim>::PartEdges(Mesh<Dim> const& part, std::vector<Edge> const& others)
    : ids_(part.global_ids)
{
  // Every edge as often as there are cells around it, sorted by the first end; then each once.
  std::vector<std::size_t> next(ids_.size() + 1, 0);
  forEdges(part, others, [&](int a, int b) { ++next[ordered(a, b)[0] + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<int> all(next.back());
  forEdges(part, others, [&](int a, int b) {
    const auto edge = ordered(a, b);
    all[next[edge[0]]++] = edge[1];
  });
  starts_.push_back(0);
  auto first = all.begin();
  for (std::size_t v = 0; v < ids_.size(); ++v) {
    const auto last = all.begin() + static_cast<std::ptrdiff_t>(next[v]);
    std::sort(first, last, [this](int a, int b) { return isBefore(a, b); });
    seconds_.insert(seconds_.end(), first, std::unique(first, last));
    starts_.push_back(static_cast<int>(seconds_.size()));
    first = last;
  }
}

template <int Dim>
int PartEdges<Dim>::find(int a, int b) const
{
  const auto edge = ordered(a, b);
  const auto first = seconds_.begin() + begin(edge[0]);
  const auto last = seconds_.begin() + begin(edge[0] + 1);
  const auto found =
    std::lower_bound(first, last, edge[1], [this](int x, int y) { return isBefore(x, y); });
  return found != last && *found == edge[1] ? static_cast<int>(found - seconds_.begin()) : -1;
}

template class PartEdges<2>;
template class PartEdges<3>;
} // namespace asperity::refinement::detail
