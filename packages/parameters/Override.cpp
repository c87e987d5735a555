#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "parameters/Alternatives.hpp"
#include "parameters/Deck.hpp"
#include "parameters/ParameterValue.hpp"

// --set "Path/To/Parameter=value"
namespace asperity
{
using Teuchos::ParameterEntry;
using Teuchos::RCP;

namespace
{
// The list of the deck at which a path has arrived, and the declarations for it. `valid` is null
// below lists whose names are not declared (foreign lists, the regions of a field).
struct Place
{
  ParameterList* list;
  RCP<const ParameterList> valid;
  RCP<const ParameterList> with_all; // `valid` with the entries of all words of its choices
  bool is_open;
  std::string path;
};

// Without that of the root list.
std::vector<std::string> namesOnPath(std::string const& path)
{
  auto names = split(path, '/');
  if (names.size() > 1 && names.front() == "Asperity") {
    names.erase(names.begin());
  }
  return names;
}

ParameterEntry guessed(std::string const& value)
{
  if (value == "true" || value == "false") {
    return ParameterEntry(value == "true");
  }
  if (const auto integer = readInteger(value)) {
    return ParameterEntry(*integer);
  }
  if (const auto number = readNumber(value)) {
    return ParameterEntry(*number);
  }
  return ParameterEntry(value);
}

// Braces may be left out. A text that is no such array stays: the check that follows refuses it.
template <class Read>
ParameterEntry arrayOrText(std::string const& value, Read const& read)
{
  return readArray(insideBraces(value).value_or(value), read).value_or(ParameterEntry(value));
}

// The value in the declared type if the text can be read that way; otherwise in the guessed type,
// which the check then refuses.
ParameterEntry readAs(ParameterKind kind, std::string const& value)
{
  switch (kind) {
  case ParameterKind::text:
  case ParameterKind::file_name:
  case ParameterKind::choice: return ParameterEntry(value);
  case ParameterKind::real:
  case ParameterKind::field:
    if (const auto number = readNumber(value)) {
      return ParameterEntry(*number);
    }
    return ParameterEntry(value);
  case ParameterKind::real_array: return arrayOrText(value, readNumber);
  case ParameterKind::integer_array: return arrayOrText(value, readInteger);
  case ParameterKind::text_array:
    return arrayOrText(value, [](std::string const& piece) { return std::optional(piece); });
  default: return guessed(value);
  }
}

// In a foreign list the type is that of the existing entry.
ParameterEntry readLike(ParameterList const& list, std::string const& name,
                        std::string const& value, std::string const& path)
{
  const ParameterEntry entry = guessed(value);
  if (!list.isParameter(name)) {
    return entry;
  }
  auto const& old = list.getEntry(name);
  if (holds<std::string>(old)) {
    return ParameterEntry(value);
  }
  if (holds<double>(old) && numberIn(entry)) {
    return ParameterEntry(*numberIn(entry));
  }
  ASPERITY_REQUIRE(old.getAny(false).type() == entry.getAny(false).type(),
                   path << " = " << valueText(entry) << " is " << typeText(entry) << ", but "
                        << typeText(old) << " is there.");
  return entry;
}

// The declaration of a name here; null below foreign lists.
ParameterEntry const* declaration(Place const& place, std::string const& name)
{
  if (place.valid.is_null()) {
    return nullptr;
  }
  if (place.is_open) {
    return &place.valid->entry(place.valid->begin());
  }
  if (!place.valid->isParameter(name)) {
    refuseUnknownName(*place.valid, *place.with_all, place.path, name);
  }
  return &place.valid->getEntry(name);
}

RCP<const ParameterInfo> infoOf(ParameterEntry const* declared)
{
  return declared ? parameterInfo(*declared) : Teuchos::null;
}

// Goes one list down. A field counts as a list, too: its list has one value per region.
Place descend(Place const& place, std::string const& name)
{
  const std::string path = joinPath(place.path, name);
  ParameterEntry const* declared = declaration(place, name);
  const auto info = infoOf(declared);
  const bool is_field = !info.is_null() && info->kind == ParameterKind::field;
  ASPERITY_REQUIRE(!declared || declared->isList() || is_field,
                   path << " is no list; it has no parameters.");
  if (place.list->isParameter(name) && !place.list->isSublist(name)) {
    ASPERITY_REQUIRE(is_field, path << " = " << valueText(place.list->getEntry(name))
                                    << " is no list; it has no parameters.");
    place.list->remove(name);
  }
  ParameterList& list = place.list->sublist(name);
  if (!declared || is_field || info->kind == ParameterKind::foreign_sublist) {
    return {&list, Teuchos::null, Teuchos::null, false, path};
  }
  auto const with_all = Teuchos::rcp(new ParameterList(get<ParameterList>(*declared)));
  return {&list, withChosenEntries(*with_all, list, path), with_all,
          info->kind == ParameterKind::open_sublist, path};
}

void setValue(Place const& place, std::string const& name, std::string const& value)
{
  const std::string path = joinPath(place.path, name);
  ParameterEntry const* declared = declaration(place, name);
  ASPERITY_REQUIRE(!declared || !declared->isList(), path << " is a list; name a parameter in it.");
  const auto info = infoOf(declared);
  if (info.is_null()) {
    place.list->setEntry(name, readLike(*place.list, name, value, path));
    return;
  }
  const ParameterEntry entry = readAs(info->kind, value);
  const bool may_be_computed =
    info->kind == ParameterKind::real || info->kind == ParameterKind::real_array;
  if (!may_be_computed || !holds<std::string>(entry)) {
    info->check(entry, path);
  }
  place.list->setEntry(name, entry);
}
} // namespace

void removeEntry(ParameterList& list, std::string const& path_text)
{
  auto const names = namesOnPath(path_text);
  ParameterList* place = &list;
  std::string path = "Asperity";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_last = i + 1 == names.size();
    path = joinPath(path, names[i]);
    ASPERITY_REQUIRE(is_last ? place->isParameter(names[i]) : place->isSublist(names[i]),
                     "--remove '" << path_text << "': the deck has no "
                                  << (is_last ? "entry " : "list ") << path << "."
                                  << didYouMean(names[i], namesIn(*place)));
    if (!is_last) {
      place = &place->sublist(names[i]);
    }
  }
  place->remove(names.back());
}

void applyOverride(ParameterList& list, ParameterList const& valid, std::string const& assignment)
{
  const auto equals = assignment.find('=');
  ASPERITY_REQUIRE(equals != std::string::npos && !trimmed(assignment.substr(0, equals)).empty(),
                   "--set '" << assignment << "' is not of the form \"Path/To/Parameter=value\".");
  auto const names = namesOnPath(assignment.substr(0, equals));
  Place place{&list, withChosenEntries(valid, list, "Asperity"), Teuchos::rcpFromRef(valid), false,
              "Asperity"};
  for (std::size_t i = 0; i + 1 < names.size(); ++i) {
    place = descend(place, names[i]);
  }
  setValue(place, names.back(), trimmed(assignment.substr(equals + 1)));
}
} // namespace asperity
