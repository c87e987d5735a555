#include "tnnmg/correction/MultigridSymmetry.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace asperity::tnnmg::detail
{
namespace
{
// A number in [-1, 1).
double pseudorandom(std::uint64_t id)
{
  return std::ldexp(static_cast<double>(splitMix(id) >> 11), -52) - 1.0;
}
} // namespace

Vector pseudorandomVector(RCP<const Map> const& map, int seed, MultigridNodes const& nodes)
{
  Vector x(map);
  {
    auto values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int row = 0; row < values.extent_int(0); ++row) {
      values(row, 0) =
        pseudorandom(static_cast<std::uint64_t>(2 * map->getGlobalElement(row) + seed));
    }
  }
  nodes.project(x);
  return x;
}

double relativeAsymmetry(Operator const& B, MultigridNodes const& nodes)
{
  const Vector x = pseudorandomVector(B.getDomainMap(), 0, nodes);
  const Vector y = pseudorandomVector(B.getDomainMap(), 1, nodes);
  Vector Bx(B.getRangeMap());
  Vector By(B.getRangeMap());
  B.apply(x, Bx);
  B.apply(y, By);
  const double xBx = Bx.dot(x);
  const double yBy = By.dot(y);
  if (x.norm2() == 0) { // no dof is left
    return 0;
  }
  return xBx > 0 && yBy > 0 ? std::abs(Bx.dot(y) - By.dot(x)) / std::sqrt(xBx * yBy)
                            : std::numeric_limits<double>::infinity();
}

void requireSymmetric(Operator const& B, MultigridNodes const& nodes, double tolerance)
{
  const double asymmetry = relativeAsymmetry(B, nodes);
  if (!(asymmetry <= tolerance)) {
    std::ostringstream message;
    message << "Multigrid: the V-cycle is not symmetric and positive (relative asymmetry "
            << asymmetry << ", allowed " << tolerance
            << "). It is symmetric and positive if Z is: check the bulk's moduli, viscosities and "
            << "density.";
    throw SolveError(message.str());
  }
}
} // namespace asperity::tnnmg::detail
