#pragma once

#include "base/Archive.hpp"
#include "io/FieldRegistry.hpp"

#include <string>
#include <vector>

namespace asperity::catalogue
{
// By how much the energies of a run change over an event, for those among its scalars that are
// energies or works since the start.
class EventEnergies
{
public:
  EventEnergies() = default; // none
  explicit EventEnergies(io::FieldRegistry const& registry);

  // ",kinetic_energy [J/m],..."
  std::string header() const;

  // Of this moment; the order is that of the header.
  std::vector<double> sample() const;

  // ",<change>,..." from one sample to another.
  std::string columns(std::vector<double> const& before, std::vector<double> const& after) const;

private:
  std::vector<io::OutputScalar const*> scalars_;
};
} // namespace asperity::catalogue
