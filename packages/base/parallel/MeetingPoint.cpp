#include "base/parallel/MeetingPoint.hpp"

#include "base/parallel/Messages.hpp"

#include <chrono>
#include <thread>

namespace asperity
{
MeetingPoint::MeetingPoint(Communicator const& communicator)
{
  MPI_Comm_dup(rawCommunicator(communicator), &communicator_);
}

MeetingPoint::~MeetingPoint()
{
  if (!was_missed_) { // otherwise the barrier is not complete
    MPI_Comm_free(&communicator_);
  }
}

bool MeetingPoint::meet(double timeout) const
{
  using Seconds = std::chrono::duration<double>;
  MPI_Request request;
  MPI_Ibarrier(communicator_, &request);
  const auto start = std::chrono::steady_clock::now();
  for (int all_here = 0;;) {
    MPI_Test(&request, &all_here, MPI_STATUS_IGNORE);
    if (all_here) {
      return true;
    }
    if (timeout >= 0.0 && Seconds(std::chrono::steady_clock::now() - start).count() > timeout) {
      was_missed_ = true;
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}
} // namespace asperity
