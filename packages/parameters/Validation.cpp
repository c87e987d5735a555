#include "parameters/Alternatives.hpp"
#include "parameters/ParameterValue.hpp"

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

// All errors of a list are reported at once, one per line, so that a user can correct them
// together.
class Errors
{
public:
  template <class Check>
  void collect(Check&& check)
  {
    try {
      check();
    } catch (InputError const& error) {
      texts_.emplace_back(error.what());
    }
  }

  std::size_t number() const { return texts_.size(); }

  void throwIfAny() const
  {
    if (texts_.empty()) {
      return;
    }
    std::string all = texts_.front();
    for (std::size_t i = 1; i < texts_.size() && i < most_errors; ++i) {
      all += '\n' + texts_[i];
    }
    if (texts_.size() > most_errors) {
      all += "\nThere are " + std::to_string(texts_.size() - most_errors) + " more errors.";
    }
    throw InputError(all);
  }

private:
  static constexpr std::size_t most_errors = 10;
  std::vector<std::string> texts_;
};

void process(ParameterList& list, ParameterList const& valid, std::string const& path,
             Completion completion, Errors& errors);

void refuseUnknownNames(ParameterList const& list, ParameterList const& valid,
                        ParameterList const& with_all, std::string const& path, Errors& errors)
{
  for (auto const& name : namesIn(list)) {
    if (!valid.isParameter(name)) {
      errors.collect([&] { refuseUnknownName(valid, with_all, path, name); });
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
                    std::string const& path, Completion completion, Errors& errors);

// Checks an existing entry against its declaration.
void processEntry(ParameterList& list, std::string const& name,
                  Teuchos::ParameterEntry const& declared, std::string const& path,
                  Completion completion, Errors& errors)
{
  const auto info = parameterInfo(declared);
  ASPERITY_ASSERT(!info.is_null());
  auto& entry = list.getEntry(name);
  const auto before = errors.number();
  errors.collect([&] {
    info->check(entry, path);
    info->convert(entry);
  });
  if (errors.number() > before) {
    return;
  }
  entry.setValidator(info);
  entry.setDocString(declared.docString());
  if (isDefault(entry, declared, *info)) {
    markDefault(entry);
  }
  if (declared.isList()) {
    processContent(list.sublist(name), get<ParameterList>(declared), *info, path, completion,
                   errors);
  }
}

void processContent(ParameterList& content, ParameterList const& valid, ParameterInfo const& info,
                    std::string const& path, Completion completion, Errors& errors)
{
  if (info.kind == ParameterKind::open_sublist) {
    for (auto const& name : namesIn(content)) {
      processEntry(content, name, valid.entry(valid.begin()), joinPath(path, name), completion,
                   errors);
    }
  } else if (info.kind == ParameterKind::foreign_sublist) {
    copyMissing(content, valid);
  } else {
    process(content, valid, path, completion, errors);
  }
}

bool isChosen(ParameterList const& list, ParameterInfo const& info, std::string const& name)
{
  return info.chosen_by.empty() || (list.isType<std::string>(info.chosen_by) &&
                                    get<std::string>(list.getEntry(info.chosen_by)) == name);
}

void addMissing(ParameterList& list, std::string const& name,
                Teuchos::ParameterEntry const& declared, std::string const& path, Errors& errors)
{
  const auto info = parameterInfo(declared);
  if (info->presence == Presence::is_required) {
    errors.collect([&] { refuseMissing(path, declared, *info); });
    return;
  }
  if (info->presence == Presence::is_optional || !isChosen(list, *info, name)) {
    return;
  }
  if (declared.isList()) {
    list.sublist(name);
    processEntry(list, name, declared, path, Completion::full, errors);
  } else {
    setDefault(list, name, declared);
  }
}

// Follows the order of the declarations, so that a choice is complete before its lists. If a name
// is unknown, missing entries are not reported: the unknown name may be a misspelling of one of
// them.
void process(ParameterList& list, ParameterList const& with_all, std::string const& path,
             Completion completion, Errors& errors)
{
  Teuchos::RCP<const ParameterList> chosen;
  errors.collect([&] { chosen = withChosenEntries(with_all, list, path); });
  if (chosen.is_null()) {
    return;
  }
  ParameterList const& valid = *chosen;
  const auto before = errors.number();
  refuseUnknownNames(list, valid, with_all, path, errors);
  const bool names_are_known = errors.number() == before;
  for (auto const& name : namesIn(valid)) {
    auto const& declared = valid.getEntry(name);
    const std::string entry_path = joinPath(path, name);
    if (list.isParameter(name)) {
      const auto info = parameterInfo(declared);
      const bool in_force = info.is_null() || isChosen(list, *info, name);
      processEntry(list, name, declared, entry_path, in_force ? completion : Completion::none,
                   errors);
    } else if (completion == Completion::full && names_are_known) {
      addMissing(list, name, declared, entry_path, errors);
    }
  }
}
} // namespace

void completeAndValidate(ParameterList& list, ParameterList const& valid, std::string const& path)
{
  Errors errors;
  process(list, valid, path, Completion::full, errors);
  errors.throwIfAny();
}
} // namespace asperity
