#include "GmshGeometry.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"

#include <gmsh.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace
{
std::string whereIs(std::string const& file_name) { return "Gmsh geometry '" + file_name + "'"; }

std::string withoutComments(std::string const& script)
{
  return std::regex_replace(script, std::regex("//[^\n]*|/\\*[^*]*\\*+([^/*][^*]*\\*+)*/"), " ");
}

// Without comments.
std::string readOne(std::string const& file_name)
{
  std::ifstream file(file_name);
  ASPERITY_REQUIRE(file.is_open(), whereIs(file_name)
                                     << " cannot be opened. Is it there, and may you read it?");
  std::ostringstream text;
  text << file.rdbuf();
  return withoutComments(text.str());
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
} // namespace

bool isGeometry(std::string const& file_name)
{
  return std::filesystem::path(file_name).extension() == ".geo";
}

std::map<std::string, double> readConstants(std::string const& file_name,
                                            std::vector<std::string> const& settings)
{
  const auto script = readScript(file_name);
  ASPERITY_REQUIRE(script.find("SystemCall") == std::string::npos,
                   whereIs(file_name) << " runs other programs (SystemCall). Remove that.");
  const auto known = constantsOf(script);
  std::map<std::string, double> constants;
  for (auto const& setting : settings) {
    const auto equals = setting.find('=');
    const std::string name = asperity::trimmed(setting.substr(0, equals));
    ASPERITY_REQUIRE(equals != std::string::npos && !name.empty(),
                     "Option --set " << setting << " is not of the form NAME=VALUE.");
    const auto value = asperity::readNumber(asperity::trimmed(setting.substr(equals + 1)));
    ASPERITY_REQUIRE(value, "Option --set " << setting << ": what follows '=' is not a number.");
    ASPERITY_REQUIRE(std::find(known.begin(), known.end(), name) != known.end(),
                     "Option --set " << setting << ": " << whereIs(file_name)
                                     << " defines no constant '" << name << "', only "
                                     << asperity::quotedNames(known) << " (DefineConstant)."
                                     << asperity::didYouMean(name, known));
    ASPERITY_REQUIRE(constants.emplace(name, *value).second,
                     "Option --set gives '" << name << "' twice.");
  }
  return constants;
}

std::string errorOfGmsh(std::function<void()> const& call)
{
  try {
    call();
  } catch (std::string const& reason) {
    return reason;
  } catch (std::exception const& error) {
    return error.what();
  }
  return "";
}

// Gmsh throws some errors in threads of its own, where they cannot be caught. Therefore it is told
// to stop and note an error, and the error is read afterwards.
void meshGeometry(std::string const& where)
{
  const int dimension = gmsh::model::getDimension();
  ASPERITY_REQUIRE(dimension >= 2, where << " has neither a surface nor a volume to be meshed.");
  gmsh::option::setNumber("General.AbortOnError", 1); // stop meshing, throw nothing
  const auto thrown = errorOfGmsh([&] { gmsh::model::mesh::generate(dimension); });
  std::string last;
  gmsh::logger::getLastError(last);
  last = asperity::trimmed(last);
  ASPERITY_REQUIRE(thrown.empty() && last.empty(),
                   where << " cannot be meshed by Gmsh: " << (last.empty() ? thrown : last) << '.');
}
