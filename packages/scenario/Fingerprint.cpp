#include "scenario/Fingerprint.hpp"

#include "base/Hashes.hpp"
#include "base/parallel/Agreement.hpp"
#include "dynamics/control/StepControlKind.hpp"
#include "dynamics/watches/Watch.hpp"
#include "io/checkpoint/MeshChecksum.hpp"
#include "parameters/ParameterInfo.hpp"
#include "parameters/fields/TableFile.hpp"
#include "parameters/fields/VertexDataset.hpp"
#include "scenario/deck/Tables.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <map>
#include <sstream>

namespace asperity::scenario
{
namespace
{
const std::string mesh_file = "Asperity / Mesh / File / File Name";

bool namesTableFile(std::string const& path, Teuchos::ParameterEntry const& entry)
{
  auto const info = parameterInfo(entry);
  auto const tables = joinPath(joinPath("Asperity", tables_list), "");
  return path.compare(0, tables.size(), tables) == 0 && !info.is_null() &&
         info->kind == ParameterKind::file_name;
}

// Collects an entry for each parameter, in the order of the lists, which matters for regions and
// boundary conditions.
template <int Dim>
class Collection
{
public:
  Collection(Mesh<Dim> const& mesh, Communicator const& communicator)
      : mesh_(mesh)
      , communicator_(communicator)
  {
  }

  void add(ParameterList const& list, std::string const& path)
  {
    for (auto const& item : list) {
      auto const name = joinPath(path, item.first);
      Teuchos::ParameterEntry const& entry = item.second;
      if (entry.isList()) {
        add(Teuchos::getValue<ParameterList>(entry), name);
      } else if (entry.isType<std::string>()) {
        addText(name, Teuchos::getValue<std::string>(entry), namesTableFile(name, entry));
      } else {
        addNumber(name, entry);
      }
    }
  }

  // Another version of the program, or of METIS, may number the same mesh differently.
  void addNumbering()
  {
    const auto checksum = io::checksum(mesh_, io::ChecksumOf::numbering, communicator_);
    result_.entries.push_back({"Asperity / Mesh", hexadecimal(checksum), "the numbered mesh"});
  }

  io::Fingerprint const& result() const { return result_; }

private:
  void addText(std::string const& name, std::string const& text, bool is_table)
  {
    if (name == mesh_file) {
      const auto checksum = io::checksum(mesh_, io::ChecksumOf::everything, communicator_);
      result_.entries.push_back({name, hexadecimal(checksum), "mesh file '" + text + "'"});
    } else if (VertexDataset::isName(text)) {
      const auto checksum =
        checksumOnRoot(text, [&] { return VertexDataset(text, name).checksum(); });
      result_.entries.push_back({name, hexadecimal(checksum), "dataset '" + text + "'"});
    } else if (is_table) {
      const auto checksum = checksumOnRoot(text, [&] { return checksumOfFile(text, name); });
      result_.entries.push_back({name, hexadecimal(checksum), "table file '" + text + "'"});
    } else {
      result_.entries.push_back({name, text, ""});
    }
  }

  // With all digits.
  void addNumber(std::string const& name, Teuchos::ParameterEntry const& entry)
  {
    std::ostringstream text;
    text.precision(17);
    if (entry.isType<double>()) {
      text << Teuchos::getValue<double>(entry);
    } else {
      text << entry.getAny(false);
    }
    result_.entries.push_back({name, text.str(), ""});
  }

  // The first rank reads a dataset or a file, once for all parameters that name it.
  template <class Compute>
  std::uint64_t checksumOnRoot(std::string const& named, Compute const& compute)
  {
    const auto known = checksums_.find(named);
    if (known != checksums_.end()) {
      return known->second;
    }
    long long checksum = 0;
    onRoot(communicator_, [&] { checksum = static_cast<long long>(compute()); });
    Teuchos::broadcast(communicator_, 0, &checksum);
    return checksums_[named] = static_cast<std::uint64_t>(checksum);
  }

  Mesh<Dim> const& mesh_;
  Communicator const& communicator_;
  std::map<std::string, std::uint64_t> checksums_;
  io::Fingerprint result_;
};
} // namespace

template <int Dim>
io::Fingerprint fingerprint(ParameterList const& deck, Mesh<Dim> const& mesh,
                            Communicator const& communicator)
{
  ParameterList relevant(deck);
  relevant.remove(deck_lists::output);
  relevant.remove(deck_lists::solver);
  relevant.remove(deck_lists::coupling);
  auto& time = relevant.sublist(deck_lists::time);
  for (auto const* name : {time_entries::final_time, time_entries::smallest_step}) {
    time.remove(name, false);
  }
  auto const& watches = dynamics::WatchRegistry::instance();
  for (auto const& name : watches.names()) { // they look on
    auto const added = watches.at(name).validParameters();
    for (auto const& entry : *added) {
      time.remove(entry.first, false);
    }
  }
  auto const& controls = dynamics::StepControlRegistry::instance();
  for (auto const& name : controls.names()) {
    auto const& control = controls.at(name);
    auto const declared = control.validParameters();
    for (auto const& entry : *declared) {
      if (time.isSublist(name) && control.mayChange(entry.first)) {
        time.sublist(name).remove(entry.first, false);
      }
    }
  }
  Collection<Dim> collection(mesh, communicator);
  collection.add(relevant, "Asperity");
  collection.addNumbering();
  return collection.result();
}

template io::Fingerprint fingerprint(ParameterList const&, Mesh<2> const&, Communicator const&);
template io::Fingerprint fingerprint(ParameterList const&, Mesh<3> const&, Communicator const&);
} // namespace asperity::scenario
