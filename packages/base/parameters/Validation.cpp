#include "base/parameters/Alternatives.hpp"
#include "base/parameters/ParameterValue.hpp"

namespace asperity
{
namespace
{
// A list that its choice has not selected is checked but not completed.
enum class Completion
{
  full,
  none
};

void process(ParameterList& list, ParameterList const& valid, std::string const& path,
             Completion completion);

void refuseUnknownNames(ParameterList const& list, ParameterList const& valid,
                        ParameterList const& with_all, std::string const& path)
{
  for (auto const& name : namesIn(list)) {
    if (!valid.isParameter(name)) {
      refuseUnknownName(valid, with_all, path, name);
    }
  }
}

[[noreturn]] void refuseMissing(std::string const& path, Teuchos::ParameterEntry const& declared,
                                ParameterInfo const& info)
{
  throw InputError(path + " is missing; " + info.allowed() + " is wanted. " + declared.docString() +
                   (info.hint.empty() ? "" : " " + info.hint));
}

// parameters.xml says which values are the defaults, whether the deck gives them or not.
void markDefault(Teuchos::ParameterEntry& entry)
{
  const auto validator = entry.validator();
  const auto doc_string = entry.docString();
  const auto value = entry.getAny(false);
  entry.setAnyValue(value, true);
  entry.setValidator(validator);
  entry.setDocString(doc_string);
}

void setDefault(ParameterList& list, std::string const& name,
                Teuchos::ParameterEntry const& declared)
{
  list.setEntry(name, declared);
  if (!declared.isList()) {
    markDefault(list.getEntry(name));
  }
}

bool isDefault(Teuchos::ParameterEntry const& entry, Teuchos::ParameterEntry const& declared,
               ParameterInfo const& info)
{
  return info.presence == Presence::has_default && !declared.isList() && !entry.isList() &&
         plainText(entry) == plainText(declared);
}

void copyMissing(ParameterList& list, ParameterList const& defaults)
{
  for (auto const& name : namesIn(defaults)) {
    if (!list.isParameter(name)) {
      setDefault(list, name, defaults.getEntry(name));
    } else if (list.isSublist(name) && defaults.isSublist(name)) {
      copyMissing(list.sublist(name), defaults.sublist(name));
    }
  }
}

void processContent(ParameterList& content, ParameterList const& valid, ParameterInfo const& info,
                    std::string const& path, Completion completion);

// Checks an existing entry against its declaration.
void processEntry(ParameterList& list, std::string const& name,
                  Teuchos::ParameterEntry const& declared, std::string const& path,
                  Completion completion)
{
  const auto info = Teuchos::rcp_dynamic_cast<const ParameterInfo>(declared.validator());
  ASPERITY_ASSERT(!info.is_null());
  auto& entry = list.getEntry(name);
  info->check(entry, path);
  info->convert(entry);
  entry.setValidator(info);
  entry.setDocString(declared.docString());
  if (isDefault(entry, declared, *info)) {
    markDefault(entry);
  }
  if (declared.isList()) {
    processContent(list.sublist(name), get<ParameterList>(declared), *info, path, completion);
  }
}

void processContent(ParameterList& content, ParameterList const& valid, ParameterInfo const& info,
                    std::string const& path, Completion completion)
{
  if (info.kind == ParameterKind::open_sublist) {
    for (auto const& name : namesIn(content)) {
      processEntry(content, name, valid.entry(valid.begin()), joinPath(path, name), completion);
    }
  } else if (info.kind == ParameterKind::foreign_sublist) {
    copyMissing(content, valid);
  } else {
    process(content, valid, path, completion);
  }
}

bool isChosen(ParameterList const& list, ParameterInfo const& info, std::string const& name)
{
  return info.chosen_by.empty() || (list.isType<std::string>(info.chosen_by) &&
                                    get<std::string>(list.getEntry(info.chosen_by)) == name);
}

void addMissing(ParameterList& list, std::string const& name,
                Teuchos::ParameterEntry const& declared, std::string const& path)
{
  const auto info = Teuchos::rcp_dynamic_cast<const ParameterInfo>(declared.validator(), true);
  if (info->presence == Presence::is_required) {
    refuseMissing(path, declared, *info);
  }
  if (info->presence == Presence::is_optional || !isChosen(list, *info, name)) {
    return;
  }
  if (declared.isList()) {
    list.sublist(name);
    processEntry(list, name, declared, path, Completion::full);
  } else {
    setDefault(list, name, declared);
  }
}

// Declarations in their order, so that a choice is complete before its lists are.
void process(ParameterList& list, ParameterList const& with_all, std::string const& path,
             Completion completion)
{
  const auto chosen = withChosenEntries(with_all, list, path);
  ParameterList const& valid = *chosen;
  refuseUnknownNames(list, valid, with_all, path);
  for (auto const& name : namesIn(valid)) {
    auto const& declared = valid.getEntry(name);
    const std::string entry_path = joinPath(path, name);
    if (list.isParameter(name)) {
      const auto info = parameterInfo(valid, name);
      const bool in_force = info.is_null() || isChosen(list, *info, name);
      processEntry(list, name, declared, entry_path, in_force ? completion : Completion::none);
    } else if (completion == Completion::full) {
      addMissing(list, name, declared, entry_path);
    }
  }
}
} // namespace

void completeAndValidate(ParameterList& list, ParameterList const& valid, std::string const& path)
{
  process(list, valid, path, Completion::full);
}
} // namespace asperity
