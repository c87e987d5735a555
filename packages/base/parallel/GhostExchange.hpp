#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"

#include <tuple>
#include <vector>

namespace asperity
{
// Which of this rank's items other ranks have copies of (ghosts), and which copies this rank has of
// theirs. Items are numbered locally: those that this rank owns come first, its ghosts after them;
// each has `width` successive values. The exchange is made once; afterwards only values are sent,
// in one message to each neighbour, and nothing on one rank. Values are packed and unpacked where
// kernels run, and MPI takes them from the host.
class GhostExchange
{
public:
  GhostExchange() = default; // of items that no rank has copies of
  // ghosts: ids that other ranks own. InputError if no rank owns one. Collective.
  GhostExchange(Map const& owned, std::vector<GlobalOrdinal> const& ghosts);
  // Items and the ranks that they go to or come from; both are sorted by rank, and two ranks have
  // what they exchange in the same order.
  struct Route
  {
    std::vector<int> items, ranks;
  };
  GhostExchange(RCP<const Communicator> communicator, int num_owned, Route const& sent,
                Route const& received);

  // The part of the exchange that the flags name: for each owned item, or for each ghost, 0 or 1.
  // Collective.
  GhostExchange withOwned(std::vector<char> const& is_taken) const;
  GhostExchange withGhosts(std::vector<char> const& is_taken) const;
  // The same where owned items have got these numbers; ghosts keep theirs. Not collective.
  GhostExchange renumbered(std::vector<int> const& number) const;

  // Copies the values of owned items to their ghosts: values (num_items width). T is float or
  // double. Collective, as gather is.
  template <class T>
  void share(Kokkos::View<T*, MemorySpace> const& values, int width = 1) const;
  // into(owned item) += factor from(ghost), in the order of messages: both (num_items width), of
  // which `into` may have no ghosts, and both may be the same.
  template <class T>
  void gather(Kokkos::View<const T*, MemorySpace> const& from, T factor,
              Kokkos::View<T*, MemorySpace> const& into, int width = 1) const;

  // into(owned item) = max(into(owned item), from(ghost)) over the copies of the item; else as
  // gather.
  template <class T>
  void gatherLargest(Kokkos::View<const T*, MemorySpace> const& from,
                     Kokkos::View<T*, MemorySpace> const& into, int width = 1) const;

private:
  struct Neighbour
  {
    int rank, begin, end; // places in the lists of items
  };
  struct Side
  {
    std::vector<int> items;
    std::vector<Neighbour> neighbours;
    IndexView on_device; // the items
    Side() = default;
    explicit Side(Route const& route);
    Side reduced(std::vector<char> const& keeps) const;
  };
  // What is sent and received, on the device and where MPI takes it, for the largest width so far.
  template <class T>
  struct Buffers
  {
    using OnDevice = Kokkos::View<T*, MemorySpace>;
    OnDevice owned, ghosts;
    decltype(Kokkos::create_mirror_view(OnDevice())) owned_on_host, ghosts_on_host;
  };

  GhostExchange(RCP<const Communicator> communicator, int num_owned, Side owned, Side ghosts);
  template <class T>
  Buffers<T> const& buffers(int width) const;
  template <class T>
  Kokkos::View<T*, MemorySpace> bringBack(Kokkos::View<const T*, MemorySpace> const& from,
                                          int width) const;
  template <class T>
  void send(Side const& from, T const* sent, Side const& to, T* received, int width) const;

  RCP<const Communicator> communicator_;
  int num_owned_ = 0;
  Side owned_, ghosts_; // what others have copies of, and the copies here
  // Each owned item that others have copies of, once, and its places in the list: (num + 1) where
  // they begin.
  IndexView owners_, first_place_, places_;
  mutable std::tuple<Buffers<float>, Buffers<double>> buffers_;
};
} // namespace asperity
