#include "arrangement/exact/ExactArrangement.hpp"

#include "base/Errors.hpp"

namespace asperity::geometry
{
Arrangement arrange(std::vector<NamedSurface> const&)
{
  throw InputError("This asperity-mesh was built without CGAL, so that it has no command build. On "
                   "Debian: apt-get install libcgal-dev, then build it again.");
}
} // namespace asperity::geometry
