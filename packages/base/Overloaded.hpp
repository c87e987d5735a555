#pragma once

namespace asperity
{
// Several functions as one, for std::visit: a case for each type of a variant.
template <class... Cases>
struct Overloaded : Cases...
{
  using Cases::operator()...;
};

template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;
} // namespace asperity
