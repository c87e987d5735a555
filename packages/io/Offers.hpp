#pragma once

#include <map>
#include <typeindex>

namespace asperity::io
{
// The objects that the outputs of a run let others read, found by type: at most one of each type.
// Outputs add themselves, and the files of a text format look them up:
//
//   offers.add(*this);                                        // in Receivers::offer
//   if (auto const* receivers = offers.find<Receivers>()) ... // null if the deck has none
class Offers
{
public:
  template <class Type>
  void add(Type const& offered)
  {
    offered_[typeid(Type)] = &offered;
  }

  template <class Type>
  Type const* find() const
  {
    const auto found = offered_.find(typeid(Type));
    return found == offered_.end() ? nullptr : static_cast<Type const*>(found->second);
  }

private:
  std::map<std::type_index, void const*> offered_;
};
} // namespace asperity::io
