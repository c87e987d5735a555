// Makes the mistake that its argument names, with the libraries of a run loaded, or none.
#include "base/program/MpiScope.hpp"

#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{
// Out of the optimiser's sight.
int volatile five = 5;
double volatile huge = 1e300;
double* volatile lost = nullptr;

double readBehind()
{
  std::vector<double> const numbers(static_cast<std::size_t>(five), 1.0);
  return *(numbers.data() + five);
}

double make(std::string const& mistake)
{
  if (mistake == "leak") {
    lost = new double[100]();
    lost = nullptr;
  } else if (mistake == "behind") {
    return readBehind();
  } else if (mistake == "overflow") {
    return std::numeric_limits<int>::max() - 2 + five;
  } else if (mistake == "cast") {
    return static_cast<int>(huge);
  }
  return 0;
}
} // namespace

int main(int argc, char** argv)
{
  asperity::MpiScope scope(argc, argv);
  return asperity::runGuarded(*scope.communicator(), [&] {
    std::cout << make(argc > 1 ? argv[1] : "") << '\n';
    return 0;
  });
}
