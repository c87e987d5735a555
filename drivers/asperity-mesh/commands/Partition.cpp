#include "commands/Commands.hpp"
#include "commands/Meshes.hpp"
#include "commands/Partitioning.hpp"

#include "base/Errors.hpp"

#include <memory>
#include <string>

namespace asperity::geometry
{
namespace
{
class Partition final : public Command
{
public:
  CommandText text() const override
  {
    return {"partition",
            "FILE.h5",
            "Divides a mesh, partitioned before or not, into parts for ranks, after it has been "
            "split\n    along its faults. A mesh that is partitioned again keeps boundary and "
            "weight.",
            {"FILE.h5"}};
  }

  void declareOptions(Arguments& arguments) override
  {
    partitioning_.declare(arguments);
    arguments.value("--output", target_, "OUT.h5", "the file to be made")
      .flag("--antiplane", is_antiplane_,
            "for antiplane models: a branch slips where it ends at another fault");
    arguments.overwrite();
  }

  void run(Arguments const& arguments) override
  {
    ASPERITY_REQUIRE(partitioning_.numParts(),
                     "Option --parts is missing: the number of ranks that are to read the mesh.");
    ASPERITY_REQUIRE(!target_.empty(), "Option --output is missing: the file to be made.");
    partitioning_.check();
    arguments.requireNew(target_);
    withMesh(
      arguments.file(0),
      [&](auto const& mesh, auto const& parts) {
        ASPERITY_REQUIRE(!is_antiplane_ || !parts,
                         "Option --antiplane needs a whole mesh, but mesh file '"
                           << arguments.file(0)
                           << "' is partitioned: it was split along its faults before.");
        partitioning_.write(mesh, parts ? parts->options : mesh::PartitionOptions(), target_);
      },
      is_antiplane_ ? mesh::BranchEnd::joint : mesh::BranchEnd::tip);
  }

private:
  Partitioning partitioning_;
  std::string target_;
  bool is_antiplane_ = false;
};
} // namespace

std::unique_ptr<Command> partitionCommand() { return std::make_unique<Partition>(); }
} // namespace asperity::geometry
