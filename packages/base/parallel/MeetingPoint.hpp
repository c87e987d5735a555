#pragma once

#include "base/Types.hpp"

#include <mpi.h>

namespace asperity
{
// Where ranks wait for each other, but not for ever: a rank that has failed alone finds out here
// that the others are in the middle of something collective, which would wait for it. Has a
// communicator of its own, so that nothing that is under way can be taken for its messages; make it
// in good time, collectively.
class MeetingPoint
{
public:
  explicit MeetingPoint(Communicator const& communicator);
  ~MeetingPoint();
  MeetingPoint(MeetingPoint const&) = delete;
  MeetingPoint& operator=(MeetingPoint const&) = delete;

  // Waits until every rank is here, but at most so many seconds if `patience` is not negative.
  // False if that ended it: then there is nothing left but to end the program.
  bool meet(double patience) const;

  MPI_Comm communicator() const { return communicator_; }

private:
  MPI_Comm communicator_ = MPI_COMM_NULL;
  mutable bool was_missed_ = false;
};
} // namespace asperity
