#pragma once

#include <gtest/gtest.h>
#include <mpi.h>

#include <filesystem>
#include <string>
#include <unistd.h>

namespace asperity::mesh
{
// A new folder that all ranks share, gone at the end of the test.
class SharedFolder : public ::testing::Test
{
protected:
  void SetUp() override
  {
    int process = getpid();
    MPI_Bcast(&process, 1, MPI_INT, 0, MPI_COMM_WORLD);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    folder_ = std::filesystem::temp_directory_path() / ("asperity-mesh-" + std::to_string(process));
    if (rank_ == 0) {
      std::filesystem::create_directories(folder_);
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }
  void TearDown() override
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank_ == 0) {
      std::filesystem::remove_all(folder_);
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }

  std::string file(std::string const& name) const { return (folder_ / name).string(); }

  // The first rank does it, then all go on.
  template <class Work>
  void onFirstRank(Work work) const
  {
    if (rank_ == 0) {
      work();
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }

private:
  int rank_ = 0;
  std::filesystem::path folder_;
};
} // namespace asperity::mesh
