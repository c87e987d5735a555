#include "measuring/MessageCounts.hpp"

#include "base/parallel/Messages.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"

#include <mpi.h>

#include <vector>

namespace
{
std::map<char const*, MessageCount>& counts()
{
  static std::map<char const*, MessageCount> all; // the pointers are compared, not the texts
  return all;
}

void countMessage(int count, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  auto& current = counts()[asperity::currentWork()];
  ++current.messages;
  current.bytes += std::int64_t(count) * size;
}

void countReduction() { ++counts()[asperity::currentWork()].reductions; }
} // namespace

// Every library that the program loads calls these instead of MPI's.
extern "C" {
int MPI_Send(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
{
  countMessage(count, type);
  return PMPI_Send(data, count, type, to, tag, comm);
}
int MPI_Rsend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
{
  countMessage(count, type);
  return PMPI_Rsend(data, count, type, to, tag, comm);
}
int MPI_Ssend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
{
  countMessage(count, type);
  return PMPI_Ssend(data, count, type, to, tag, comm);
}
int MPI_Isend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request* request)
{
  countMessage(count, type);
  return PMPI_Isend(data, count, type, to, tag, comm, request);
}
int MPI_Irsend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
               MPI_Request* request)
{
  countMessage(count, type);
  return PMPI_Irsend(data, count, type, to, tag, comm, request);
}
int MPI_Allreduce(const void* mine, void* all, int count, MPI_Datatype type, MPI_Op operation,
                  MPI_Comm comm)
{
  countReduction();
  return PMPI_Allreduce(mine, all, count, type, operation, comm);
}
int MPI_Reduce(const void* mine, void* all, int count, MPI_Datatype type, MPI_Op operation,
               int root, MPI_Comm comm)
{
  countReduction();
  return PMPI_Reduce(mine, all, count, type, operation, root, comm);
}
int MPI_Bcast(void* data, int count, MPI_Datatype type, int root, MPI_Comm comm)
{
  countReduction();
  return PMPI_Bcast(data, count, type, root, comm);
}
int MPI_Barrier(MPI_Comm comm)
{
  countReduction();
  return PMPI_Barrier(comm);
}
int MPI_Allgather(const void* mine, int count, MPI_Datatype type, void* all, int all_count,
                  MPI_Datatype all_type, MPI_Comm comm)
{
  countReduction();
  return PMPI_Allgather(mine, count, type, all, all_count, all_type, comm);
}
int MPI_Alltoall(const void* mine, int count, MPI_Datatype type, void* all, int all_count,
                 MPI_Datatype all_type, MPI_Comm comm)
{
  countReduction();
  return PMPI_Alltoall(mine, count, type, all, all_count, all_type, comm);
}
}

MessageCounts messagesSoFar()
{
  MessageCounts all;
  for (auto const& [name, count] : counts()) {
    auto& sum = all[name];
    sum.messages += count.messages;
    sum.bytes += count.bytes;
    sum.reductions += count.reductions;
  }
  return all;
}

void addDifference(MessageCounts const& after, MessageCounts const& before, MessageCounts& sum)
{
  for (auto const& [name, now] : after) {
    auto const found = before.find(name);
    const MessageCount then = found == before.end() ? MessageCount{} : found->second;
    auto& total = sum[name];
    total.messages += now.messages - then.messages;
    total.bytes += now.bytes - then.bytes;
    total.reductions += now.reductions - then.reductions;
  }
}

MessageCounts largestOfRanks(MessageCounts const& mine, asperity::Communicator const& communicator)
{
  // All ranks do the same kinds of work, so that they have the same names.
  std::vector<std::int64_t> numbers;
  for (auto const& [name, count] : mine) {
    numbers.insert(numbers.end(), {count.messages, count.bytes, count.reductions});
  }
  auto const largest = asperity::maxOverRanks(numbers, communicator);
  MessageCounts result;
  auto number = largest.begin();
  for (auto const& [name, count] : mine) {
    result[name] = {number[0], number[1], number[2]};
    number += 3;
  }
  return result;
}
