#include "base/parameters/Alternatives.hpp"

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

// An entry without a default needs a value, too: `empty` then only gives the type.
template <class T>
void addValue(ParameterList& list, std::string const& name, DefaultOr<T> const& value,
              T const& empty, std::string const& meaning, RCP<ParameterInfo> const& info)
{
  ASPERITY_ASSERT(!list.isParameter(name));
  info->presence = value.value()        ? Presence::has_default
                   : value.isRequired() ? Presence::is_required
                                        : Presence::is_optional;
  list.set(name, value.value().value_or(empty), meaning);
  list.getEntry(name).setValidator(info);
  if (value.value()) {
    info->check(list.getEntry(name), "The default of " + name);
  }
}

template <class T>
DefaultOr<Teuchos::Array<T>> asTeuchosArray(DefaultOr<std::vector<T>> const& value)
{
  if (value.value()) {
    return Teuchos::Array<T>(*value.value());
  }
  return value.isRequired() ? DefaultOr<Teuchos::Array<T>>(required)
                            : DefaultOr<Teuchos::Array<T>>(optional);
}

void addList(ParameterList& list, std::string const& name, ParameterList const& content,
             std::string const& meaning, RCP<ParameterInfo> const& info)
{
  ASPERITY_ASSERT(!list.isParameter(name));
  ParameterList& sublist = list.sublist(name, false, meaning);
  const std::string full_name = sublist.name();
  sublist = content;
  sublist.setName(full_name);
  list.getEntry(name).setValidator(info);
}
} // namespace

Declare::Declare() : list_(rcp(new ParameterList)) {}

Declare::Declare(ParameterList& list) : list_(Teuchos::rcpFromRef(list)) {}

Declare& Declare::real(std::string const& name, DefaultOr<double> value, std::string const& unit,
                       Range range, std::string const& meaning)
{
  addValue(*list_, name, value, 0.0, meaning, makeInfo(ParameterKind::real, unit, range));
  last_ = name;
  return *this;
}

Declare& Declare::integer(std::string const& name, DefaultOr<int> value, Range range,
                          std::string const& meaning)
{
  addValue(*list_, name, value, 0, meaning, makeInfo(ParameterKind::integer, "-", range));
  last_ = name;
  return *this;
}

Declare& Declare::boolean(std::string const& name, DefaultOr<bool> value,
                          std::string const& meaning)
{
  addValue(*list_, name, value, false, meaning, makeInfo(ParameterKind::boolean));
  last_ = name;
  return *this;
}

Declare& Declare::text(std::string const& name, DefaultOr<std::string> const& value,
                       std::string const& meaning)
{
  addValue(*list_, name, value, std::string(), meaning, makeInfo(ParameterKind::text));
  last_ = name;
  return *this;
}

Declare& Declare::fileName(std::string const& name, DefaultOr<std::string> const& value,
                           std::string const& meaning)
{
  addValue(*list_, name, value, std::string(), meaning, makeInfo(ParameterKind::file_name));
  last_ = name;
  return *this;
}

Declare& Declare::choice(std::string const& name, DefaultOr<std::string> const& value,
                         std::vector<std::string> const& words, std::string const& meaning)
{
  auto info = makeInfo(ParameterKind::choice);
  info->words = words;
  addValue(*list_, name, value, std::string(), meaning, info);
  last_ = name;
  return *this;
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
    addList(*list_, word, *content, "For " + name + " = " + word + ".", info);
  }
  return *this;
}

Declare& Declare::entriesWith(std::string const& choice, std::string const& word,
                              RCP<const ParameterList> const& entries)
{
  const auto choice_info = parameterInfo(*list_, choice);
  ASPERITY_ASSERT(!choice_info.is_null() && choice_info->presence == Presence::has_default);
  auto info = makeInfo(ParameterKind::alternative);
  info->chosen_by = choice;
  info->words = {word};
  addList(*list_, choice + alternative_separator + word, *entries, "", info);
  return *this;
}

Declare& Declare::field(std::string const& name, DefaultOr<FieldValue> const& value,
                        std::string const& unit, Range range, std::string const& meaning)
{
  const auto info = makeInfo(ParameterKind::field, unit, range);
  if (value.value() && std::holds_alternative<std::string>(*value.value())) {
    addValue<std::string>(*list_, name, std::get<std::string>(*value.value()), "", meaning, info);
  } else if (value.value()) {
    addValue<double>(*list_, name, std::get<double>(*value.value()), 0.0, meaning, info);
  } else if (value.isRequired()) {
    addValue<double>(*list_, name, required, 0.0, meaning, info);
  } else {
    addValue<double>(*list_, name, optional, 0.0, meaning, info);
  }
  last_ = name;
  return *this;
}

Declare& Declare::realArray(std::string const& name, DefaultOr<std::vector<double>> const& value,
                            std::string const& unit, Range range, std::string const& meaning)
{
  addValue(*list_, name, asTeuchosArray(value), Teuchos::Array<double>(), meaning,
           makeInfo(ParameterKind::real_array, unit, range));
  last_ = name;
  return *this;
}

Declare& Declare::integerArray(std::string const& name, DefaultOr<std::vector<int>> const& value,
                               Range range, std::string const& meaning)
{
  addValue(*list_, name, asTeuchosArray(value), Teuchos::Array<int>(), meaning,
           makeInfo(ParameterKind::integer_array, "-", range));
  last_ = name;
  return *this;
}

Declare& Declare::textArray(std::string const& name,
                            DefaultOr<std::vector<std::string>> const& value,
                            std::string const& meaning)
{
  addValue(*list_, name, asTeuchosArray(value), Teuchos::Array<std::string>(), meaning,
           makeInfo(ParameterKind::text_array));
  last_ = name;
  return *this;
}

Declare& Declare::sublist(std::string const& name, RCP<const ParameterList> const& valid,
                          std::string const& meaning)
{
  addList(*list_, name, *valid, meaning, makeInfo(ParameterKind::sublist));
  last_ = name;
  return *this;
}

Declare& Declare::optionalSublist(std::string const& name, RCP<const ParameterList> const& valid,
                                  std::string const& meaning)
{
  auto info = makeInfo(ParameterKind::sublist);
  info->presence = Presence::is_optional;
  addList(*list_, name, *valid, meaning, info);
  last_ = name;
  return *this;
}

Declare& Declare::openSublist(std::string const& name, RCP<const ParameterList> const& each,
                              std::string const& meaning)
{
  ASPERITY_ASSERT(each->numParams() == 1);
  auto info = makeInfo(ParameterKind::open_sublist);
  addList(*list_, name, *each, meaning, info);
  last_ = name;
  return *this;
}

Declare& Declare::foreignSublist(std::string const& name, ParameterList const& defaults,
                                 std::string const& meaning)
{
  addList(*list_, name, defaults, meaning, makeInfo(ParameterKind::foreign_sublist));
  last_ = name;
  return *this;
}

// Only entries declared here have a ParameterInfo, and no other list shares it yet.
Declare& Declare::hint(std::string const& text)
{
  ASPERITY_ASSERT(!last_.empty());
  const auto info =
    Teuchos::rcp_dynamic_cast<const ParameterInfo>(list_->getEntry(last_).validator(), true);
  Teuchos::rcp_const_cast<ParameterInfo>(info)->hint = text;
  return *this;
}

std::string joinPath(std::string const& path, std::string const& name)
{
  return path.empty() ? name : path + " / " + name;
}
} // namespace asperity
