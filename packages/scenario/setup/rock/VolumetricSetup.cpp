#include "scenario/setup/rock/VolumetricSetup.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/parallel/CellGroups.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::scenario
{
namespace
{
// Rock that yields, or has a power law, has a stress of its own in each cell.
std::vector<bool> areAlone(Rock const& rock)
{
  std::vector<bool> result(rock.materials.size(), false);
  if (rock.yielding) {
    for (auto const& part : rock.yielding->parts) {
      for (const int cell : part.cells) {
        result[cell] = true;
      }
    }
  }
  return result;
}

std::vector<double> ownModuli(VolumetricStrain choice, Rock const& rock)
{
  const double own_ratio = choice == VolumetricStrain::of_patch ? -1 : fem::own_poissons_ratio;
  auto const are_alone = areAlone(rock);
  std::vector<double> moduli;
  for (std::size_t cell = 0; cell < rock.materials.size(); ++cell) {
    auto const& material = rock.materials[cell];
    moduli.push_back(choice == VolumetricStrain::of_cell || are_alone[cell]
                       ? material.bulk_modulus
                       : fem::ownModulus(material, own_ratio));
  }
  return moduli;
}

bool areSmaller(std::vector<double> const& moduli, std::vector<fem::Material> const& materials)
{
  for (std::size_t cell = 0; cell < moduli.size(); ++cell) {
    if (moduli[cell] < materials[cell].bulk_modulus) {
      return true;
    }
  }
  return false;
}

// By how much P1 cells of this Poisson's ratio hold back the slip of a crack that is 16 cells wide,
// as a share of that at 0.25: from circular cracks without friction, and from long ones in the
// plane. tests/verification/incompressible measures them.
double lostSlip(double poissons_ratio, int components)
{
  constexpr std::array<double, 5> ratios = {0.25, 0.4, 0.45, 0.49, 0.499};
  constexpr std::array<double, 5> in_space = {0, 0.05, 0.11, 0.36, 0.81};
  constexpr std::array<double, 5> in_plane = {0, 0.01, 0.04, 0.16, 0.51};
  auto const& lost = components == 3 ? in_space : in_plane;
  const auto position = [](double nu) { return std::log(1 - 2 * nu); };
  for (std::size_t i = 1; i < ratios.size(); ++i) {
    if (poissons_ratio <= ratios[i]) {
      const double part = (position(poissons_ratio) - position(ratios[i - 1])) /
                          (position(ratios[i]) - position(ratios[i - 1]));
      return std::max(0., lost[i - 1] + part * (lost[i] - lost[i - 1]));
    }
  }
  return lost.back();
}
} // namespace

template <int Dim>
fem::VolumetricPatches makePatches(BulkSettings const& bulk, ParameterList const& list,
                                   std::vector<std::string> const& faults, Mesh<Dim>& mesh,
                                   Rock& rock, Communicator const& communicator)
{
  auto const choice = bulk.volumetric_strain;
  if (bulk.components != Dim || choice == VolumetricStrain::of_cell) {
    return {};
  }
  auto moduli = ownModuli(choice, rock);
  if (maxOverRanks(areSmaller(moduli, rock.materials) ? 1 : 0, communicator) == 0) {
    return {};
  }
  auto vertices = fem::patchVertices(mesh, faults, communicator);
  if (communicator.getSize() > 1) {
    mesh::completeGroups(mesh, vertices, communicator);
    rock = makeRock(bulk, list, mesh, communicator);
    moduli = ownModuli(choice, rock);
    vertices = fem::patchVertices(mesh, faults, communicator);
  }
  return fem::makeVolumetricPatches(mesh, vertices, rock.materials, moduli);
}

std::vector<Warning> warnOfLocking(BulkSettings const& bulk, Rock const& rock,
                                   Communicator const& communicator)
{
  constexpr double bound = 0.4;
  const int components = bulk.components;
  const bool may_share = bulk.volumetric_strain != VolumetricStrain::automatic;
  auto const moduli = ownModuli(bulk.volumetric_strain, rock);
  double largest = 0;
  for (std::size_t cell = 0; cell < moduli.size() && components > 1; ++cell) {
    auto const& material = rock.materials[cell];
    if (moduli[cell] >= material.bulk_modulus) {
      largest = std::max(largest, material.poissonsRatio());
    }
  }
  largest = maxOverRanks(largest, communicator);
  if (largest < bound) {
    return {};
  }
  return {{"cells that lock",
           "Cells with a Poisson's ratio of up to " + formatShort(largest) +
             " keep their volume each for itself, and are too stiff: of a crack that is 16 cells "
             "wide, they hold back about " +
             formatted("%.0f", 100 * lostSlip(largest, components)) +
             " % of the slip, with half the cells about half of it. " +
             (may_share ? "Choose Bulk / Volumetric Strain = Auto."
                        : "Rock that yields or has a power law cannot share it between cells: take "
                          "smaller cells, or another law there.")}};
}

template fem::VolumetricPatches makePatches(BulkSettings const&, ParameterList const&,
                                            std::vector<std::string> const&, Mesh<2>&, Rock&,
                                            Communicator const&);
template fem::VolumetricPatches makePatches(BulkSettings const&, ParameterList const&,
                                            std::vector<std::string> const&, Mesh<3>&, Rock&,
                                            Communicator const&);
} // namespace asperity::scenario
