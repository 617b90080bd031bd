#include "sylph_natnet/message.hpp"

#include <gtest/gtest.h>

namespace sylph_natnet {
namespace {

ServerInfo exampleInfo(const Version& version) {
  ServerInfo info;
  info.name = "Motive";
  info.app_version = {3, 1, 0, 4};
  info.version = version;
  if (version >= Version{3, 0}) {
    info.ticks_per_s = 10'000'000;
    info.data_port = 1511;
    info.is_multicast = false;
    info.multicast_group = {239, 255, 42, 99};
  }
  return info;
}

TEST(MessageTest, ServerInfoHasTheSizesOfTheProtocol) {
  EXPECT_EQ(4U + 264U, makeServerInfo(exampleInfo({2, 9})).size());
  EXPECT_EQ(4U + 279U, makeServerInfo(exampleInfo({3, 0})).size());
}

TEST(MessageTest, ServerInfoIsReadAsWritten) {
  for (const Version version : {Version{2, 9}, Version{3, 0}, Version{4, 2}}) {
    const Datagram datagram = makeServerInfo(exampleInfo(version));
    EXPECT_EQ(MessageId::ServerInfo, openMessage(datagram).id);
    EXPECT_EQ(exampleInfo(version), parseServerInfo(openMessage(datagram).payload));
    for (std::size_t size = 0; size < datagram.size(); ++size) {
      EXPECT_THROW(parseServerInfo(openMessage(datagram.data(), size).payload), ParseError);
    }
  }
}

TEST(MessageTest, NamesAreCutToTheirField) {
  ServerInfo info = exampleInfo({3, 0});
  info.name = std::string(400, 'x');
  const Datagram datagram = makeServerInfo(info);
  EXPECT_EQ(std::string(255, 'x'), parseServerInfo(openMessage(datagram).payload).name);
}

TEST(MessageTest, EchoHasTheSizesOfTheProtocolAndComesBack) {
  const Datagram request = makeEchoRequest(0x1122334455667788U);
  EXPECT_EQ(12U, request.size());
  EXPECT_EQ(0x1122334455667788U, parseEchoRequest(openMessage(request).payload));
  const Datagram response = makeEchoResponse({17, 99});
  EXPECT_EQ(20U, response.size());
  EXPECT_EQ(17U, parseEchoResponse(openMessage(response).payload).client_stamp);
  EXPECT_EQ(99U, parseEchoResponse(openMessage(response).payload).server_ticks);
}

TEST(MessageTest, ConnectCarriesNameAndVersion) {
  const Datagram connect = makeConnect("sylph", {4, 1});
  EXPECT_EQ(4U + 264U, connect.size());
  EXPECT_EQ('s', connect[4]);
  EXPECT_EQ(4, connect[4 + 260]);
  EXPECT_EQ(1, connect[4 + 261]);
}

TEST(MessageTest, RequestsAreWrittenAsTheProtocolSays) {
  EXPECT_EQ((Datagram{4, 0, 0, 0}), makeModelDefinitionsRequest(false));
  EXPECT_EQ((Datagram{4, 0, 4, 0, 3, 0, 0, 0}), makeModelDefinitionsRequest(true));
  EXPECT_EQ((Datagram{2, 0, 3, 0, 'h', 'i', 0}), makeRequest("hi"));
  EXPECT_EQ((Datagram{10, 0, 0, 0}), makeMessage(MessageId::KeepAlive));
}

TEST(MessageTest, ADatagramWithoutAHeaderIsRefused) {
  for (std::size_t size = 0; size < 4; ++size) {
    EXPECT_THROW(openMessage(Datagram(size, 0)), ParseError) << size;
  }
}

TEST(MessageTest, TheLengthInTheHeaderIsNotTrusted) {
  Datagram response = makeEchoResponse({17, 99});
  response[2] = 0xff;
  response[3] = 0xff;
  EXPECT_EQ(99U, parseEchoResponse(openMessage(response).payload).server_ticks);
}

TEST(MessageTest, APayloadBeyondADatagramIsRefused) {
  EXPECT_THROW(makeMessage(MessageId::Text, std::vector<std::uint8_t>(70'000)),
               std::invalid_argument);
}

TEST(VersionTest, IsComparedAsAPair) {
  EXPECT_LT((Version{2, 9}), (Version{3, 0}));
  EXPECT_LT((Version{2, 9}), (Version{2, 11}));
  EXPECT_GE((Version{4, 1}), (Version{4, 1}));
  EXPECT_FALSE((Version{3, 0}) < (Version{2, 9}));
}

TEST(VersionTest, IsReadFromText) {
  EXPECT_EQ((Version{2, 11}), versionFromString("2.11"));
  EXPECT_EQ("4.1", toString(versionFromString("4.1")));
  for (const char* text : {"", "4", "4.", "4.1.0", "x.1", "-4.1", "1.9", "4.1 "}) {
    EXPECT_THROW(versionFromString(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace sylph_natnet
