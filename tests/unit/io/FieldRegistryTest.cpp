#include "io/FieldRegistry.hpp"
#include "unit/io/Support.hpp"

using namespace asperity;
using io::FieldRegistry;
using io::OutputField;
using io::OutputScalar;

namespace
{
OutputField field(std::string const& domain, std::string const& name)
{
  return {name, "m", "A test.", domain, 1, [](std::vector<double>& values) { values = {1}; }};
}
} // namespace

TEST(FieldRegistry, FindsByLocationAndName)
{
  FieldRegistry registry;
  registry.add(field("fault", "slip"));
  OutputField const& slip = registry.field("fault", "slip");
  for (int i = 0; i < 100; ++i) { // references stay valid
    registry.add(field("surface", "slip" + std::to_string(i)));
  }
  EXPECT_EQ(&slip, &registry.field("fault", "slip"));
  EXPECT_TRUE(registry.hasField("surface", "slip7"));
  EXPECT_FALSE(registry.hasField("volume", "slip7"));
  EXPECT_EQ(registry.fieldNames("fault"), std::vector<std::string>{"slip"});
}

TEST(FieldRegistry, UnknownNamesGetTheNearest)
{
  FieldRegistry registry;
  registry.add(field("fault", "slip_rate"));
  registry.add(field("fault", "alpha"));
  registry.add(OutputScalar{"fixed_point_iterations", "", "A test.", [] { return 3.0; }});
  test::expectRefusal([&] { registry.field("fault", "slip rate"); },
                      {"'slip rate' on the fault", "'slip_rate'?"});
  test::expectRefusal([&] { registry.scalar("fixed_point_iteration"); },
                      {"Did you mean 'fixed_point_iterations'?"});
  EXPECT_EQ(registry.scalar("fixed_point_iterations").value(), 3.0);
}

TEST(FieldRegistry, ANameIsGivenOnce)
{
  FieldRegistry registry;
  registry.add(field("fault", "slip"));
  registry.add(field("surface", "slip"));
  EXPECT_THROW(registry.add(field("fault", "slip")), std::logic_error);
}
