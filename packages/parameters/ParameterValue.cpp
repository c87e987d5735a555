#include "parameters/ParameterValue.hpp"

#include "base/Text.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterEntryXMLConverterDB.hpp>
#include <algorithm>

namespace asperity
{
using Teuchos::Array;
using Teuchos::ParameterEntry;

namespace
{
template <class T, class Format>
std::string arrayText(Array<T> const& values, Format format)
{
  std::string text = "{";
  for (int i = 0; i < static_cast<int>(values.size()); ++i) {
    text += (i == 0 ? "" : ", ") + format(values[i]);
  }
  return text + "}";
}
} // namespace

bool hasGivenEntry(Teuchos::ParameterList const& list)
{
  return std::any_of(list.begin(), list.end(), [](auto const& item) {
    Teuchos::ParameterEntry const& entry = item.second;
    return entry.isList() ? hasGivenEntry(get<Teuchos::ParameterList>(entry)) : !entry.isDefault();
  });
}

std::vector<std::string> namesIn(Teuchos::ParameterList const& list)
{
  std::vector<std::string> names;
  for (auto const& item : list) {
    names.push_back(item.first);
  }
  return names;
}

std::optional<double> numberIn(ParameterEntry const& entry)
{
  if (holds<double>(entry)) {
    return get<double>(entry);
  }
  return holds<int>(entry) ? std::optional<double>(get<int>(entry)) : std::nullopt;
}

std::string plainText(ParameterEntry const& entry)
{
  if (entry.isList()) {
    return "a list";
  }
  if (holds<std::string>(entry)) {
    return get<std::string>(entry);
  }
  if (holds<bool>(entry)) {
    return get<bool>(entry) ? "true" : "false";
  }
  if (holds<double>(entry)) {
    return formatNumber(get<double>(entry));
  }
  if (holds<Array<double>>(entry)) {
    return arrayText(get<Array<double>>(entry), formatNumber);
  }
  if (holds<Array<std::string>>(entry)) {
    return arrayText(get<Array<std::string>>(entry), [](std::string const& text) { return text; });
  }
  return Teuchos::toString(entry.getAny(false));
}

std::string valueText(ParameterEntry const& entry)
{
  const std::string text = excerpt(plainText(entry));
  return holds<std::string>(entry) ? "'" + text + "'" : text;
}

std::string typeText(ParameterEntry const& entry)
{
  if (entry.isList()) {
    return "a list";
  }
  if (holds<double>(entry)) {
    return "a real number";
  }
  if (holds<int>(entry)) {
    return "an integer";
  }
  if (holds<bool>(entry)) {
    return "a boolean";
  }
  if (holds<std::string>(entry)) {
    return "a text";
  }
  const std::string type = xmlType(entry);
  return type.empty() ? "of an unknown type" : "of type " + type;
}

std::string xmlType(ParameterEntry const& entry)
{
  if (entry.isList()) {
    return "";
  }
  try {
    const auto alone = Teuchos::rcp(new ParameterEntry(entry.getAny(false)));
    return Teuchos::ParameterEntryXMLConverterDB::getConverter(alone)->getTypeAttributeValue();
  } catch (std::exception const&) {
    return "";
  }
}
} // namespace asperity
