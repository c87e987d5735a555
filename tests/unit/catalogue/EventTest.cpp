#include "catalogue/events/Event.hpp"
#include "unit/io/Support.hpp"

#include <cmath>

using namespace asperity;
using catalogue::Event;

namespace
{
std::vector<Event> events(int number)
{
  std::vector<Event> events;
  for (int i = 0; i < number; ++i) {
    Event event;
    event.number = i + 1;
    event.onset = 10.0 * i * i;
    event.end = event.onset + 0.5;
    event.width = 0.1 * (i + 1);
    events.push_back(event);
  }
  return events;
}

std::vector<std::string> printed(int number)
{
  std::ostringstream out;
  catalogue::printEvents(out, events(number));
  std::vector<std::string> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}
} // namespace

TEST(EventSummary, QuartilesAreThoseOfNumpy)
{
  auto five = events(5); // onsets 0, 10, 40, 90, 160
  five.back().complete = false;
  const auto summary = catalogue::summarise(five);
  EXPECT_EQ(summary.num_events, 5);
  EXPECT_DOUBLE_EQ(summary.recurrence.lower, 25); // of 10, 30, 50, 70
  EXPECT_DOUBLE_EQ(summary.recurrence.median, 40);
  EXPECT_DOUBLE_EQ(summary.recurrence.upper, 55);
  EXPECT_DOUBLE_EQ(summary.width.median, 0.25); // of the four complete ones
  EXPECT_DOUBLE_EQ(summary.duration.median, 0.5);
}

TEST(EventSummary, OfNothingIsNotANumber)
{
  EXPECT_TRUE(std::isnan(catalogue::summarise({}).recurrence.median));
  EXPECT_TRUE(std::isnan(catalogue::summarise(events(1)).recurrence.median));
  EXPECT_DOUBLE_EQ(catalogue::summarise(events(1)).width.upper, 0.1);
  std::ostringstream out;
  catalogue::printSummary(out, catalogue::summarise({}));
  EXPECT_EQ(out.str(), "0 events\n");
  std::ostringstream of_one;
  catalogue::printSummary(of_one, catalogue::summarise(events(1)));
  EXPECT_EQ(of_one.str().find("nan"), std::string::npos) << of_one.str();
  EXPECT_EQ(of_one.str().find("recurrence"), std::string::npos);
  test::expectParts(of_one.str(), {"width"});
}

TEST(EventTable, ColumnsAreAligned)
{
  const auto lines = printed(12);
  ASSERT_EQ(lines.size(), 13u);
  const auto column_end = lines[0].find("onset [s]") + 9;
  EXPECT_EQ(lines[12].substr(column_end - 4, 4), "1210");
  EXPECT_EQ(lines[2].substr(column_end - 3, 3), " 10");
}

TEST(EventTable, LongTablesAreCutInTheMiddle)
{
  EXPECT_EQ(printed(30).size(), 31u);
  const auto lines = printed(100);
  ASSERT_EQ(lines.size(), 32u);
  test::expectParts(lines[15], {"   15  "});
  test::expectParts(lines[16], {"..."});
  test::expectParts(lines[17], {"   86  "});
  test::expectParts(lines[31], {"  100  "});
}
