#include "Warnings.hpp"

#include <iostream>

namespace asperity::geometry
{
void warn(std::string const& text)
{
  std::cout.flush();
  std::cerr << "asperity-mesh: WARNING: " << text << std::endl;
}
} // namespace asperity::geometry
