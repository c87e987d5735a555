#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/generation/Bisection.hpp"
#include "scenario/setup/mesh/GeneratedMesh.hpp"

#include <functional>

// The types of mesh that are made here, with what makes them.
namespace asperity::scenario
{
template <int Dim>
struct Generator : GeneratedMesh
{
  std::function<GlobalMesh<Dim>(ParameterList const&, mesh::VertexLimit const&)> make;
};

Generator<2> wedgeGenerator();
Generator<3> deepWedgeGenerator();
Generator<2> rectangleGenerator();
Generator<3> boxGenerator();

// Of the entry `Periodic Along z` of types in space.
inline constexpr char const* periodic_meaning =
  "If true, the body continues periodically along z: what leaves it through the back enters it at "
  "the front, and neither is a boundary.";
} // namespace asperity::scenario
