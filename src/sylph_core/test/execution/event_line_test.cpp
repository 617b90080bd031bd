#include "sylph_core/execution/event_line.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace sylph {
namespace {

const std::vector<std::string> kNames = {"robot_0", "robot_1"};

std::string errorOf(const std::string& line) {
  try {
    eventFromLine(line, kNames);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// A line whose sequence is the given text.
std::string doneLine(const std::string& sequence) {
  return R"({"stamp":1.0,"event":"done","plan_id":1,"robot":"robot_0","sequence":)" + sequence +
         "}";
}

TEST(EventLineTest, WholeNumbersAreRefusedThatTheirFieldCannotHold) {
  EXPECT_EQ("", errorOf(doneLine("-2147483648")));
  EXPECT_EQ("", errorOf(doneLine("2147483647")));
  for (const std::string number :
       {"2147483648", "-2147483649", "18446744073709551615", "1e300", "1.5", "true", "null"}) {
    const std::string error = errorOf(doneLine(number));
    EXPECT_NE(std::string::npos, error.find(": must be a whole number -2147483648 ... 2147483647"))
        << number << ": " << error;
  }
  EXPECT_NE("", errorOf(R"({"stamp":1.0,"event":"abandoned","plan_id":-1})"));
  EXPECT_NE("", errorOf(R"({"stamp":1.0,"event":"abandoned","plan_id":4294967296})"));
}

TEST(EventLineTest, CellsAndPartnersAreWholeNumbers) {
  const auto line = [](const std::string& cell, const std::string& partners) {
    return R"({"stamp":1.0,"event":"plan","plan_id":1,"plan":{"replaces_plan_id":0,)"
           R"("planner":"p","planning_s":0.5,"robots":["robot_0"],"goals":[)" +
           cell + R"(],"configurations":[[[0,0]]],"partners":[)" + partners +
           R"(],"svo_deg":[[null]]}})";
  };
  EXPECT_EQ("", errorOf(line("[0,1]", "[-1]")));
  EXPECT_NE("", errorOf(line("[0,1e10]", "[-1]")));
  EXPECT_NE("", errorOf(line("[0,1]", "[1e10]")));
  EXPECT_NE("", errorOf(line("[0,1]", "null")));
}

TEST(EventLineTest, AnErrorIsOneLineWhateverTheWordsAre) {
  const std::string unknown = R"({"stamp":1.0,"plan_id":1,"event":"a\nb"})";
  EXPECT_EQ("unknown event 'a?b'", errorOf(unknown));
  const std::string robot = R"({"stamp":1.0,"plan_id":1,"event":"lost","robot":"a\nb"})";
  EXPECT_EQ("robot 'a?b' is not in the experiment", errorOf(robot));
  const std::string mode = R"({"stamp":1.0,"plan_id":1,"event":"mode","mode":"a\nb"})";
  EXPECT_EQ("unknown mode 'a?b'", errorOf(mode));
}

}  // namespace
}  // namespace sylph
