#include "io/FieldRegistry.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"

#include <algorithm>

namespace asperity::io
{
namespace
{
OutputField const* find(std::deque<OutputField> const& fields, std::string const& domain,
                        std::string const& name)
{
  const auto found = std::find_if(fields.begin(), fields.end(), [&](OutputField const& field) {
    return field.domain == domain && field.name == name;
  });
  return found == fields.end() ? nullptr : &*found;
}

OutputScalar const* find(std::deque<OutputScalar> const& scalars, std::string const& name)
{
  const auto found = std::find_if(scalars.begin(), scalars.end(),
                                  [&](OutputScalar const& scalar) { return scalar.name == name; });
  return found == scalars.end() ? nullptr : &*found;
}
} // namespace

void FieldRegistry::add(OutputField field)
{
  ASPERITY_ASSERT(find(fields_, field.domain, field.name) == nullptr);
  fields_.push_back(std::move(field));
}

void FieldRegistry::add(OutputScalar scalar)
{
  ASPERITY_ASSERT(find(scalars_, scalar.name) == nullptr);
  scalars_.push_back(std::move(scalar));
}

OutputField const& FieldRegistry::field(std::string const& domain, std::string const& name) const
{
  OutputField const* found = find(fields_, domain, name);
  ASPERITY_REQUIRE(found, "There is no field '" << name << "' on the " << domain << "."
                                                << didYouMean(name, fieldNames(domain)));
  return *found;
}

OutputScalar const& FieldRegistry::scalar(std::string const& name) const
{
  OutputScalar const* found = find(scalars_, name);
  ASPERITY_REQUIRE(found, "There is no quantity '" << name << "' of a step."
                                                   << didYouMean(name, scalarNames()));
  return *found;
}

std::vector<OutputField const*> FieldRegistry::fields(std::string const& domain,
                                                      std::vector<std::string> const& names,
                                                      std::string const& where) const
{
  std::vector<OutputField const*> chosen;
  for (auto const& name : names) {
    OutputField const& next = field(domain, name);
    ASPERITY_REQUIRE(std::find(chosen.begin(), chosen.end(), &next) == chosen.end(),
                     where << " names '" << name << "' twice.");
    chosen.push_back(&next);
  }
  return chosen;
}

bool FieldRegistry::hasField(std::string const& domain, std::string const& name) const
{
  return find(fields_, domain, name) != nullptr;
}

std::vector<std::string> FieldRegistry::fieldNames(std::string const& domain) const
{
  std::vector<std::string> names;
  for (auto const& field : fields_) {
    if (field.domain == domain) {
      names.push_back(field.name);
    }
  }
  return names;
}

std::vector<std::string> FieldRegistry::scalarNames() const
{
  std::vector<std::string> names;
  for (auto const& scalar : scalars_) {
    names.push_back(scalar.name);
  }
  return names;
}
} // namespace asperity::io
