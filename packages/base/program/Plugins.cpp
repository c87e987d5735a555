#include "base/program/Plugins.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace asperity
{
namespace
{
using Names = std::vector<std::string>;

std::string option(std::string const& file) { return "The plugin '" + file + "'"; }

// The path is made absolute: for a name without a slash the loader searches the system's folders.
void load(std::string const& file)
{
  std::error_code error;
  ASPERITY_REQUIRE(std::filesystem::is_regular_file(file, error),
                   option(file) << " is no file. Give the path of a shared library to --plugin.");
#ifdef ASPERITY_STATIC
  throw InputError(option(file) + " cannot be loaded: this program is linked statically. Configure "
                                  "Asperity with BUILD_SHARED_LIBS=ON.");
#else
  auto const path = std::filesystem::absolute(file).string();
  if (dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr) {
    throw InputError(option(file) + " cannot be loaded: " + dlerror() +
                     ". Build it as a shared library against this installation of Asperity.");
  }
#endif
}

// What stands in `after` and not in `before`, repetitions counted.
Names added(Names before, Names after)
{
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  Names difference;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::back_inserter(difference));
  return difference;
}
} // namespace

void loadPlugins(std::vector<std::string> const& files,
                 std::function<std::vector<std::string>()> const& registrations)
{
  for (auto const& file : files) {
    auto const before = registrations();
    load(file);
    auto const after = registrations();
    auto const brought = added(before, after);
    ASPERITY_REQUIRE(
      !brought.empty(),
      option(file) << " registers nothing here that is not there already. It needs a line that "
                      "begins with ASPERITY_REGISTER, has to be linked against this installation "
                      "of Asperity, and has to be given once, to the program that uses what it "
                      "registers.");
    for (auto const& name : brought) {
      ASPERITY_REQUIRE(std::count(after.begin(), after.end(), name) == 1,
                       option(file) << " registers the " << name
                                    << ", which is there already. Give it another name.");
    }
  }
}

std::string contentOfPlugins(std::vector<std::string> const& files)
{
  Names checksums;
  for (auto const& name : files) {
    std::ostringstream content;
    content << std::ifstream(name, std::ios::binary).rdbuf();
    checksums.push_back(hexadecimal(Checksum().add(content.str()).value()));
  }
  std::sort(checksums.begin(), checksums.end());
  std::string all;
  for (auto const& checksum : checksums) {
    all += checksum + ' ';
  }
  return all;
}
} // namespace asperity
