#include "dynamics/State.hpp"

#include "base/Errors.hpp"

#include <algorithm>

namespace asperity::dynamics
{
namespace
{
RCP<Vector> likeField(RCP<Vector> const& field)
{
  constexpr bool set_to_zero = false;
  return rcp(new Vector(field->getMap(), set_to_zero));
}

NodeView likeField(NodeView const& field)
{
  return NodeView(Kokkos::view_alloc(field.label(), Kokkos::WithoutInitializing), field.extent(0));
}

fem::TensorView likeField(fem::TensorView const& field)
{
  return fem::TensorView(Kokkos::view_alloc(field.label(), Kokkos::WithoutInitializing),
                         field.extent(0), field.extent(1));
}
} // namespace

ConstNodeView valuesOf(RCP<Vector> const& field)
{
  auto const view = field->getLocalViewDevice(Tpetra::Access::ReadOnly);
  return ConstNodeView(view.data(), view.extent(0));
}

NodeView overwritten(RCP<Vector> const& field)
{
  auto const view = field->getLocalViewDevice(Tpetra::Access::OverwriteAll);
  return NodeView(view.data(), view.extent(0));
}

std::size_t State::numBodyFields() const
{
  std::size_t count = 0;
  visitBody([&](FieldInfo const&, auto const&) { ++count; }, *this);
  return count;
}

NodeView const& State::at(std::string const& name) const
{
  auto const found = std::find_if(added.begin(), added.end(),
                                  [&](Added const& field) { return field.info->name == name; });
  ASPERITY_ASSERT(found != added.end());
  return found->values;
}

State State::sameShape() const
{
  State other;
  other.time = time;
  other.added = added;
  other.branches = branches;
  other.inelastic = inelastic;
  visitFields([](FieldInfo const&, auto const& field, auto& copy) { copy = likeField(field); },
              *this, other);
  return other;
}

State State::clone() const
{
  State copy = sameShape();
  visitFields([](FieldInfo const&, auto const& field,
                 auto const& to) { Kokkos::deep_copy(overwritten(to), valuesOf(field)); },
              *this, copy);
  return copy;
}
} // namespace asperity::dynamics
