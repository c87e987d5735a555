#include "base/Archive.hpp"
#include "unit/base/Refusal.hpp"

using namespace asperity;

TEST(Archive, KeepsEveryKindOfValue)
{
  Archive archive;
  archive.set("count", 3);
  archive.set("flag", true);
  archive.set("time", 0.1);
  archive.set("name", std::string("wedge"));
  archive.set("state/velocity", std::vector<double>{1, 2});
  archive.set("state/steps", std::vector<std::int64_t>{-1, std::int64_t(1) << 60});
  EXPECT_EQ(archive.getInteger("count"), 3);
  EXPECT_EQ(archive.getInteger("flag"), 1);
  EXPECT_EQ(archive.getDouble("time"), 0.1);
  EXPECT_EQ(archive.get<std::string>("name"), "wedge");
  EXPECT_EQ(archive.get<std::vector<double>>("state/velocity"), (std::vector<double>{1, 2}));
  EXPECT_EQ(archive.get<std::vector<std::int64_t>>("state/steps")[1], std::int64_t(1) << 60);
}

TEST(Archive, MissingAndMistypedValuesAreNamed)
{
  Archive archive;
  archive.set("time", 0.1);
  test::expectRefusal([&] { archive.getDouble("tame"); }, {"'tame'"});
  test::expectRefusal([&] { archive.getInteger("time"); }, {"a number as 'time'"});
}

TEST(Archive, ChildHoldsWhatWasInserted)
{
  Archive part;
  part.set("a/b", 1);
  Archive archive;
  archive.set("outputs-before", 2); // sorts next to "outputs/", but is no part of it
  archive.set("outputs0", 3);
  archive.insert("outputs", part);
  EXPECT_EQ(archive.child("outputs").values(), part.values());
  EXPECT_TRUE(archive.has("outputs/a/b"));
}
