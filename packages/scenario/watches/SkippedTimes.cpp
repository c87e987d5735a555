#include "scenario/watches/SkippedTimes.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "parameters/ParameterInfo.hpp"
#include "parameters/fields/TimesInFormula.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/NodalField.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace asperity::scenario
{
template <int Dim>
std::vector<std::array<double, 3>> placesOfLoads(Problem<Dim> const& problem)
{
  constexpr std::size_t most = 100; // of each kind
  std::vector<std::array<double, 3>> places;
  auto const& nodes = problem.surface();
  const int num_nodes = nodes.numNodes();
  for (int node = 0; node < num_nodes; node += 1 + num_nodes / static_cast<int>(most)) {
    places.push_back(nodes[node].place);
  }
  auto const& vertices = problem.mesh().vertices;
  for (std::size_t v = 0; v < vertices.size(); v += 1 + vertices.size() / most) {
    places.push_back(inSpace<Dim>(vertices[v]));
  }
  return places;
}

template std::vector<std::array<double, 3>> placesOfLoads(Problem<2> const&);
template std::vector<std::array<double, 3>> placesOfLoads(Problem<3> const&);

SkippedTimes::SkippedTimes(ParameterList const& deck, std::vector<std::array<double, 3>> places,
                           RCP<const Communicator> communicator)
    : places_(std::move(places))
    , communicator_(std::move(communicator))
{
  for (auto const* part :
       {deck_lists::conditions, deck_lists::bulk, deck_lists::friction}) { // whatever loads
    collect(deck.sublist(part), pathInDeck(part), nullptr);
  }
  std::sort(times_.begin(), times_.end());
  times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
}

SkippedTimes::SkippedTimes(ParameterList const&, dynamics::WatchContext const& context)
    : SkippedTimes(context.deck, context.places_of_loads, context.fault.surface().communicator())
{
}

void SkippedTimes::note(dynamics::WatchedState const& now, dynamics::Notes& notes)
{
  if (now.step) {
    notes.add(note(now.time - now.step->size, now.time));
  }
}

void SkippedTimes::collect(ParameterList const& list, std::string const& path,
                           Expression::Tables const& of_list)
{
  for (auto const& each : list) {
    auto const name = joinPath(path, each.first);
    auto const info = parameterInfo(each.second);
    // A value of a region has no information of its own.
    auto const tables = info.is_null() ? of_list : info->tables;
    if (list.isSublist(each.first)) {
      collect(list.sublist(each.first), name, tables);
    } else if (list.isType<std::string>(each.first)) {
      auto const& text = list.get<std::string>(each.first);
      auto const compared = timesComparedIn(text);
      times_.insert(times_.end(), compared.begin(), compared.end());
      std::shared_ptr<const Expression> load;
      for (const double centre : timesShiftedIn(text)) {
        load = load ? load : std::make_shared<const Expression>(text, name, tables);
        pulses_.push_back({centre, load, name});
      }
    }
  }
}

std::optional<Warning> SkippedTimes::note(double begin, double end)
{
  if (has_warned_) {
    return std::nullopt;
  }
  auto const warn = [&](std::string const& what) {
    has_warned_ = true;
    return Warning{"loads between two steps", "The step from t = " + formatShort(begin) + " s to " +
                                                formatShort(end) + " s passes " + what};
  };
  auto const first = std::upper_bound(times_.begin(), times_.end(), begin);
  auto const behind = std::upper_bound(first, times_.end(), end);
  if (behind - first >= 2) {
    return warn(formatShort(*first) + " s and " + formatShort(*(behind - 1)) +
                " s, with which expressions of the deck compare t. The run misses what loads "
                "do between these times. Name them in 'Time Stepping / Instants'.");
  }
  for (auto const& pulse : pulses_) {
    if (begin < pulse.centre && pulse.centre < end && isPassed(pulse, begin, end)) {
      return warn(formatShort(pulse.centre) + " s, where " + pulse.path +
                  " has a pulse that the ends of the step do not see. Name times before, in and "
                  "after it in 'Time Stepping / Instants'.");
    }
  }
  return std::nullopt;
}

// A value between those at the ends of the step does not count, since the step sees a part of it. A
// pulse is outside of them by more than a tenth of the largest value.
bool SkippedTimes::isPassed(Pulse const& pulse, double begin, double end) const
{
  double largest = 0, outside = 0;
  for (auto const& place : places_) {
    try {
      const double at_begin = (*pulse.load)(place, begin), at_end = (*pulse.load)(place, end);
      const double inside = (*pulse.load)(place, pulse.centre);
      auto const [low, high] = std::minmax(at_begin, at_end);
      largest = std::max({largest, std::abs(low), std::abs(high), std::abs(inside)});
      outside = std::max({outside, inside - high, low - inside});
    } catch (InputError const&) { // a table has no value where the load does not act
      continue;
    }
  }
  constexpr double share = 0.1;
  return maxOverRanks(outside, *communicator_) > share * maxOverRanks(largest, *communicator_);
}
} // namespace asperity::scenario

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "skipped_times",
                  asperity::dynamics::WatchKindOf<asperity::scenario::SkippedTimes>)
