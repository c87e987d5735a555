#include "fem/bulk/MaxwellBranch.hpp"

#include <algorithm>

namespace asperity::fem
{
std::vector<Material> longTerm(std::vector<Material> materials,
                               std::vector<MaxwellBranch> const& branches)
{
  for (auto const& branch : branches) {
    for (std::size_t cell = 0; cell < materials.size(); ++cell) {
      auto& modulus = materials[cell].shear_modulus;
      modulus = std::max(0., modulus - branch.moduli[cell]); // rounding of shares that sum to one
    }
  }
  return materials;
}

std::vector<Material> materialsOf(MaxwellBranch const& branch)
{
  std::vector<Material> materials(branch.moduli.size());
  for (std::size_t cell = 0; cell < materials.size(); ++cell) {
    materials[cell].shear_modulus = branch.moduli[cell];
  }
  return materials;
}
} // namespace asperity::fem
