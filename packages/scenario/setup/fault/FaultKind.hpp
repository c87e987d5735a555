#pragma once

#include "base/Registry.hpp"
#include "fem/OtherSide.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// A kind of fault: a value of the entry `Type` of a boundary condition. Each kind is one file,
// beside this one or in a library of your own; the file ends in
//
//   ASPERITY_REGISTER(FaultKindRegistry, "Bilateral Contact", BilateralContact)
//
// All kinds read `Direction` and `Plate Rate`; they differ in what lies on their other side.
struct FaultKind
{
  FaultKind(std::string meaning_of_kind, fem::OtherSide const& what_lies_there)
      : meaning(std::move(meaning_of_kind))
      , other_side(what_lies_there)
  {
  }
  virtual ~FaultKind() = default;

  std::string meaning; // for the list of parameters
  fem::OtherSide other_side;
};

using FaultKindRegistry = Registry<FaultKind>;

// The names of all kinds, and of the kinds that lie inside the mesh.
std::vector<std::string> faultKinds();
std::vector<std::string> faultKindsInside();
} // namespace asperity::scenario
