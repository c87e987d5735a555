#include "FuzzTarget.hpp"

#include "CheckpointSample.hpp"
#include "FileRecipe.hpp"

#include "base/Errors.hpp"
#include "io/checkpoint/Checkpoint.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

// The input is a checkpoint, or a recipe of one (FileRecipe.hpp). It is read by a run that has the
// nodes in the same order, and by one that has them in another.
namespace asperity::fuzz
{
namespace
{
void read(std::string const& path, NodeSets const& nodes)
{
  const Teuchos::MpiComm<int> communicator(MPI_COMM_SELF);
  const auto archive = io::readCheckpoint(path, sampleFingerprint(), communicator, nodes);
  if (archive.has("state/time")) {
    archive.getDouble("state/time");
  }
}
} // namespace

void tryInput(std::string const& input)
{
  const Scratch file("checkpoint.h5");
  if (!makeFile(input, file)) {
    return;
  }
  auto nodes = sampleNodes();
  std::string refusal;
  try {
    read(file.path(), nodes);
  } catch (InputError const& error) {
    refusal = error.what();
  }
  std::swap(nodes["body"].front(), nodes["body"].back());
  read(file.path(), nodes);
  if (!refusal.empty()) {
    throw InputError(refusal);
  }
}
} // namespace asperity::fuzz
