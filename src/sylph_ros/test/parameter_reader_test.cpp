#include "sylph_ros/parameter_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace sylph_ros {
namespace {

enum class Input { Cameras, Topics };

struct Options {
  double speed_mps = 0.25;
  int count = 3;
  bool loud = false;
  std::string frame = "map";
  Input input = Input::Topics;
  double lag_s = 0.08;
};

Options readOptions(ParameterReader& reader) {
  Options options;
  reader.read("speed_mps", options.speed_mps, sylph::Range::positive(), "ceiling of the speed");
  reader.read("count", options.count, {1.0, 100.0}, "of poses");
  reader.read("loud", options.loud, "whether it hoots");
  reader.read("frame", options.frame, "of the poses");
  reader.readChoice<Input>("input", options.input,
                           {{"cameras", Input::Cameras}, {"topics", Input::Topics}},
                           "where poses come from");
  ParameterReader base = reader.group("base");
  base.read("lag_s", options.lag_s, {0.0, 1.0}, "of the wheels");
  reader.readList("faults", "what goes wrong");
  return options;
}

/// Sets values, reads all and says what was wrong; empty if nothing was.
std::string complaint(const std::function<void(XmlRpc::XmlRpcValue&)>& set) {
  XmlRpc::XmlRpcValue values;
  set(values);
  ParameterReader reader("/lab/node", values);
  try {
    readOptions(reader);
    reader.refuseUnread();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ParameterReaderTest, KeepsDefaultsWhereNothingIsSet) {
  ParameterReader reader;
  const Options options = readOptions(reader);
  reader.refuseUnread();
  EXPECT_EQ(0.25, options.speed_mps);
  EXPECT_EQ(3, options.count);
  EXPECT_FALSE(options.loud);
  EXPECT_EQ("map", options.frame);
  EXPECT_EQ(Input::Topics, options.input);
  EXPECT_EQ(0.08, options.lag_s);
}

TEST(ParameterReaderTest, TakesWhatIsSet) {
  XmlRpc::XmlRpcValue values;
  values["speed_mps"] = 1;  // whole numbers are numbers
  values["count"] = 5;
  values["loud"] = true;
  values["frame"] = "lab";
  values["input"] = "cameras";
  values["base"]["lag_s"] = 0.5;
  ParameterReader reader("/lab/node", values);
  const Options options = readOptions(reader);
  reader.refuseUnread();
  EXPECT_EQ(1.0, options.speed_mps);
  EXPECT_EQ(5, options.count);
  EXPECT_TRUE(options.loud);
  EXPECT_EQ("lab", options.frame);
  EXPECT_EQ(Input::Cameras, options.input);
  EXPECT_EQ(0.5, options.lag_s);
}

TEST(ParameterReaderTest, TakesANumberForTheTextThatItLooksLike) {
  const auto frameOf = [](const XmlRpc::XmlRpcValue& value) {
    XmlRpc::XmlRpcValue values;
    values["frame"] = value;
    ParameterReader reader("/lab/node", values);
    return readOptions(reader).frame;
  };
  EXPECT_EQ("7", frameOf(7));
  EXPECT_EQ("3.0", frameOf(3.0));
  EXPECT_EQ("2.11", frameOf(2.11));
  EXPECT_EQ("-0.5", frameOf(-0.5));
}

TEST(ParameterReaderTest, RefusesWhatIsOutOfBoundsByName) {
  EXPECT_EQ("parameter /lab/node/speed_mps = 0: must be > 0",
            complaint([](auto& values) { values["speed_mps"] = 0.0; }));
  EXPECT_EQ("parameter /lab/node/speed_mps = nan: must be > 0",
            complaint([](auto& values) { values["speed_mps"] = std::nan(""); }));
  EXPECT_EQ("parameter /lab/node/count = 101: must be 1 ... 100",
            complaint([](auto& values) { values["count"] = 101; }));
  EXPECT_EQ("parameter /lab/node/base/lag_s = -0.1: must be 0 ... 1",
            complaint([](auto& values) { values["base"]["lag_s"] = -0.1; }));
  EXPECT_EQ("parameter /lab/node/input = \"radar\": must be one of cameras, topics",
            complaint([](auto& values) { values["input"] = "radar"; }));
}

TEST(ParameterReaderTest, RefusesAWrongTypeByName) {
  EXPECT_EQ("parameter /lab/node/speed_mps = \"fast\": must be a number",
            complaint([](auto& values) { values["speed_mps"] = "fast"; }));
  EXPECT_EQ("parameter /lab/node/count = 2.5: must be a whole number",
            complaint([](auto& values) { values["count"] = 2.5; }));
  EXPECT_EQ("parameter /lab/node/loud = 1: must be true or false",
            complaint([](auto& values) { values["loud"] = 1; }));
  EXPECT_EQ("parameter /lab/node/frame = true: must be a text",
            complaint([](auto& values) { values["frame"] = true; }));
  EXPECT_EQ("parameter /lab/node/base = 0.1: must be a group of parameters",
            complaint([](auto& values) { values["base"] = 0.1; }));
  EXPECT_EQ("parameter /lab/node/faults = \"many\": must be a list",
            complaint([](auto& values) { values["faults"] = "many"; }));
}

TEST(ParameterReaderTest, RefusesWhatNobodyAskedFor) {
  EXPECT_EQ(
      "parameter /lab/node/sped_mps: unknown; allowed are speed_mps, count, loud, frame, input, "
      "base, faults",
      complaint([](auto& values) { values["sped_mps"] = 1.0; }));
  EXPECT_EQ("parameter /lab/node/base/lags: unknown; allowed are lag_s",
            complaint([](auto& values) { values["base"]["lags"] = 1.0; }));
  EXPECT_NE("", complaint([](auto& values) { values["lag_s"] = 0.1; }));  // not in its group
}

TEST(ParameterReaderTest, TellsWhatItWasAskedFor) {
  ParameterReader reader;
  readOptions(reader);
  EXPECT_EQ(
      "| `speed_mps` | 0.25 | > 0 | ceiling of the speed |\n"
      "| `count` | 3 | 1 ... 100 | of poses |\n"
      "| `loud` | false | true, false | whether it hoots |\n"
      "| `frame` | \"map\" |  | of the poses |\n"
      "| `input` | \"topics\" | cameras, topics | where poses come from |\n"
      "| `base/lag_s` | 0.08 | 0 ... 1 | of the wheels |\n"
      "| `faults` | [] | a list | what goes wrong |\n",
      reader.table());
}

}  // namespace
}  // namespace sylph_ros
