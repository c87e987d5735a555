#include "scenario/deck/Coordinates.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "parameters/ParameterInfo.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/fields/Expression.hpp"
#include "parameters/fields/VertexDataset.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
void refuseZIn(Teuchos::ParameterEntry const& field, std::string const& path)
{
  if (field.isList()) {
    auto const& regions = get<ParameterList>(field);
    for (auto const& region : namesIn(regions)) {
      refuseZIn(regions.getEntry(region), joinPath(path, region));
    }
  } else if (holds<std::string>(field) && !VertexDataset::isName(get<std::string>(field))) {
    auto const parts = formulaParts(get<std::string>(field));
    ASPERITY_REQUIRE(
      std::none_of(parts.begin(), parts.end(),
                   [](auto const& part) { return part.is_name && part.text == "z"; }),
      path << " = " << valueText(field)
           << " depends on z, but a mesh in the plane has x and y. Write the expression in x and "
              "y, or take a mesh in three dimensions.");
  }
}

void refuseZIn(ParameterList const& list, std::string const& path)
{
  if (list.isType<bool>("Enabled") && !list.get<bool>("Enabled")) {
    return;
  }
  for (auto const& name : namesIn(list)) {
    auto const& entry = list.getEntry(name);
    auto const info = parameterInfo(entry);
    if (!info.is_null() && info->kind == ParameterKind::field) {
      refuseZIn(entry, joinPath(path, name));
    } else if (entry.isList()) {
      refuseZIn(get<ParameterList>(entry), joinPath(path, name));
    }
  }
}
} // namespace

void refuseZ(ParameterList const& deck) { refuseZIn(deck, "Asperity"); }
} // namespace asperity::scenario
