#include "registry/Registry.hpp"

#include <gtest/gtest.h>

namespace
{
using asperity::Registry;
using Names = std::vector<std::string>;

struct Animal
{
  static constexpr char const* registered_as = "animal";
  virtual ~Animal() = default;
  virtual std::string sound() const = 0;
};
struct Cat : Animal
{
  std::string sound() const override { return "meow"; }
};
struct Dog : Animal
{
  std::string sound() const override { return "woof"; }
};
using AnimalRegistry = Registry<Animal>;
ASPERITY_REGISTER(AnimalRegistry, "Dog", Dog)
ASPERITY_REGISTER(AnimalRegistry, "Cat", Cat)

TEST(Registry, NamesAreSortedAndPluginsFound)
{
  auto const& registry = AnimalRegistry::instance();
  EXPECT_EQ(registry.names(), (Names{"Cat", "Dog"}));
  EXPECT_EQ(registry.at("Dog").sound(), "woof");
  EXPECT_EQ(registry.registrations(), (Names{"animal 'Cat'", "animal 'Dog'"}));
}

TEST(Registry, UnknownNameWithTheKnown)
{
  try {
    AnimalRegistry::instance().at("Dgo");
    FAIL() << "an unknown name was found";
  } catch (std::out_of_range const& error) {
    EXPECT_STREQ(error.what(), "'Dgo' is not a known animal. Choose one of 'Cat', 'Dog'.");
  }
}

TEST(Registry, TheSameNameTwiceIsOurMistake)
{
  Registry<Animal> registry;
  EXPECT_TRUE(registry.add("Cat", std::make_shared<Cat>()));
  EXPECT_EQ(registry.names(), (Names{"Cat"}));
  EXPECT_FALSE(registry.add("Cat", std::make_shared<Cat>())); // not thrown: a library is loaded
  EXPECT_EQ(registry.registrations(), (Names{"animal 'Cat'", "animal 'Cat'"}));
  EXPECT_THROW(registry.names(), std::logic_error);
  EXPECT_THROW(registry.at("Cat"), std::logic_error);
}
} // namespace
