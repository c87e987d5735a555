#include "parameters/ParameterInfo.hpp"

#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/RangeText.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <ostream>

namespace asperity
{
using Teuchos::Array;
using Teuchos::ParameterEntry;
using Teuchos::RCP;

namespace
{
bool isOfKind(ParameterEntry const& entry, ParameterKind kind)
{
  switch (kind) {
  case ParameterKind::real: return holds<double>(entry) || holds<int>(entry);
  case ParameterKind::integer: return holds<int>(entry);
  case ParameterKind::boolean: return holds<bool>(entry);
  case ParameterKind::text:
  case ParameterKind::file_name:
  case ParameterKind::choice: return holds<std::string>(entry);
  case ParameterKind::field:
    return holds<double>(entry) || holds<int>(entry) || holds<std::string>(entry) || entry.isList();
  case ParameterKind::real_array: return holds<Array<double>>(entry) || holds<Array<int>>(entry);
  case ParameterKind::integer_array: return holds<Array<int>>(entry);
  case ParameterKind::text_array: return holds<Array<std::string>>(entry);
  case ParameterKind::sublist:
  case ParameterKind::open_sublist:
  case ParameterKind::foreign_sublist:
  case ParameterKind::alternative: return entry.isList();
  }
  return false;
}
} // namespace

std::string ParameterInfo::rangeText() const
{
  return isDimensionless() ? textOf(range) : textOf(range) + " " + unit;
}

std::string ParameterInfo::allowed() const
{
  const std::string in_range = " in " + rangeText();
  switch (kind) {
  case ParameterKind::real: return "a number" + in_range;
  case ParameterKind::integer: return "an integer" + in_range;
  case ParameterKind::boolean: return "true or false";
  case ParameterKind::text: return "a text";
  case ParameterKind::file_name: return "the name of a file";
  case ParameterKind::choice: return "one of " + quotedAlternatives(words);
  case ParameterKind::field:
    return std::string("a number, an expression in x, y, z, t") +
           (takes_datasets ? ", \"file.h5:/dataset\"" : "") + " or a list of regions," + in_range;
  case ParameterKind::real_array: return "an array of numbers" + in_range;
  case ParameterKind::integer_array: return "an array of integers" + in_range;
  case ParameterKind::text_array: return "an array of texts";
  default: return "a list";
  }
}

void ParameterInfo::refuse(std::string const& path, std::string const& value,
                           std::string const& reason) const
{
  throw InputError(path + " = " + value + " " + reason + (hint.empty() ? "" : " " + hint));
}

void ParameterInfo::check(ParameterEntry const& entry, std::string const& path) const
{
  if (!isOfKind(entry, kind)) {
    refuse(path, valueText(entry), "is " + typeText(entry) + ", but " + allowed() + " is wanted.");
  }
  if (const auto number = numberIn(entry)) {
    checkRange(*number, path);
  } else if (kind == ParameterKind::choice) {
    const auto& word = get<std::string>(entry);
    if (std::find(words.begin(), words.end(), word) == words.end()) {
      const std::string nearest = nearestName(word, words);
      refuse(path, valueText(entry),
             "is not " + allowed() + "." +
               (nearest.empty() ? "" : " Did you mean '" + nearest + "'?"));
    }
  } else if (kind == ParameterKind::field && entry.isList()) {
    checkRegions(get<ParameterList>(entry), path);
  } else {
    checkArray(entry, path);
  }
}

void ParameterInfo::checkRange(double value, std::string const& path) const
{
  if (!range.contains(value)) {
    refuse(path, formatNumber(value), "is outside " + rangeText() + ".");
  }
}

void ParameterInfo::checkArray(ParameterEntry const& entry, std::string const& path) const
{
  const auto check_numbers = [&](auto const& numbers) {
    for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
      checkRange(numbers[i], path + "[" + std::to_string(i) + "]");
    }
  };
  if (holds<Array<double>>(entry)) {
    check_numbers(get<Array<double>>(entry));
  } else if (holds<Array<int>>(entry)) {
    check_numbers(get<Array<int>>(entry));
  }
}

void ParameterInfo::checkRegions(ParameterList const& regions, std::string const& path) const
{
  for (auto const& item : regions) {
    const std::string region_path = joinPath(path, item.first);
    if (item.second.isList()) {
      refuse(region_path, valueText(item.second),
             "is a list, but a number or an expression is wanted.");
    }
    check(item.second, region_path);
  }
}

void ParameterInfo::convert(ParameterEntry& entry) const
{
  if (kind == ParameterKind::field && entry.isList()) {
    auto& regions = Teuchos::getValue<ParameterList>(entry);
    for (auto const& region : namesIn(regions)) {
      convert(regions.getEntry(region));
    }
  } else if ((kind == ParameterKind::real || kind == ParameterKind::field) && holds<int>(entry)) {
    replaceValue(entry, static_cast<double>(get<int>(entry)));
  } else if (kind == ParameterKind::real_array && holds<Array<int>>(entry)) {
    auto const& integers = get<Array<int>>(entry);
    replaceValue(entry, Array<double>(integers.begin(), integers.end()));
  }
}

void ParameterInfo::printDoc(std::string const& meaning, std::ostream& out) const
{
  out << "# " << meaning << " Allowed: " << allowed() << ".\n";
}

Teuchos::ParameterEntryValidator::ValidStringsList ParameterInfo::validStringValues() const
{
  return words.empty() ? Teuchos::null : Teuchos::rcp(new Array<std::string>(words));
}

// Teuchos calls this from ParameterList::set; its list names read "Asperity->Friction".
void ParameterInfo::validate(ParameterEntry const& entry, std::string const& name,
                             std::string const& list_name) const
{
  std::string path = list_name;
  for (auto arrow = path.find("->"); arrow != std::string::npos; arrow = path.find("->")) {
    path.replace(arrow, 2, " / ");
  }
  check(entry, joinPath(path, name));
}

RCP<const ParameterInfo> parameterInfo(ParameterEntry const& entry)
{
  return Teuchos::rcp_dynamic_cast<const ParameterInfo>(entry.validator());
}

RCP<const ParameterInfo> parameterInfo(ParameterList const& list, std::string const& name)
{
  const ParameterEntry* entry = list.getEntryPtr(name);
  return entry ? parameterInfo(*entry) : Teuchos::null;
}
} // namespace asperity
