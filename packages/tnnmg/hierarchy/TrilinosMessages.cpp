#include "tnnmg/hierarchy/TrilinosMessages.hpp"

#include <sstream>

namespace asperity::tnnmg::detail
{
std::string usefulPart(std::string const& thrown)
{
  constexpr std::size_t longest = 400;
  std::istringstream lines(thrown);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("is not valid. Did you mean") != std::string::npos) {
      return line;
    }
    const bool is_place = line.rfind("Throw ", 0) == 0 || line.find("pp:") != std::string::npos;
    if (!line.empty() && !is_place && text.size() < longest) {
      text += (text.empty() ? "" : " ") + line;
    }
  }
  return text.size() <= longest ? text : text.substr(0, longest) + " ...";
}

} // namespace asperity::tnnmg::detail
