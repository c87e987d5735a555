#pragma once

#include "base/Types.hpp"

#include <mpi.h>

namespace asperity
{
// A point at which ranks wait for each other for a limited time: a rank that alone has failed finds
// out here that the others are inside a collective call, which would wait for it. It has its own
// communicator, so that its messages cannot be confused with others. Construct it collectively,
// before a failure is possible.
class MeetingPoint
{
public:
  explicit MeetingPoint(Communicator const& communicator);
  ~MeetingPoint();
  MeetingPoint(MeetingPoint const&) = delete;
  MeetingPoint& operator=(MeetingPoint const&) = delete;

  // Waits until every rank is here, but at most `timeout` seconds unless that is negative. False
  // if the time has run out: then the program must end.
  bool meet(double timeout) const;

  MPI_Comm communicator() const { return communicator_; }

private:
  MPI_Comm communicator_ = MPI_COMM_NULL;
  mutable bool was_missed_ = false;
};
} // namespace asperity
