#include "parameters/Alternatives.hpp"

#include <Teuchos_Array.hpp>

namespace asperity
{
using Teuchos::RCP;
using Teuchos::rcp;

namespace
{
RCP<ParameterInfo> makeInfo(ParameterKind kind, std::string const& unit = "-",
                            Range range = Range::any())
{
  auto info = rcp(new ParameterInfo);
  info->kind = kind;
  info->unit = unit;
  info->range = range;
  return info;
}

} // namespace

Declare::Declare() : list_(rcp(new ParameterList)) {}

Declare::Declare(ParameterList& list) : list_(Teuchos::rcpFromRef(list)) {}

// An entry without a default needs a value, too: it then only gives the type.
template <class Stored, class T>
Declare& Declare::addValue(std::string const& name, DefaultOr<T> const& value,
                           std::string const& meaning, RCP<ParameterInfo> const& info)
{
  ASPERITY_ASSERT(!list_->isParameter(name));
  info->presence = value.value()        ? Presence::has_default
                   : value.isRequired() ? Presence::is_required
                                        : Presence::is_optional;
  list_->set(name, value.value() ? Stored(*value.value()) : Stored(), meaning);
  list_->getEntry(name).setValidator(info);
  if (value.value()) {
    info->check(list_->getEntry(name), "The default of " + name);
  }
  last_ = name;
  return *this;
}

Declare& Declare::addList(std::string const& name, ParameterList const& content,
                          std::string const& meaning, RCP<ParameterInfo> const& info)
{
  ASPERITY_ASSERT(!list_->isParameter(name));
  ParameterList& sublist = list_->sublist(name, false, meaning);
  const std::string full_name = sublist.name();
  sublist = content;
  sublist.setName(full_name);
  list_->getEntry(name).setValidator(info);
  last_ = name;
  return *this;
}

Declare& Declare::real(std::string const& name, DefaultOr<double> value, std::string const& unit,
                       Range range, std::string const& meaning)
{
  return addValue<double>(name, value, meaning, makeInfo(ParameterKind::real, unit, range));
}

Declare& Declare::integer(std::string const& name, DefaultOr<int> value, Range range,
                          std::string const& meaning)
{
  return addValue<int>(name, value, meaning, makeInfo(ParameterKind::integer, "-", range));
}

Declare& Declare::boolean(std::string const& name, DefaultOr<bool> value,
                          std::string const& meaning)
{
  return addValue<bool>(name, value, meaning, makeInfo(ParameterKind::boolean));
}

Declare& Declare::text(std::string const& name, DefaultOr<std::string> const& value,
                       std::string const& meaning)
{
  return addValue<std::string>(name, value, meaning, makeInfo(ParameterKind::text));
}

Declare& Declare::fileName(std::string const& name, DefaultOr<std::string> const& value,
                           std::string const& meaning)
{
  return addValue<std::string>(name, value, meaning, makeInfo(ParameterKind::file_name));
}

Declare& Declare::choice(std::string const& name, DefaultOr<std::string> const& value,
                         std::vector<std::string> const& words, std::string const& meaning)
{
  auto info = makeInfo(ParameterKind::choice);
  info->words = words;
  return addValue<std::string>(name, value, meaning, info);
}

Declare& Declare::choiceOfLists(std::string const& name, DefaultOr<std::string> const& value,
                                std::vector<NamedList> const& lists, std::string const& meaning)
{
  std::vector<std::string> words;
  words.reserve(lists.size());
  for (auto const& named : lists) {
    words.push_back(named.first);
  }
  choice(name, value, words, meaning);
  for (auto const& [word, content] : lists) {
    auto info = makeInfo(ParameterKind::sublist);
    info->chosen_by = name;
    addList(word, *content, "For " + name + " = " + word + ".", info);
  }
  last_ = name;
  return *this;
}

Declare& Declare::entriesWith(std::string const& choice, std::string const& word,
                              RCP<const ParameterList> const& entries)
{
  const auto choice_info = parameterInfo(*list_, choice);
  ASPERITY_ASSERT(!choice_info.is_null() && choice_info->presence != Presence::is_optional);
  auto info = makeInfo(ParameterKind::alternative);
  info->chosen_by = choice;
  info->words = {word};
  return addList(choice + alternative_separator + word, *entries, "", info);
}

Declare& Declare::field(std::string const& name, DefaultOr<FieldValue> const& value,
                        std::string const& unit, Range range, std::string const& meaning)
{
  const auto info = makeInfo(ParameterKind::field, unit, range);
  if (!value.value()) {
    return addValue<double>(
      name, value.isRequired() ? DefaultOr<double>(required) : DefaultOr<double>(optional), meaning,
      info);
  }
  if (auto const* text = std::get_if<std::string>(&*value.value())) {
    return addValue<std::string>(name, DefaultOr<std::string>(*text), meaning, info);
  }
  return addValue<double>(name, DefaultOr<double>(std::get<double>(*value.value())), meaning, info);
}

Declare& Declare::realArray(std::string const& name, DefaultOr<std::vector<double>> const& value,
                            std::string const& unit, Range range, std::string const& meaning)
{
  return addValue<Teuchos::Array<double>>(name, value, meaning,
                                          makeInfo(ParameterKind::real_array, unit, range));
}

Declare& Declare::integerArray(std::string const& name, DefaultOr<std::vector<int>> const& value,
                               Range range, std::string const& meaning)
{
  return addValue<Teuchos::Array<int>>(name, value, meaning,
                                       makeInfo(ParameterKind::integer_array, "-", range));
}

Declare& Declare::textArray(std::string const& name,
                            DefaultOr<std::vector<std::string>> const& value,
                            std::string const& meaning)
{
  return addValue<Teuchos::Array<std::string>>(name, value, meaning,
                                               makeInfo(ParameterKind::text_array));
}

Declare& Declare::sublist(std::string const& name, RCP<const ParameterList> const& valid,
                          std::string const& meaning)
{
  return addList(name, *valid, meaning, makeInfo(ParameterKind::sublist));
}

Declare& Declare::openSublist(std::string const& name, RCP<const ParameterList> const& each,
                              std::string const& meaning)
{
  ASPERITY_ASSERT(each->numParams() == 1);
  return addList(name, *each, meaning, makeInfo(ParameterKind::open_sublist));
}

Declare& Declare::foreignSublist(std::string const& name, ParameterList const& defaults,
                                 std::string const& meaning)
{
  return addList(name, defaults, meaning, makeInfo(ParameterKind::foreign_sublist));
}

// Only entries declared here have a ParameterInfo, and no other list shares it yet.
Declare& Declare::hint(std::string const& text)
{
  ASPERITY_ASSERT(!last_.empty());
  Teuchos::rcp_const_cast<ParameterInfo>(parameterInfo(*list_, last_))->hint = text;
  return *this;
}

Declare& Declare::withoutDatasets()
{
  ASPERITY_ASSERT(!last_.empty());
  Teuchos::rcp_const_cast<ParameterInfo>(parameterInfo(*list_, last_))->takes_datasets = false;
  return *this;
}

std::string joinPath(std::string const& path, std::string const& name)
{
  return path.empty() ? name : path + " / " + name;
}

bool isGiven(ParameterList const& list, std::string const& name)
{
  return list.isParameter(name) || list.isSublist(name);
}
} // namespace asperity
