#include "sylph_mocap_bridge/preflight.hpp"

#include <gtest/gtest.h>

namespace sylph_mocap_bridge {
namespace {

/// Everything as it should be.
LinkStatus goodStatus() {
  LinkStatus status;
  status.client.server = {192, 168, 1, 10};
  status.local_address = sylph_natnet::Ipv4Address{192, 168, 1, 20};
  sylph_natnet::ServerInfo server;
  server.version = {4, 1};
  server.data_port = 1511;
  server.is_multicast = false;
  server.multicast_group = {239, 255, 42, 99};
  status.server = server;
  status.version = server.version;
  status.new_frames = 120;
  status.bodies_in_frame = 8;
  status.definitions_known = true;
  status.offered = {"red", "blue"};
  return status;
}

void expectError(const LinkStatus& status, const std::string& part) {
  const Finding finding = preflight(status);
  EXPECT_EQ(Severity::Error, finding.severity) << finding.text;
  EXPECT_NE(std::string::npos, finding.text.find(part)) << finding.text;
  EXPECT_EQ(std::string::npos, finding.text.find('\n'));
}

LinkStatus withoutServer() {
  LinkStatus status = goodStatus();
  status.server.reset();
  status.version.reset();
  status.new_frames = 0;
  return status;
}

TEST(PreflightTest, FindsNothingWhereAllIsWell) {
  EXPECT_EQ(Severity::Ok, preflight(goodStatus()).severity);
}

TEST(PreflightTest, NoRouteToTheServer) {
  LinkStatus status = withoutServer();
  status.local_address.reset();
  expectError(status, "no network leads to the server 192.168.1.10:1510");
}

TEST(PreflightTest, AServerThatDoesNotAnswer) {
  expectError(withoutServer(), "no answer from 192.168.1.10:1510 (asked from 192.168.1.20)");
}

TEST(PreflightTest, AServerThatStreamsButDoesNotAnswer) {
  LinkStatus status = withoutServer();
  status.new_frames = 120;
  expectError(status, "check command_port");
}

TEST(PreflightTest, AServerUnderAnotherAddress) {
  LinkStatus status = withoutServer();
  status.new_foreign = 120;
  status.statistics.last_foreign = {192, 168, 1, 11};
  expectError(status, "data come from 192.168.1.11");
}

TEST(PreflightTest, StreamingSwitchedOff) {
  LinkStatus status = goodStatus();
  status.new_frames = 0;
  expectError(status, "sends no frames: is streaming on");
}

TEST(PreflightTest, TheWrongModeIsNamed) {
  LinkStatus status = goodStatus();
  status.new_frames = 0;
  status.server->is_multicast = true;
  expectError(status, "set transport to multicast here");
  status.server->is_multicast = false;
  status.client.multicast = true;
  expectError(status, "set transport to unicast here");
}

TEST(PreflightTest, TheWrongGroupIsNamed) {
  LinkStatus status = goodStatus();
  status.new_frames = 0;
  status.client.multicast = true;
  status.server->is_multicast = true;
  status.server->multicast_group = {224, 0, 0, 1};
  status.server->data_port = 9000;
  expectError(status, "the server streams to 224.0.0.1:9000");
}

TEST(PreflightTest, MulticastThatIsLostOnTheWay) {
  LinkStatus status = goodStatus();
  status.new_frames = 0;
  status.client.multicast = true;
  status.server->is_multicast = true;
  expectError(status, "set local_interface");
}

TEST(PreflightTest, AnotherBitstream) {
  LinkStatus status = goodStatus();
  status.new_parse_errors = 5;
  status.statistics.last_error = "rigid bodies: count of 8 in 3 bytes";
  expectError(status,
              "data are not what bitstream 4.1 says (rigid bodies: count of 8 in 3 bytes): set "
              "bitstream to the version that the server streams");
  status.client.bitstream = status.version = sylph_natnet::Version{2, 9};
  status.server->version = {2, 11};
  expectError(status, "the server says that it streams 2.11: leave bitstream empty");
  status.client.bitstream.reset();
  status.version = status.server->version = {5, 0};
  expectError(status, "newer than all known here; set bitstream to \"4.4\"");
}

TEST(PreflightTest, NamesThatTheServerDoesNotTell) {
  LinkStatus status = goodStatus();
  status.definitions_known = false;
  status.missing = {"red", "blue"};
  status.offered.clear();
  expectError(status, "192.168.1.10:1510 does not tell which rigid bodies they hold");
}

TEST(PreflightTest, NamesBehindADescriptionOfUnknownLength) {
  LinkStatus status = goodStatus();
  status.unread = "skeleton 'person'";
  EXPECT_EQ(Severity::Ok, preflight(status).severity);  // all robots are described before it
  status.missing = {"green"};
  status.offered = {"red"};
  expectError(status, "no rigid body called green is described before the skeleton 'person'");
  status.offered.clear();
  expectError(status, "remove it from the server's assets");
}

TEST(PreflightTest, NamesThatTheServerDoesNotHave) {
  LinkStatus status = goodStatus();
  status.missing = {"green"};
  expectError(status, "no rigid body is called green; the server has: red, blue");
}

TEST(PreflightTest, NoRigidBodyAtAll) {
  LinkStatus status = goodStatus();
  status.missing = {"green"};
  status.offered.clear();
  expectError(status, "no rigid body is defined");
}

TEST(PreflightTest, ANameThatAppearsTwice) {
  LinkStatus status = goodStatus();
  status.ambiguous = {"red"};
  expectError(status, "more than one rigid body is called red");
}

TEST(PreflightTest, RigidBodiesThatAreNotStreamed) {
  LinkStatus status = goodStatus();
  status.bodies_in_frame = 0;
  expectError(status, "switch on the streaming of rigid bodies");
}

TEST(PreflightTest, ASecondServerIsWorthAWarning) {
  LinkStatus status = goodStatus();
  status.new_foreign = 3;
  status.statistics.last_foreign = {192, 168, 1, 11};
  EXPECT_EQ(Severity::Warning, preflight(status).severity);
}

TEST(TopicsFindingTest, NamesAllThatLackAndTheNearestThatThereAre) {
  EXPECT_EQ(Severity::Ok, topicsFinding({}, {}, {}).severity);
  const Finding finding = topicsFinding(
      {"/vrpn_client_node/RigidBody1/pose", "/vrpn_client_node/RigidBody2/pose"},
      {"/vrpn_client_node/RigidBody3/pose"},
      {"/lamp/pose", "/vrpn_client_node/rigid_body_2/pose", "/vrpn_client_node/RigidBody11/pose"});
  EXPECT_EQ(Severity::Error, finding.severity);
  EXPECT_EQ(
      "nobody publishes /vrpn_client_node/RigidBody1/pose, /vrpn_client_node/RigidBody2/pose: are "
      "pose_topic and the rigid bodies' names right? There is /vrpn_client_node/RigidBody11/pose, "
      "/vrpn_client_node/rigid_body_2/pose; nothing comes on /vrpn_client_node/RigidBody3/pose: "
      "does the driver see these bodies?",
      finding.text);
}

TEST(TopicsFindingTest, SaysWhenThereIsNoDriverAtAll) {
  const Finding finding = topicsFinding({"/a/pose"}, {}, {});
  EXPECT_EQ("nobody publishes /a/pose: there is no topic of poses at all, is the driver running?",
            finding.text);
}

TEST(AnnouncerTest, SaysWhatIsNewAndRepeatsWhatStaysWrong) {
  const Finding wrong{Severity::Error, "no answer"};
  const Finding good{Severity::Ok, "frames come"};
  Announcer announcer;
  EXPECT_TRUE(announcer.isDue(wrong, 100.0));
  EXPECT_FALSE(announcer.isDue(wrong, 101.0));
  EXPECT_FALSE(announcer.isDue(wrong, 100.0 + 0.99 * Announcer::kRepeatS));
  EXPECT_TRUE(announcer.isDue(wrong, 100.0 + Announcer::kRepeatS));
  EXPECT_TRUE(announcer.isDue(good, 131.0));
  EXPECT_FALSE(announcer.isDue(good, 1000.0));
  EXPECT_TRUE(announcer.isDue(wrong, 1001.0));
}

TEST(AnnouncerTest, MakesNoFloodOfFindingsThatChangeAllTheTime) {
  Announcer announcer;
  int said = 0;
  for (int second = 0; second < 60; ++second) {
    said += announcer.isDue({Severity::Error, std::to_string(second)}, second) ? 1 : 0;
  }
  EXPECT_EQ(12, said);
}

}  // namespace
}  // namespace sylph_mocap_bridge
