#include "parameters/Alternatives.hpp"

#include "base/NearestName.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/RangeText.hpp"

#include <stdexcept>

namespace asperity
{
using Teuchos::ParameterEntry;
using Teuchos::RCP;
using Teuchos::rcp;

bool isAlternative(ParameterEntry const& declared)
{
  const auto info = parameterInfo(declared);
  return !info.is_null() && info->kind == ParameterKind::alternative;
}

std::string chosenWord(ParameterList const& valid, ParameterList const& list,
                       std::string const& choice, std::string const& path)
{
  ParameterEntry const* given = list.getEntryPtr(choice);
  if (!given) {
    return get<std::string>(valid.getEntry(choice));
  }
  parameterInfo(valid, choice)->check(*given, joinPath(path, choice));
  return get<std::string>(*given);
}

namespace
{
// "Law = Mine or Law = Yours": the words of choices that bring an entry of the name.
std::string choicesWithEntry(ParameterList const& valid, std::string const& name)
{
  std::string text;
  for (auto const& item : valid) {
    if (isAlternative(item.second) && get<ParameterList>(item.second).isParameter(name)) {
      text += (text.empty() ? "" : " or ") + item.first;
    }
  }
  return text;
}

[[noreturn]] void refusePair(std::string const& path, std::string const& reason)
{
  throw std::logic_error(path + ": two of the chosen plugins declare this parameter, " + reason +
                         " Choose others, or change one of the plugins.");
}

// Merges both declarations of an entry into `first`.
void join(ParameterEntry& first, ParameterEntry const& second, std::string const& path)
{
  const auto one = parameterInfo(first), two = parameterInfo(second);
  if (one->kind != two->kind || one->unit != two->unit) {
    refusePair(path, "one as " + one->allowed() + ", one as " + two->allowed() + ".");
  }
  if (one->presence != two->presence || valueText(first) != valueText(second)) {
    const auto text = [](ParameterInfo const& info, ParameterEntry const& entry) {
      return info.presence == Presence::has_default ? "the default " + valueText(entry)
                                                    : std::string("no default");
    };
    refusePair(path, "one with " + text(*one, first) + ", one with " + text(*two, second) + ".");
  }
  auto both = rcp(new ParameterInfo(*one));
  both->range = one->range.intersection(two->range);
  if (both->range.isEmpty()) {
    refusePair(path, "one in " + textOf(one->range) + ", one in " + textOf(two->range) +
                       ": no number is in both.");
  }
  first.setValidator(both);
}
} // namespace

RCP<const ParameterList> withChosenEntries(ParameterList const& valid, ParameterList const& list,
                                           std::string const& path)
{
  auto result = rcp(new ParameterList(valid.name()));
  const auto add = [&](std::string const& name, ParameterEntry const& entry) {
    if (result->isParameter(name)) {
      join(result->getEntry(name), entry, joinPath(path, name));
    } else {
      result->setEntry(name, entry);
    }
  };
  for (auto const& item : valid) {
    if (!isAlternative(item.second)) {
      add(item.first, item.second);
      continue;
    }
    const auto info = parameterInfo(item.second);
    if (chosenWord(valid, list, info->chosen_by, path) == info->words.front()) {
      for (auto const& entry : get<ParameterList>(item.second)) {
        add(entry.first, entry.second);
      }
    }
  }
  return result;
}

void refuseUnknownName(ParameterList const& chosen, ParameterList const& valid,
                       std::string const& path, std::string const& name)
{
  const std::string choices = choicesWithEntry(valid, name);
  throw InputError(joinPath(path, name) + " is unknown" +
                   (choices.empty() ? "." + didYouMean(name, namesIn(chosen))
                                    : " here: it is a parameter of " + choices + "."));
}
} // namespace asperity
