#pragma once

#include "dynamics/Body.hpp"

#include <memory>

// Conjugate gradients (Belos) preconditioned by a V-cycle of MueLu's smoothed aggregation with its
// defaults, symmetric Gauss-Seidel before and after, and rigid body motions. For one rank: MueLu's
// direct coarse solver gives wrong results on more.
class LinearReference
{
public:
  LinearReference(asperity::RCP<const asperity::CrsMatrix> const& Z,
                  asperity::dynamics::Body const& body);
  ~LinearReference();

  // Iterates for Z x = b, from x = 0.
  void iterate(asperity::Vector const& b, int num_iterations, asperity::Vector& x) const;
  // The least number of iterations after which the energy norm of the error is at most `error`.
  int iterationsFor(asperity::Vector const& b, asperity::Vector const& solution,
                    double error) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// sqrt <Z x, x>
double energyNorm(asperity::CrsMatrix const& Z, asperity::Vector const& x);
