#include "scenario/DeckRemarks.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/UnreadEntries.hpp"
#include "parameters/fields/Expression.hpp"
#include "scenario/DeckParameters.hpp"
#include "scenario/deck/DeckAssembly.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace asperity::scenario
{
namespace
{
// No quantity of an earthquake is larger than this in SI units.
constexpr double large = 1e100;
constexpr std::size_t most_named = 3;

// In a number, an array or an expression: "1e308", "{1, 1e308}", "x < 1e308 ? a : b".
bool hasLargeNumber(std::string const& text)
{
  auto const parts = formulaParts(text);
  return std::any_of(parts.begin(), parts.end(), [](auto const& part) {
    return part.is_number && readNumber(part.text).value_or(0) > large;
  });
}

// Calls visit(path, text) for each entry of the list and its sublists, in their order. The path is
// that of messages, the text what the user wrote.
template <class Visit>
void visitTexts(ParameterList const& list, std::string const& path, Visit const& visit)
{
  for (auto const& name : namesIn(list)) {
    auto const where = joinPath(path, name);
    if (list.isSublist(name)) {
      visitTexts(list.sublist(name), where, visit);
    } else {
      visit(where, plainText(list.getEntry(name)));
    }
  }
}

std::map<std::string, std::string> textsOf(ParameterList const& list)
{
  std::map<std::string, std::string> texts;
  visitTexts(list, "",
             [&](std::string const& path, std::string const& text) { texts[path] = text; });
  return texts;
}

std::set<std::string> pathsOf(std::vector<UnreadEntry> const& entries)
{
  std::set<std::string> paths;
  for (auto const& entry : entries) {
    paths.insert(entry.path);
  }
  return paths;
}

// Takes out of `unread` the entries that have the same text in `before`, the deck without overlays
// and overrides, and in `given`, the deck with them, unless they were unread in `before`, too.
void removeFormer(ParameterList const& before, ParameterList const& given,
                  std::set<std::string> const& unread_before, std::vector<UnreadEntry>& unread)
{
  auto const former = textsOf(before), texts = textsOf(given);
  const auto is_former = [&](UnreadEntry const& entry) {
    auto const text = former.find(entry.path), now = texts.find(entry.path);
    return text != former.end() && now != texts.end() && text->second == now->second &&
           unread_before.count(entry.path) == 0;
  };
  unread.erase(std::remove_if(unread.begin(), unread.end(), is_former), unread.end());
}

Warning warningOf(std::vector<UnreadEntry> const& unread)
{
  std::string text;
  for (std::size_t i = 0; i < unread.size() && i < most_named; ++i) {
    auto const& entry = unread[i];
    text += (i == 0 ? "" : " ") + entry.path + " has no effect: only " + entry.choice + " = " +
            entry.word + " reads it, but it is " + entry.taken + ".";
  }
  if (unread.size() > most_named) {
    text += " And " + std::to_string(unread.size() - most_named) + " more of them.";
  }
  return {"unread parameters", text + " Change the choice, or remove the entries."};
}
} // namespace

std::optional<Warning> warnOfUnreadEntries(CommandLine const& command_line,
                                           ParameterList const& complete)
{
  auto const valid = deckParameters();
  auto unread = unreadEntries(complete, *valid);
  if (unread.empty()) {
    return std::nullopt;
  }
  try {
    auto const given = deckAsGiven(command_line, *valid).list;
    auto const texts = textsOf(*given);
    unread.erase(std::remove_if(unread.begin(), unread.end(),
                                [&](auto const& entry) { return texts.count(entry.path) == 0; }),
                 unread.end()); // defaults
    CommandLine line = command_line;
    line.removals.clear();
    line.overrides.clear();
    line.overlays.clear();
    for (auto next = command_line.overlays.begin();; ++next) {
      auto const before = deckAsGiven(line, *valid).list;
      const bool has_warned = !command_line.restart.empty() && line.overlays.empty();
      removeFormer(*before, *given,
                   has_warned ? std::set<std::string>() : pathsOf(unreadEntries(*before, *valid)),
                   unread);
      if (next == command_line.overlays.end()) {
        break;
      }
      line.overlays.push_back(*next);
    }
  } catch (InputError const&) {
    return std::nullopt;
  }
  return unread.empty() ? std::nullopt : std::optional<Warning>(warningOf(unread));
}

std::string remarkOnLargeValues(CommandLine const& command_line, std::string const& message)
{
  std::vector<std::string> found;
  try {
    visitTexts(*deckAsGiven(command_line, *deckParameters()).list, "",
               [&](std::string const& path, std::string const& text) {
                 if (hasLargeNumber(text) && message.find(path) == std::string::npos) {
                   found.push_back(path + " = " + excerpt(text));
                 }
               });
  } catch (InputError const&) { // the deck cannot be read: `message` says so
    return "";
  }
  if (found.empty()) {
    return "";
  }
  std::string line = "\nThe deck has numbers beyond 1e100: " + found.front();
  for (std::size_t i = 1; i < found.size() && i < most_named; ++i) {
    line += ", " + found[i];
  }
  return line + (found.size() > most_named
                   ? " and " + std::to_string(found.size() - most_named) + " more."
                   : ".");
}
} // namespace asperity::scenario
