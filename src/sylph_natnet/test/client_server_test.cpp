#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <random>

#include "raw_frame.hpp"
#include "sylph_natnet/client.hpp"
#include "sylph_natnet/frame_codec.hpp"
#include "sylph_natnet/server.hpp"

namespace sylph_natnet {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::chrono::seconds kDeadline{20};

/// A server on the loopback interface that streams one body per name, and a client of it. Both are
/// stepped in turn: no threads.
class ClientServerTest : public testing::Test {
 protected:
  void startServer(ServerOptions options) {
    options.command_port = command_port_;
    options.data_port = options.multicast ? data_port_ : 0;
    server_.reset();
    server_ = std::make_unique<Server>(options);
    command_port_ = server_->commandPort();
    data_port_ = server_->dataPort();
    server_->setDefinitions(definitionsOf({"robot_0", "robot_1"}));
    number_ = 0;
    ticks_ = first_ticks_;
  }

  void startClient(ClientOptions options = {}) {
    options.command_port = command_port_;
    options.data_port = data_port_;
    options.retry_period = milliseconds(20);
    options.silence = milliseconds(200);
    client_ = std::make_unique<Client>(options);
  }

  static ModelDefinitions definitionsOf(const std::vector<std::string>& names) {
    ModelDefinitions definitions;
    for (const std::string& name : names) {
      RigidBodyDefinition body;
      body.name = name;
      body.id = static_cast<std::int32_t>(definitions.rigid_bodies.size()) + 1;
      definitions.rigid_bodies.push_back(body);
    }
    return definitions;
  }

  Frame nextFrame() {
    Frame frame;
    frame.number = ++number_;
    ticks_ += 83'333;
    frame.mid_exposure_ticks = ticks_ - 50'000;
    frame.transmit_ticks = ticks_;
    frame.timestamp_s = static_cast<double>(number_) / 120.0;
    frame.rigid_bodies.resize(2);
    frame.rigid_bodies[0].id = 1;
    frame.rigid_bodies[1].id = 2;
    frame.rigid_bodies[1].position_m = {1.0F, 2.0F, 3.0F};
    return frame;
  }

  /// Server answers and streams, client polls, until `done` or the deadline.
  bool stepUntil(const std::function<bool()>& done) {
    const auto deadline = steady_clock::now() + kDeadline;
    while (steady_clock::now() < deadline) {
      if (server_) {
        server_->serve(ticks_);
        server_->send(nextFrame());
      }
      if (const auto frame = client_->poll(milliseconds(2))) {
        last_frame_ = frame;
      }
      if (done()) {
        return true;
      }
    }
    return false;
  }

  bool stepUntilConnected() {
    return stepUntil(
        [this] { return last_frame_ && client_->definitions().rigid_bodies.size() == 2; });
  }

  std::uint16_t command_port_ = 0;
  std::uint16_t data_port_ = 0;
  std::uint64_t first_ticks_ = 1'000'000'000;
  std::uint64_t ticks_ = 0;
  std::int32_t number_ = 0;
  std::unique_ptr<Server> server_;
  std::unique_ptr<Client> client_;
  std::optional<ReceivedFrame> last_frame_;
};

TEST_F(ClientServerTest, UnicastStreamsEveryVersionAndItsNames) {
  for (const Version version :
       {Version{2, 9}, Version{3, 0}, Version{4, 0}, Version{4, 1}, Version{4, 2}}) {
    SCOPED_TRACE(toString(version));
    ServerOptions options;
    options.version = version;
    last_frame_.reset();
    startServer(options);
    startClient();
    ASSERT_TRUE(stepUntilConnected());
    EXPECT_EQ(version, client_->version());
    EXPECT_EQ("robot_1", client_->definitions().rigid_bodies[1].name);
    ASSERT_EQ(2U, last_frame_->frame.rigid_bodies.size());
    EXPECT_EQ(2.0F, last_frame_->frame.rigid_bodies[1].position_m[1]);
    EXPECT_EQ(0U, client_->statistics().parse_errors);
  }
}

TEST_F(ClientServerTest, MulticastStreamsToTheGroupAndAnswersCommands) {
  ServerOptions options;
  options.multicast = true;
  options.multicast_group = {239, 255, 42, 98};
  startServer(options);
  ClientOptions client_options;
  client_options.multicast = true;
  client_options.multicast_group = options.multicast_group;
  startClient(client_options);
  ASSERT_TRUE(stepUntilConnected());
  EXPECT_TRUE(client_->serverInfo()->is_multicast);
  EXPECT_EQ(0U, server_->clientCount());
}

TEST_F(ClientServerTest, TwoClientsShareAGroup) {
  ServerOptions options;
  options.multicast = true;
  options.multicast_group = {239, 255, 42, 97};
  startServer(options);
  ClientOptions client_options;
  client_options.multicast = true;
  client_options.multicast_group = options.multicast_group;
  startClient(client_options);
  client_options.command_port = command_port_;
  client_options.data_port = data_port_;
  Client other(client_options);
  bool other_has_frames = false;
  EXPECT_TRUE(stepUntil([&] {
    other_has_frames = other_has_frames || other.poll(milliseconds(0)).has_value();
    return other_has_frames && last_frame_.has_value();
  }));
}

TEST_F(ClientServerTest, GoesOnAfterARestartWithAnotherClockAndVersion) {
  first_ticks_ = 900'000'000'000;
  startServer({});
  startClient();
  ASSERT_TRUE(stepUntilConnected());
  ASSERT_TRUE(stepUntil([this] { return client_->clock().has_value(); }));
  const std::uint64_t session = client_->session();

  first_ticks_ = 5'000'000;
  ServerOptions restarted;
  restarted.version = {3, 0};
  restarted.ticks_per_s = 3'300'000;
  startServer(restarted);
  last_frame_.reset();
  EXPECT_TRUE(stepUntil([&] {
    return client_->session() != session && last_frame_ &&
           !client_->definitions().rigid_bodies.empty();
  }));
  EXPECT_EQ((Version{3, 0}), client_->version());
  EXPECT_EQ(3'300'000U, client_->serverInfo()->ticks_per_s);
}

TEST_F(ClientServerTest, AClockThatGoesBackIsAnotherSession) {
  first_ticks_ = 900'000'000'000;
  startServer({});
  startClient();
  ASSERT_TRUE(stepUntilConnected());
  const std::uint64_t session = client_->session();
  ticks_ = 1'000'000;
  EXPECT_TRUE(stepUntil([&] { return client_->session() != session; }));
}

TEST_F(ClientServerTest, ConnectsToAServerThatStartsLater) {
  startServer({});
  server_.reset();
  startClient();
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(client_->poll(milliseconds(5)));
  }
  EXPECT_FALSE(client_->serverInfo());
  EXPECT_FALSE(client_->definitionsKnown());
  startServer({});
  EXPECT_TRUE(stepUntilConnected());
}

TEST_F(ClientServerTest, AsksForNamesAgainWhenAFrameSaysTheyChanged) {
  startServer({});
  startClient();
  ASSERT_TRUE(stepUntilConnected());
  const std::uint64_t revision = client_->definitionsRevision();
  server_->setDefinitions(definitionsOf({"robot_0", "renamed"}));
  Frame frame = nextFrame();
  frame.models_changed = true;
  server_->send(frame);
  EXPECT_TRUE(stepUntil([this] {
    return client_->definitions().rigid_bodies.size() == 2 &&
           client_->definitions().rigid_bodies[1].name == "renamed";
  }));
  EXPECT_EQ(revision + 1, client_->definitionsRevision());
}

TEST_F(ClientServerTest, FindsOutAboutNewNamesWithoutBeingTold) {
  startServer({});
  ClientOptions options;
  options.definitions_period = milliseconds(50);
  startClient(options);
  ASSERT_TRUE(stepUntilConnected());
  server_->setDefinitions(definitionsOf({"a", "b", "c"}));
  EXPECT_TRUE(stepUntil([this] { return client_->definitions().rigid_bodies.size() == 3; }));
}

TEST_F(ClientServerTest, DropsFramesThatWereOvertaken) {
  startServer({});
  startClient();
  ASSERT_TRUE(stepUntilConnected());
  while (client_->poll(milliseconds(0))) {
  }
  const Frame first = nextFrame();
  const Frame second = nextFrame();
  const Frame third = nextFrame();
  for (const Frame& frame : {first, third, second, third}) {
    server_->send(frame);
  }
  const auto received = client_->poll(milliseconds(1000));
  ASSERT_TRUE(received);
  EXPECT_EQ(third, received->frame);
  EXPECT_EQ(2U, client_->statistics().late);
  EXPECT_EQ(1U, client_->statistics().superseded);
  EXPECT_EQ(0U, client_->statistics().lost);
}

TEST_F(ClientServerTest, CountsLostFrames) {
  startServer({});
  startClient();
  ASSERT_TRUE(stepUntilConnected());
  nextFrame();
  nextFrame();
  last_frame_.reset();
  ASSERT_TRUE(stepUntil([this] { return client_->statistics().lost > 0; }));
  EXPECT_EQ(2U, client_->statistics().lost);
}

TEST_F(ClientServerTest, FindsTheServersClockByEchoes) {
  startServer({});
  startClient();
  const auto start = steady_clock::now();
  // Here the ticks run at the rate that the server claims.
  const auto ticksNow = [&start] {
    return static_cast<std::uint64_t>((steady_clock::now() - start).count() / 100) + 7'000'000;
  };
  const auto deadline = steady_clock::now() + kDeadline;
  while (!client_->clock() && steady_clock::now() < deadline) {
    server_->serve(ticksNow());
    client_->poll(milliseconds(2));
  }
  const std::optional<ClockEstimate> clock = client_->clock();
  ASSERT_TRUE(clock);
  const double truth_s = std::chrono::duration<double>(start.time_since_epoch()).count() - 0.7;
  EXPECT_NEAR(truth_s, clock->offset_s, clock->uncertainty_s + 1e-6);
}

TEST_F(ClientServerTest, TheServerForgetsClientsThatKeepSilentAndTheyComeBack) {
  ServerOptions options;
  options.client_timeout = milliseconds(100);
  startServer(options);
  ClientOptions client_options;
  client_options.keep_alive_period = std::chrono::hours(1);
  startClient(client_options);
  ASSERT_TRUE(stepUntilConnected());
  EXPECT_TRUE(stepUntil([this] { return server_->clientCount() == 0; }));
  EXPECT_TRUE(stepUntil([this] { return server_->clientCount() == 1; }));
}

TEST_F(ClientServerTest, KeepAliveKeepsTheStreamUp) {
  ServerOptions options;
  options.client_timeout = milliseconds(150);
  startServer(options);
  ClientOptions client_options;
  client_options.keep_alive_period = milliseconds(20);
  startClient(client_options);
  ASSERT_TRUE(stepUntilConnected());
  const auto later = steady_clock::now() + 3 * options.client_timeout;
  EXPECT_TRUE(stepUntil([&] { return steady_clock::now() > later; }));
  EXPECT_EQ(1U, server_->clientCount());
  EXPECT_EQ(1U, client_->session());
}

TEST_F(ClientServerTest, AClientThatEndsSaysGoodbye) {
  startServer({});
  startClient();
  ASSERT_TRUE(stepUntilConnected());
  client_.reset();
  ASSERT_TRUE(server_->waitForCommand(milliseconds(1000)));
  server_->serve(ticks_);
  EXPECT_EQ(0U, server_->clientCount());
}

TEST_F(ClientServerTest, AWrongBitstreamIsCountedNotTrusted) {
  ServerOptions options;
  options.version = {2, 9};
  startServer(options);
  ClientOptions client_options;
  client_options.bitstream = Version{4, 1};
  startClient(client_options);
  EXPECT_TRUE(stepUntil([this] { return client_->statistics().parse_errors > 3; }));
  EXPECT_FALSE(last_frame_);
  EXPECT_FALSE(client_->statistics().last_error.empty());
}

TEST_F(ClientServerTest, ABitstreamWithoutTheServersLastSectionIsNotTrusted) {
  ServerOptions options;
  options.version = {2, 11};
  startServer(options);
  ClientOptions client_options;
  client_options.bitstream = Version{2, 9};
  startClient(client_options);
  EXPECT_TRUE(stepUntil([this] { return client_->statistics().parse_errors > 3; }));
  EXPECT_FALSE(last_frame_);
  EXPECT_EQ("frame: 4 bytes are left behind its end", client_->statistics().last_error);
}

TEST_F(ClientServerTest, GarbageLeavesTheServerStanding) {
  startServer({});
  UdpSocket socket(Endpoint{{127, 0, 0, 1}, 0});
  std::mt19937 rng(3);
  for (std::size_t size = 0; size < 40; ++size) {
    Datagram datagram(size);
    for (std::uint8_t& byte : datagram) {
      byte = static_cast<std::uint8_t>(rng() % 16);
    }
    socket.sendTo(datagram, {{127, 0, 0, 1}, command_port_});
    server_->waitForCommand(milliseconds(1000));
    EXPECT_EQ(1U, server_->serve(ticks_));
  }
  startClient();
  EXPECT_TRUE(stepUntilConnected());
}

TEST_F(ClientServerTest, AnswersTheFrameRateAndNoOtherRequest) {
  startServer({});
  UdpSocket socket(Endpoint{{127, 0, 0, 1}, 0});
  Datagram answer;
  const auto ask = [&](const std::string& command) {
    socket.sendTo(makeRequest(command), {{127, 0, 0, 1}, command_port_});
    server_->waitForCommand(milliseconds(1000));
    server_->serve(ticks_);
    waitForInput({&socket}, milliseconds(1000));
    socket.receive(answer);
    return openMessage(answer).id;
  };
  ASSERT_EQ(MessageId::Response, ask("FrameRate"));
  EXPECT_EQ(120.0F, openMessage(answer).payload.readFloat("rate"));
  EXPECT_EQ(MessageId::UnrecognizedRequest, ask("Reboot"));
}

TEST(UdpSocketTest, SaysWhichPortIsTaken) {
  const UdpSocket first(Endpoint{{127, 0, 0, 1}, 0});
  try {
    const UdpSocket second(first.localEndpoint());
    FAIL() << "two sockets on one port";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find(toString(first.localEndpoint())));
  }
}

TEST(UdpSocketTest, RefusesToJoinThroughAnAddressOfAnotherComputer) {
  UdpSocket socket(Endpoint{});
  EXPECT_THROW(socket.joinGroup({239, 255, 42, 99}, {192, 0, 2, 1}), std::runtime_error);
}

TEST(UdpSocketTest, ReadsAddresses) {
  EXPECT_EQ((Ipv4Address{192, 168, 1, 10}), addressFromString("192.168.1.10"));
  EXPECT_EQ("192.168.1.10:1510", toString(Endpoint{{192, 168, 1, 10}, 1510}));
  EXPECT_THROW(addressFromString(""), std::invalid_argument);
  EXPECT_THROW(addressFromString("no.such.host.invalid"), std::invalid_argument);
  EXPECT_EQ((Ipv4Address{127, 0, 0, 1}), localAddressTowards({127, 0, 0, 1}));
}

}  // namespace
}  // namespace sylph_natnet
