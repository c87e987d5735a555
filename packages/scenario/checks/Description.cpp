#include "scenario/checks/Description.hpp"

#include <ostream>

namespace asperity::scenario
{
void Description::add(std::vector<std::string> const& more)
{
  lines.insert(lines.end(), more.begin(), more.end());
}

void Description::add(std::vector<Warning> const& more)
{
  warnings.insert(warnings.end(), more.begin(), more.end());
}

void print(Description const& description, std::ostream& stream)
{
  for (auto const& line : description.lines) {
    stream << line << '\n';
  }
  for (auto const& warning : description.warnings) {
    stream << "WARNING: " << warning.text << '\n';
  }
}
} // namespace asperity::scenario
