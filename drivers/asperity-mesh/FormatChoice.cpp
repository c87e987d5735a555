#include "FormatChoice.hpp"

#include <algorithm>
#include <cctype>

namespace asperity::geometry
{
bool hasEnding(std::string const& file_name, std::string const& ending)
{
  return file_name.size() >= ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), file_name.rbegin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) ==
                  std::tolower(static_cast<unsigned char>(b));
         });
}

std::string alternatives(std::vector<std::string> const& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  return text;
}
} // namespace asperity::geometry
