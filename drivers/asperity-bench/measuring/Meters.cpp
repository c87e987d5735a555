#include "measuring/Meters.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <fstream>
#include <string>

double peakBytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  }
  return 0;
}

double productSeconds(asperity::dynamics::Body const& body)
{
  constexpr int count = 10;
  auto const x = body.vector(), y = body.vector();
  x->randomize();
  body.matrices.stiffness->apply(*x, *y);
  const Stopwatch watch;
  for (int i = 0; i < count; ++i) {
    body.matrices.stiffness->apply(*x, *y);
  }
  return watch.seconds() / count;
}
