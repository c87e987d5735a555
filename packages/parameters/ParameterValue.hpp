#pragma once

#include "base/Text.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterEntry.hpp>
#include <Teuchos_ParameterList.hpp>

#include <optional>
#include <string>
#include <vector>

// Functions that look into a ParameterEntry without marking it as used.
namespace asperity
{
template <class T>
bool holds(Teuchos::ParameterEntry const& entry)
{
  return entry.getAny(false).type() == typeid(T);
}

// The entry must hold a T.
template <class T>
T const& get(Teuchos::ParameterEntry const& entry)
{
  return Teuchos::any_cast<T>(entry.getAny(false));
}

// Replaces the value alone; documentation and validator stay.
template <class T>
void replaceValue(Teuchos::ParameterEntry& entry, T const& value)
{
  entry.getAny(false) = Teuchos::any(value);
}

// Whether an entry of the completed list, or of a list in it, is given and not a default.
bool hasGivenEntry(Teuchos::ParameterList const& list);

// The names of the entries, in the order of the list.
std::vector<std::string> namesIn(Teuchos::ParameterList const& list);

// The number in an entry with an int or a double.
std::optional<double> numberIn(Teuchos::ParameterEntry const& entry);

// An entry with the array of what `read` finds between commas, nothing in an empty text; nullopt if
// it finds nothing, std::nullopt, in one of the pieces.
template <class Read>
std::optional<Teuchos::ParameterEntry> readArray(std::string const& text, Read const& read)
{
  Teuchos::Array<typename decltype(read(text))::value_type> elements;
  for (auto const& piece : trimmed(text).empty() ? std::vector<std::string>() : split(text, ',')) {
    const auto element = read(piece);
    if (!element) {
      return std::nullopt;
    }
    elements.push_back(*element);
  }
  return Teuchos::ParameterEntry(elements);
}

// The value as a deck writes it: 0.015, true, {1, 2}; a string without quotes; "a list" for a list.
std::string plainText(Teuchos::ParameterEntry const& entry);

// The same for messages, with strings in quotes, and long ones shortened.
std::string valueText(Teuchos::ParameterEntry const& entry);

// "a real number", "an integer", "a text", ...
std::string typeText(Teuchos::ParameterEntry const& entry);

// The type's name in XML: "double", "Array(int)", ...; "" for lists and types Teuchos cannot write.
std::string xmlType(Teuchos::ParameterEntry const& entry);
} // namespace asperity
