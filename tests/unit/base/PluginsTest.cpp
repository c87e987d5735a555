#include "base/program/Plugins.hpp"

#include "unit/base/Refusal.hpp"
#include "unit/base/TemporaryDirectory.hpp"

namespace
{
using namespace asperity;
using namespace asperity::test;
using Names = std::vector<std::string>;

// A library that registers nothing by itself; `before` and `after` say what there is.
void load(Names const& before, Names const& after)
{
  int calls = 0;
  loadPlugins({ASPERITY_EMPTY_PLUGIN}, [&] { return calls++ == 0 ? before : after; });
}

TEST(Plugins, ABroughtNameIsWelcome)
{
  EXPECT_NO_THROW(load({"state law 'Slip'"}, {"state law 'Slip'", "state law 'Mine'"}));
}

TEST(Plugins, NothingBroughtIsRefused)
{
  const auto message = refusal([] { load({"state law 'Slip'"}, {"state law 'Slip'"}); });
  expectParts(message, {ASPERITY_EMPTY_PLUGIN, "registers nothing here"});
}

TEST(Plugins, ANameThatIsTakenIsRefused)
{
  expectRefusal(
    [] {
      load({"state law 'Slip'"}, {"state law 'Slip'", "state law 'Slip'"});
    },
    {ASPERITY_EMPTY_PLUGIN, "registers the state law 'Slip', which is there already"});
  expectRefusal([] { load({}, {"output 'Mine'", "output 'Mine'"}); }, {"output 'Mine'"});
}

TEST(Plugins, AFileThatIsNoLibraryIsRefused)
{
  const test::TemporaryDirectory directory;
  const auto file = directory.write("text.so", "no library");
  const auto nothing = [] { return Names(); };
  expectRefusal([&] { loadPlugins({file}, nothing); }, {file, "cannot be loaded"});
  expectRefusal([&] { loadPlugins({"none.so"}, nothing); }, {"'none.so' is no file"});
}
} // namespace
