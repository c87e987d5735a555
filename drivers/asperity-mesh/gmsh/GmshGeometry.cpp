#include "gmsh/GmshGeometry.hpp"

#include "Warnings.hpp"
#include "assembly/GroupNames.hpp"
#include "gmsh/GmshSession.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "base/WriteFailure.hpp"

#include <gmsh.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace asperity::geometry
{
namespace
{
std::string whereIs(std::string const& file_name) { return "Gmsh geometry '" + file_name + "'"; }

std::string withoutComments(std::string const& script)
{
  return std::regex_replace(script, std::regex("//[^\n]*|/\\*[^*]*\\*+([^/*][^*]*\\*+)*/"), " ");
}

// Gmsh reads one statement of a last line that does not end, and is silent on the others.
void requireThatLastLineEnds(std::string const& script, std::string const& where)
{
  const std::string line = trimmed(script.substr(script.rfind('\n') + 1));
  const auto end = line.find(';');
  ASPERITY_REQUIRE(end == std::string::npos || end + 1 == line.size(),
                   where << ": there is no newline at the end of the last line. Gmsh would read of "
                            "it only '"
                         << line.substr(0, end + 1) << "'. Add a newline at the end of the file.");
}

// Without comments.
std::string readOne(std::string const& file_name)
{
  std::ifstream file(file_name);
  ASPERITY_REQUIRE(file.is_open(), whereIs(file_name)
                                     << " cannot be opened. Is it there, and may you read it?");
  std::ostringstream text;
  text << file.rdbuf();
  const auto script = withoutComments(text.str());
  requireThatLastLineEnds(script, whereIs(file_name));
  return script;
}

// The script followed by those that it includes, whose names are relative to its folder.
std::string readScript(std::string const& file_name, int depth = 0)
{
  constexpr int deepest = 10; // Gmsh refuses scripts that include each other
  std::string script = readOne(file_name);
  const std::string own = script;
  const std::regex include("Include\\s*\"([^\"]*)\"");
  for (std::sregex_iterator found(own.begin(), own.end(), include), none;
       found != none && depth < deepest; ++found) {
    const auto folder = std::filesystem::path(file_name).parent_path();
    script += readScript((folder / (*found)[1].str()).string(), depth + 1);
  }
  return script;
}

// The text from `begin` up to the bracket that closes what was opened before it.
std::string upToBracket(std::string const& script, std::size_t begin)
{
  int depth = 1;
  std::size_t end = begin;
  for (; end < script.size() && depth > 0; ++end) {
    depth += script[end] == '[' || script[end] == '(' ? 1 : 0;
    depth -= script[end] == ']' || script[end] == ')' ? 1 : 0;
  }
  return script.substr(begin, end - begin);
}
// The names that the script, which is without comments, defines by DefineConstant, in their order,
// each once.
std::vector<std::string> constantsOf(std::string const& script)
{
  const std::string text = std::regex_replace(script, std::regex("\"[^\"]*\""), "\"\"");
  std::vector<std::string> names;
  const std::regex beginning("DefineConstant\\s*[\\[(]"), braces("\\{[^{}]*\\}"),
    name("(\\w+)\\s*=");
  for (std::sregex_iterator found(text.begin(), text.end(), beginning), none; found != none;
       ++found) {
    const auto begin = static_cast<std::size_t>(found->position() + found->length());
    std::string list = upToBracket(text, begin);
    for (std::string shorter; shorter != list;) { // innermost braces first
      shorter = list;
      list = std::regex_replace(list, braces, "0");
    }
    for (std::sregex_iterator one(list.begin(), list.end(), name); one != none; ++one) {
      if (std::find(names.begin(), names.end(), (*one)[1]) == names.end()) {
        names.push_back((*one)[1]);
      }
    }
  }
  return names;
}

// A MathEval field that names another one: Gmsh 4.8 locks itself out when it evaluates the second.
void warnOfFieldsThatWait(std::string const& script, std::string const& where)
{
  std::set<std::string> formulas; // numbers of fields
  const std::regex of_type("Field\\s*\\[\\s*(\\d+)\\s*\\]\\s*=\\s*MathEval\\b"),
    formula("Field\\s*\\[\\s*(\\d+)\\s*\\]\\s*\\.\\s*F\\s*=([^;]*);"), name("\\bF(\\d+)\\b");
  for (std::sregex_iterator one(script.begin(), script.end(), of_type), none; one != none; ++one) {
    formulas.insert((*one)[1]);
  }
  for (std::sregex_iterator one(script.begin(), script.end(), formula), none; one != none; ++one) {
    const std::string text = (*one)[2];
    for (std::sregex_iterator other(text.begin(), text.end(), name); other != none; ++other) {
      if (formulas.count((*one)[1]) > 0 && formulas.count((*other)[1]) > 0) {
        warn(where + ": Field[" + (*one)[1].str() + "] and Field[" + (*other)[1].str() +
             "] are MathEval, and the first has F" + (*other)[1].str() +
             " in its formula. Gmsh 4.8 waits for ever there, without work. If nothing goes on, "
             "stop it, and write the second formula into the first.");
      }
    }
  }
}

std::map<std::string, double> readConstants(std::string const& script,
                                            std::vector<std::string> const& settings,
                                            std::string const& where)
{
  const auto known = constantsOf(script);
  std::map<std::string, double> constants;
  for (auto const& setting : settings) {
    const auto equals = setting.find('=');
    const std::string name = trimmed(setting.substr(0, equals));
    ASPERITY_REQUIRE(equals != std::string::npos && !name.empty(),
                     "Option --set " << setting << " is not of the form NAME=VALUE.");
    const auto value = readNumber(trimmed(setting.substr(equals + 1)));
    ASPERITY_REQUIRE(value, "Option --set " << setting << ": what follows '=' is not a number.");
    ASPERITY_REQUIRE(std::find(known.begin(), known.end(), name) != known.end(),
                     "Option --set " << setting << ": " << where << " defines no constant '" << name
                                     << "', only " << quotedNames(known) << " (DefineConstant)."
                                     << didYouMean(name, known));
    ASPERITY_REQUIRE(constants.emplace(name, *value).second,
                     "Option --set gives '" << name << "' twice.");
  }
  return constants;
}

double option(char const* name)
{
  double value = 0;
  gmsh::option::getNumber(name, value);
  return value;
}

// Gmsh saves cells of physical groups alone, unless it is to save all.
void warnOfCellsNotSaved(PhysicalGroups const& groups, int dimension, std::string const& where)
{
  std::set<int> named;
  for (auto const& region : groups.regions) {
    named.insert(region.entities.begin(), region.entities.end());
  }
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dimension);
  for (auto const& [dim, entity] : entities) {
    if (named.count(entity) == 0 && option("Mesh.SaveAll") == 0) {
      warn(where + ": " + entityName(dim) + " " + std::to_string(entity) + " is in no physical " +
           entityName(dim) + ". Gmsh does not save its cells: the body ends there.");
    }
  }
}

void requireLinearSimplices(int dimension, std::string const& where)
{
  const double order = option("Mesh.ElementOrder");
  ASPERITY_REQUIRE(order == 1,
                   where << ": Mesh.ElementOrder = " << order
                         << ", and only cells of first order can be used. Remove it, or give "
                            "--simplices, which leaves the other nodes out.");
  ASPERITY_REQUIRE(dimension == 3 || option("Mesh.RecombineAll") == 0,
                   where << ": Mesh.RecombineAll makes quadrangles, and only triangles can be used "
                            "in the plane. Remove it, or give --simplices, which cuts them.");
}

// Gmsh throws some errors in threads of its own, where they cannot be caught. Therefore it is told
// to stop and note an error, and the error is read afterwards.
void generate(int dimension, std::string const& where)
{
  gmsh::option::setNumber("General.AbortOnError", 1); // stop meshing, throw nothing
  const auto thrown = errorOfGmsh([&] { gmsh::model::mesh::generate(dimension); });
  std::string last;
  gmsh::logger::getLastError(last);
  last = trimmed(last);
  ASPERITY_REQUIRE(thrown.empty() && last.empty(),
                   where << " cannot be meshed by Gmsh: " << (last.empty() ? thrown : last) << '.');
}

// Gmsh does not say whether it could write all. A section that is complete ends with $End....
bool isComplete(std::string const& mesh)
{
  constexpr int longest = 100; // of the last line
  std::ifstream file(mesh, std::ios::binary | std::ios::ate);
  if (!file) {
    return false;
  }
  const auto size = static_cast<std::streamoff>(file.tellg());
  file.seekg(std::max<std::streamoff>(0, size - longest));
  std::string end(std::istreambuf_iterator<char>(file), {});
  const auto last = end.rfind("\n$End");
  return last != std::string::npos && end.back() == '\n' &&
         end.find('\n', last + 1) == end.size() - 1;
}

void write(std::string const& target)
{
  const bool is_text = option("Mesh.MshFileVersion") == 4.0;  // Gmsh writes this one as text alone
  gmsh::option::setNumber("Mesh.Binary", is_text ? 0 : 1);    // binary: all digits
  gmsh::option::setNumber("Mesh.PartitionSplitMeshFiles", 0); // one file
  const auto error = errorOfGmsh([&] { gmsh::write(target); });
  if (!error.empty() || !isComplete(target)) {
    throw OutputError("'" + target + "' cannot be written by Gmsh. " + error +
                      writeFailureReason(target));
  }
}
} // namespace

std::string meshGeometry(std::string const& file_name, std::vector<std::string> const& settings,
                         GroupNames const& names, bool allowed,
                         std::function<std::string()> const& target)
{
  const auto where = whereIs(file_name);
  const auto script = readScript(file_name);
  ASPERITY_REQUIRE(script.find("SystemCall") == std::string::npos,
                   where << " runs other programs (SystemCall). Remove that.");
  std::vector<std::string> arguments;
  for (auto const& [name, value] : readConstants(script, settings, where)) {
    arguments.insert(arguments.end(), {"-setnumber", name, formatNumber(value)});
  }
  const GmshSession session(true, arguments);
  session.open(file_name, where);
  const int dimension = gmsh::model::getDimension();
  ASPERITY_REQUIRE(dimension >= 2, where << " has neither a surface nor a volume to be meshed.");
  if (!allowed) {
    requireLinearSimplices(dimension, where);
  }
  const auto groups = physicalGroups(dimension, names, where);
  printRemarks(groups);
  warnOfCellsNotSaved(groups, dimension, where);
  warnOfFieldsThatWait(script, where);
  generate(dimension, where);
  const auto mesh = target();
  write(mesh);
  return mesh;
}

void printRemarks(PhysicalGroups const& groups)
{
  for (auto const& remark : groups.remarks) {
    std::cout << remark << '\n';
  }
  std::cout.flush();
  for (auto const& warning : groups.warnings) {
    warn(warning);
  }
}
} // namespace asperity::geometry
