#pragma once

#include "io/OutputSet.hpp"
#include "parameters/Parameters.hpp"
#include "unit/io/Stage.hpp"

#include <string>

namespace asperity::test
{
// The list `Output` of a deck with one output and the files of a platform.
inline ParameterList deckWith(std::string const& output, std::string const& platform)
{
  ParameterList list;
  for (auto const& name : io::OutputRegistry::instance().names()) {
    list.sublist(name).set("Enabled", name == output);
  }
  list.set("Text Format", platform);
  auto& about = list.sublist(platform);
  about.set("Problem", "BP1-QD").set("Author", "A. Modeller").set("Date", "2024/05/31");
  about.set("Code Version", "1.2").set("Element Size", 50.0);
  if (platform == "SCEC") {
    about.set("Time Step", 0.25);
  }
  return list;
}
} // namespace asperity::test
