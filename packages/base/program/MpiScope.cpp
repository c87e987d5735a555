#include "base/program/MpiScope.hpp"

#include "portability/Spaces.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_Map.hpp>
#include <mpi.h>

#include <csignal>
#include <cstring>
#include <type_traits>
#include <vector>

namespace asperity
{
// The kernels of friction, assembly and solver read and write what Tpetra allocates.
static_assert(std::is_same<Map::execution_space, ExecutionSpace>::value,
              "Tpetra's default node type runs in another space than Kokkos's default. Configure "
              "Trilinos with the node type of its backend: Tpetra_INST_OPENMP, Tpetra_INST_CUDA.");
static_assert(std::is_same<Map::memory_space, MemorySpace>::value,
              "Tpetra's default node type has its data in another memory space than Kokkos's "
              "default: with CUDA both must use CudaSpace, or both CudaUVMSpace.");

namespace
{
bool isForKokkos(char const* argument) { return std::strncmp(argument, "--kokkos", 8) == 0; }

// Kokkos's advice on the binding of threads goes to stdout, among what --print-parameters prints.
char quiet[] = "--kokkos-disable-warnings";

// Moves Kokkos's arguments out of argv; what is left stays in order. argv[0] goes to both.
std::vector<char*> takeKokkosArguments(int& argc, char** argv)
{
  std::vector<char*> taken(argv, argv + (argc > 0 ? 1 : 0));
  int left = static_cast<int>(taken.size());
  for (int i = left; i < argc; ++i) {
    if (isForKokkos(argv[i])) {
      taken.push_back(argv[i]);
    } else {
      argv[left++] = argv[i];
    }
  }
  argc = left;
  argv[argc] = nullptr;
  taken.push_back(quiet);
  taken.push_back(nullptr);
  return taken;
}
} // namespace

MpiScope::MpiScope(int& argc, char**& argv)
{
  // A write beyond the limit of a file's size (ulimit -f, a queue) fails, as on a full disk. By
  // default it would end the process without a word.
  std::signal(SIGXFSZ, SIG_IGN);
  int is_initialized = 0;
  MPI_Initialized(&is_initialized);
  if (!is_initialized) {
    MPI_Init(&argc, &argv);
    owns_mpi_ = true;
  }
  communicator_ = rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  auto kokkos_arguments = takeKokkosArguments(argc, argv);
  int kokkos_argc = static_cast<int>(kokkos_arguments.size()) - 1;
  char** kokkos_argv = kokkos_arguments.data();
  Tpetra::initialize(&kokkos_argc, &kokkos_argv, communicator_);
  // Kokkos has removed the options that it knows. Options, which reads the rest, refuses the
  // others.
  for (int i = 1; i < kokkos_argc; ++i) {
    argv[argc++] = kokkos_argv[i];
  }
  argv[argc] = nullptr;
}

// Tpetra finalises Kokkos only if it initialised it, and never MPI, which was there before it.
MpiScope::~MpiScope()
{
  Tpetra::finalize();
  communicator_ = Teuchos::null;
  if (owns_mpi_) {
    MPI_Finalize();
  }
}
} // namespace asperity
