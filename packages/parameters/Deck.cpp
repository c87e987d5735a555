#include "parameters/Deck.hpp"

#include "parameters/XmlDeck.hpp"

#include <fstream>

namespace asperity
{
namespace
{
constexpr auto root_name = "Asperity";

void readInto(ParameterList& list, std::string const& file_name)
{
  const auto root = parseXml(file_name);
  ASPERITY_REQUIRE(
    root.getTag() == "ParameterList" && root.hasAttribute("name") &&
      root.getAttribute("name") == root_name,
    "The deck '" << file_name << "' does not begin with <ParameterList name=\"" << root_name
                 << "\">, but with <" << root.getTag()
                 << (root.hasAttribute("name") ? " name=\"" + root.getAttribute("name") + "\"" : "")
                 << ">.");
  readList(root, file_name, root_name, list);
}
} // namespace

Teuchos::RCP<ParameterList> readDeck(std::string const& file_name)
{
  auto list = Teuchos::rcp(new ParameterList(root_name));
  readInto(*list, file_name);
  return list;
}

void overlayDeck(ParameterList& list, std::string const& file_name) { readInto(list, file_name); }

void writeParameters(ParameterList const& list, std::string const& file_name)
{
  std::ofstream out(file_name);
  out << "<!-- Every parameter of the run, those left out of the deck with their defaults. -->\n";
  writeXml(list, root_name, out, 0);
  out.close();
  if (!out) {
    throw OutputError("'" + file_name +
                      "' cannot be written. Does the directory exist, and is the disk full?");
  }
}
} // namespace asperity
