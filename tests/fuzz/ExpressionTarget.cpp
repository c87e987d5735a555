#include "FuzzTarget.hpp"

#include "parameters/fields/Expression.hpp"
#include "parameters/fields/Field.hpp"

// The input is the text of a field; it is also evaluated as one.
namespace asperity::fuzz
{
namespace
{
Field fieldOf(std::string const& text)
{
  auto const valid =
    Declare().field("Field", required, "m", Range::any(), "A field of the test.").list();
  ParameterList list;
  list.set("Field", text);
  completeAndValidate(list, *valid, "Asperity");
  return Field(list, "Field", "Asperity", {"body"});
}
} // namespace

void tryInput(std::string const& input)
{
  const Expression expression(input, "Asperity / Field");
  for (const double x : {0., -1.5, 1e308}) {
    expression({x, 2 * x, -x}, x);
  }
  const Field field = fieldOf(input);
  if (!field.isDataset()) {
    field({0.5, 0.25, -1}, 3, 0);
  }
}
} // namespace asperity::fuzz
