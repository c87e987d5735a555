#include <Kokkos_Core.hpp>
#include <gtest/gtest.h>
#include <mpi.h>

#include <iostream>
#include <sstream>

namespace
{
// Other ranks than the first say nothing but what fails on them.
class Failures : public testing::EmptyTestEventListener
{
public:
  explicit Failures(int rank) : rank_(rank) {}

private:
  void OnTestPartResult(testing::TestPartResult const& result) override
  {
    if (result.failed()) {
      std::ostringstream line;
      line << "On rank " << rank_ << ": " << result;
      std::cout << line.str() << std::flush;
    }
  }

  int rank_;
};
} // namespace

// Starts MPI and Kokkos around GoogleTest. All ranks return the largest exit status, so that a
// failure on one rank is seen.
int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int status = 1;
  {
    Kokkos::ScopeGuard kokkos(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank != 0) {
      auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
      delete listeners.Release(listeners.default_result_printer());
      listeners.Append(new Failures(rank)); // GoogleTest deletes it
    }
    const int mine = RUN_ALL_TESTS();
    MPI_Allreduce(&mine, &status, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  }
  MPI_Finalize();
  return status;
}
