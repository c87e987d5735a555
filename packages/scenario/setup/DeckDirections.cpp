#include "scenario/setup/DeckDirections.hpp"

#include "io/OutputSet.hpp"
#include "scenario/setup/DeckPaths.hpp"

namespace asperity::scenario
{
bool isLeftOut(ParameterList const& list, std::string const& name)
{
  auto const* entry = list.getEntryPtr(name);
  return entry == nullptr || entry->isDefault(); // as completeDirections() writes it
}

std::optional<std::vector<double>> givenUp(ParameterList const& output)
{
  return isLeftOut(output, io::DirectionUp::entry) ? std::nullopt
                                                   : io::DirectionUp::from(output).up;
}

void completeDirections(ParameterList& deck, int dimension, std::array<double, 3> const& up)
{
  const auto set = [](ParameterList& list, char const* name, std::vector<double> const& value) {
    if (isLeftOut(list, name)) {
      list.setEntry(name, Teuchos::ParameterEntry(Teuchos::Array<double>(value), true));
    }
  };
  set(deck.sublist(deck_lists::output), io::DirectionUp::entry,
      std::vector<double>{up[0], up[1], up[2]});
  std::vector<double> down = {0. - up[0], 0. - up[1]}; // 0 where up is 0, not -0
  if (dimension == 3 && up[2] != 0) {
    down.push_back(0. - up[2]);
  }
  set(deck.sublist(deck_lists::bulk), gravity_direction_entry, down);
}
} // namespace asperity::scenario
