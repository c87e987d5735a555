#include "dynamics/condensation/StaticCondensation.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

// Conversion of states between the condensed model and the whole body.
namespace asperity::dynamics
{
State StaticCondensation::expand(State const& state) const
{
  State whole = state.clone();
  State::visitBody(
    [&](FieldInfo const&, auto const& from, auto& to) {
      to = whole_.body.vector();
      expand(*from, *to);
    },
    state, whole);
  return whole;
}

State StaticCondensation::gather(State const& whole, Amplitudes const& of) const
{
  return gather(whole, model_->body, of);
}

State StaticCondensation::gather(State const& whole, Body const& condensed,
                                 Amplitudes const& of) const
{
  State state = whole.clone();
  auto amplitude = of.begin();
  State::visitBody(
    [&](FieldInfo const&, auto const& from, auto& to) {
      to = condensed.vector();
      gather(*from, *to);
      to->replaceLocalValue(numKept(), *amplitude++);
    },
    whole, state);
  return state;
}

StaticCondensation::Amplitudes StaticCondensation::amplitudes(State const& state) const
{
  Amplitudes result;
  State::visitBody(
    [&](FieldInfo const&, auto const& field) {
      result.push_back(field->getLocalViewHost(Tpetra::Access::ReadOnly)(numKept(), 0));
    },
    state);
  return result;
}

StaticCondensation::Amplitudes StaticCondensation::amplitudesAt(double time) const
{
  const double rate = is_driven_ ? 1 : 0;
  return {rate * time, rate, 0, 0};
}
} // namespace asperity::dynamics
