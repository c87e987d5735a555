#include "dynamics/condensation/StaticCondensation.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <array>

// Conversion of states between the condensed model and the whole body.
namespace asperity::dynamics
{
namespace
{
constexpr std::array<RCP<Vector> State::*, 4> members = {&State::u, &State::v, &State::a,
                                                         &State::jerk};
} // namespace

State StaticCondensation::expand(State const& state) const
{
  State whole = state.clone();
  for (auto member : members) {
    auto const x = whole_.body.vector();
    expand(*(state.*member), *x);
    whole.*member = x;
  }
  return whole;
}

State StaticCondensation::gather(State const& whole, Amplitudes const& of) const
{
  State state = whole.clone();
  for (std::size_t i = 0; i < members.size(); ++i) {
    auto const x = model_->body.vector();
    gather(*(whole.*members[i]), *x);
    x->replaceLocalValue(numKept(), of[i]);
    state.*members[i] = x;
  }
  return state;
}

StaticCondensation::Amplitudes StaticCondensation::amplitudes(State const& state) const
{
  Amplitudes result;
  for (auto member : members) {
    result.push_back((state.*member)->getLocalViewHost(Tpetra::Access::ReadOnly)(numKept(), 0));
  }
  return result;
}

StaticCondensation::Amplitudes StaticCondensation::amplitudesAt(double time) const
{
  const double rate = is_driven_ ? 1 : 0;
  return {rate * time, rate, 0, 0};
}
} // namespace asperity::dynamics
