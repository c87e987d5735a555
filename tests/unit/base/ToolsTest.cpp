#include "base/Hashes.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "base/WriteFailure.hpp"

#include "unit/base/Refusal.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

namespace
{
using namespace asperity;
using namespace asperity::test;

TEST(Checksum, SeesASingleBitAndWhereAListEnds)
{
  std::vector<char> bytes(1000, 'x');
  const auto before = Checksum().add(bytes).value();
  bytes[500] ^= 1;
  EXPECT_NE(Checksum().add(bytes).value(), before);
  const std::vector<int> one{1}, two{1, 2}, last{2};
  EXPECT_NE(Checksum().add(one).add(last).value(), Checksum().add(two).value());
}

TEST(NearestName, Distances)
{
  EXPECT_EQ(editDistance("", "abc"), 3u);
  EXPECT_EQ(editDistance("abc", ""), 3u);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
  EXPECT_EQ(editDistance("Largets", "Largest"), 1u);
  EXPECT_EQ(editDistance("ABC", "abc"), 0u);
}

TEST(NearestName, OnlyNamesThatAreNear)
{
  const std::vector<std::string> names = {"Largest Step", "Smallest Step", "Tolerance"};
  EXPECT_EQ(nearestName("Larges Step", names), "Largest Step");
  EXPECT_EQ(nearestName("largest step", names), "Largest Step");
  EXPECT_EQ(nearestName("Colour", names), "");
  EXPECT_EQ(nearestName("c", {"a", "b"}), ""); // nothing in common
  EXPECT_EQ(didYouMean("Tolerence", names), " Did you mean 'Tolerance'?");
  EXPECT_EQ(didYouMean("Colour", {"a", "b"}), " Valid names are 'a', 'b'.");
}

TEST(Text, Numbers)
{
  EXPECT_EQ(formatNumber(0.1), "0.1");
  EXPECT_EQ(formatNumber(1.0), "1");
  EXPECT_EQ(formatNumber(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(std::stod(formatNumber(1.0 / 3.0)), 1.0 / 3.0);
  EXPECT_EQ(formatShort(1.0 / 3.0), "0.333333");
  EXPECT_EQ(readNumber(" +1.5e3 "), 1500.0);
  EXPECT_FALSE(readNumber("1.5 m") || readNumber("") || readNumber("inf") || readNumber("+") ||
               readNumber("+-1"));
  EXPECT_EQ(readInteger("-12"), -12);
  EXPECT_FALSE(readInteger("1.0") || readInteger("3000000000") || readInteger(""));
}

TEST(Text, Durations)
{
  EXPECT_EQ(formatDuration(0), "0 s");
  EXPECT_EQ(formatDuration(850e-9), "850 ns");
  EXPECT_EQ(formatDuration(2.5e-6), "2.5 us");
  EXPECT_EQ(formatDuration(12.5e-3), "12.5 ms");
  EXPECT_EQ(formatDuration(48.3), "48.3 s");
  EXPECT_EQ(formatDuration(59.98), "1 min");
  EXPECT_EQ(formatDuration(200), "3 min 20 s");
  EXPECT_EQ(formatDuration(3599.8), "1 h");
  EXPECT_EQ(formatDuration(7500), "2 h 5 min");
  EXPECT_EQ(formatDuration(3 * 86400.0 + 4 * 3600.0), "3 d 4 h");
  EXPECT_EQ(formatDuration(12.5 * 365.25 * 86400), "12.5 years");
  EXPECT_EQ(formatDuration(2500 * 365.25 * 86400), "2500 years");
  EXPECT_EQ(formatDuration(1.2e6 * 365.25 * 86400), "1.2 million years");
  EXPECT_EQ(formatDuration(-200), "-3 min 20 s");
  EXPECT_EQ(formatDuration(std::numeric_limits<double>::infinity()), "inf s");
}

TEST(Text, Counts)
{
  EXPECT_EQ(counted(1, "step"), "1 step");
  EXPECT_EQ(counted(0, "step"), "0 steps");
  EXPECT_EQ(counted(12345678901, "node"), "12345678901 nodes");
}

TEST(Text, Pieces)
{
  EXPECT_EQ(trimmed("  a b\n"), "a b");
  EXPECT_EQ(trimmed("  "), "");
  EXPECT_EQ(excerpt("a\nb\tc"), "a b c");
  EXPECT_EQ(excerpt(std::string(300, 'x')), std::string(200, 'x') + "...");
  EXPECT_EQ(split("a / b/", '/'), (std::vector<std::string>{"a", "b", ""}));
  EXPECT_EQ(split("", '/'), (std::vector<std::string>{""}));
  EXPECT_EQ(quotedNames({"a", "b"}), "'a', 'b'");
  EXPECT_EQ(quotedAlternatives({"a", "b", "c"}), "'a', 'b' or 'c'");
}
TEST(WriteFailure, SaysWhatTheSystemSays)
{
  test::TemporaryDirectory directory;
  auto const folder = std::filesystem::path(directory.file("x")).parent_path();
  EXPECT_EQ(writeFailureReason(folder / "there is space"), "Is the disk full?");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::ofstream(folder / "mine") << "words";
  EXPECT_EQ(writeFailureReason(folder / "mine"), "Is the disk full?");
  EXPECT_EQ(std::filesystem::file_size(folder / "mine"), 5u);
  EXPECT_EQ(writeFailureReason(folder / "gone" / "mine"),
            "The system says: No such file or directory.");
  EXPECT_EQ(writeFailureReason(folder), "The system says: Is a directory.");
}
} // namespace
