#pragma once

#include <map>
#include <typeindex>

namespace asperity::io
{
// What the outputs of a run let others read, by its type: one of each. Outputs add to it, the files
// of a text format ask:
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
