#pragma once

#include "fem/VolumetricPatches.hpp"
#include "fem/bulk/History.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/bulk/MaxwellBranch.hpp"
#include "fem/stress/CoulombPlane.hpp"
#include "io/FieldRegistry.hpp"
#include "io/OutputDomain.hpp"
#include "mesh/Mesh.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// What stress at some vertices follows from, along the axes, (vertices, components) each.
struct VertexFields
{
  std::vector<double> displacement, velocity; // [m], [m/s]; velocity is empty unless wanted
  std::vector<std::vector<double>> branches;  // (num_branches) displacements of Maxwell branches
};

// The motion now and at the start of the run. Collective.
struct VertexFieldSource
{
  std::function<VertexFields(bool with_velocity)> now, at_start;
};

// What some cells have yielded and remember.
struct YieldedStrain
{
  std::vector<double> strain;                         // (cells, tensor components) [-]
  std::vector<double> shear;                          // (cells) [-], accumulated
  std::map<std::string, std::vector<double>> history; // (cells, width) of each internal variable
};

// Observes local vertices, which may be ghosts; are_few: few of many, as at receivers. Collective.
using ObserveVertices =
  std::function<VertexFieldSource(std::vector<int> const& vertices, bool are_few)>;

// What stress in a body follows from; all of it must outlive the registry but for `observe`.
template <int Dim>
struct StressedBody
{
  Mesh<Dim> const& mesh;
  int components;                              // of the displacement
  std::vector<fem::Material> const& materials; // (num_cells)
  std::vector<fem::MaxwellBranch> const& branches;
  fem::VolumetricPatches const& patches;
  std::string surface; // the boundary of the domain `surface`
  ObserveVertices observe;
  // The present one of local cells; empty where no cell of the body may yield. A run starts with 0.
  std::function<YieldedStrain(std::vector<int> const& cells)> yielded;
  std::vector<fem::HistoryColumns> history; // what it has of internal variables
};

// Registers `stress`, `strain`, for each plane `coulomb_stress_change_<name>`, and in a body that
// may yield `inelastic_strain`, `inelastic_shear` and internal variables, in the elements of a
// domain, which is `volume` or `surface`: of the cell, or of the cell below the facet.
template <int Dim>
void registerStressFields(io::FieldRegistry& registry, io::OutputDomain const& domain,
                          StressedBody<Dim> const& body,
                          std::map<std::string, fem::CoulombPlane> const& planes);
} // namespace asperity::catalogue
