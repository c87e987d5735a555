#include "scenario/run/Checkpoints.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/program/Plugins.hpp"
#include "base/program/WorkTimers.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "scenario/run/WholeBodyArchive.hpp"

namespace asperity::scenario
{
template <int Dim>
NodeSets nodeSets(Problem<Dim> const& problem, Domains const& domains)
{
  auto const& ids = problem.mesh().global_ids;
  NodeSets sets;
  sets[nodes_of_body].assign(ids.begin(), ids.begin() + problem.mesh().num_owned);
  auto& friction = sets[nodes_of_friction]; // also of a rank without nodes of the fault
  for (const int vertex : problem.surface().vertices()) {
    friction.push_back(ids[vertex]);
  }
  if (problem.model.body.cells) {
    sets[yielding_cells] = problem.model.body.cells->sharing().numbers();
  }
  for (auto const& [name, domain] : domains) {
    sets[name].assign(domain.node_numbers.begin(), domain.node_numbers.end());
  }
  return sets;
}

template NodeSets nodeSets(Problem<2> const&, Domains const&);
template NodeSets nodeSets(Problem<3> const&, Domains const&);

Checkpoints::Checkpoints(std::filesystem::path const& directory,
                         CheckpointIntervals const& intervals,
                         std::vector<std::string> const& plugins, io::Fingerprint fingerprint,
                         RCP<const Communicator> const& communicator)
    : directory_(directory)
    , interval_(intervals.num_steps)
    , minutes_(intervals.minutes)
    , plugins_(contentOfPlugins(plugins))
    , fingerprint_(std::move(fingerprint))
    , communicator_(communicator)
{
}

// A law with the same name but another formula would continue the state of the earlier law.
Archive Checkpoints::read(std::string const& restart, NodeSets const& here) const
{
  auto archive = io::readCheckpoint(restart, fingerprint_, *communicator_, here);
  onEveryRank(*communicator_, [&] {
    ASPERITY_REQUIRE(archive.get<std::string>("plugins") == plugins_,
                     restart << " was written with other plugin libraries (--plugin), or with "
                                "libraries of the same names and other content. Restart with the "
                                "same libraries, or begin a new run from its state with "
                                "--restart-from.");
  });
  return archive;
}

bool Checkpoints::isTime() const { return Clock::now() - last_ >= minutes_; }

void Checkpoints::write(std::function<void(Archive&)> const& save, NodeSets const& here)
{
  onRoot(*communicator_, [&] {
    if (!std::filesystem::is_directory(directory_)) {
      throw OutputError("The output directory " + directory_.string() +
                        " has been removed while the run was writing to it. Its results are lost: "
                        "begin a new run.");
    }
  });
  ASPERITY_TIME_WORK("checkpoints");
  Archive archive;
  save(archive);
  archive.set("plugins", plugins_);
  io::writeCheckpoint(file(), archive, fingerprint_, *communicator_, here);
  last_ = Clock::now();
}
} // namespace asperity::scenario
