#include "parameters/UnreadEntries.hpp"

#include "parameters/Alternatives.hpp"
#include "parameters/ParameterValue.hpp"

namespace asperity
{
namespace
{
// All entries of a list that was not selected.
void addAll(ParameterList const& list, UnreadEntry const& from, std::vector<UnreadEntry>& unread)
{
  for (auto const& name : namesIn(list)) {
    UnreadEntry entry = from;
    entry.path = joinPath(from.path, name);
    if (list.isSublist(name)) {
      addAll(list.sublist(name), entry, unread);
    } else {
      unread.push_back(entry);
    }
  }
}

void add(ParameterList const& list, ParameterList const& with_all, std::string const& path,
         std::vector<UnreadEntry>& unread)
{
  auto const valid = withChosenEntries(with_all, list, path);
  for (auto const& name : namesIn(*valid)) {
    auto const info = parameterInfo(*valid, name);
    if (info->kind != ParameterKind::sublist || !list.isSublist(name)) {
      continue;
    }
    auto const& choice = info->chosen_by;
    if (!choice.empty()) {
      auto const taken = chosenWord(*valid, list, choice, path);
      if (taken != name) {
        addAll(list.sublist(name), {joinPath(path, name), joinPath(path, choice), name, taken},
               unread);
        continue;
      }
    }
    add(list.sublist(name), valid->sublist(name), joinPath(path, name), unread);
  }
}
} // namespace

std::vector<UnreadEntry> unreadEntries(ParameterList const& list, ParameterList const& valid,
                                       std::string const& path)
{
  std::vector<UnreadEntry> unread;
  add(list, valid, path, unread);
  return unread;
}
} // namespace asperity
