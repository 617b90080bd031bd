#include "sylph_ros/mailbox.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using sylph_ros::Mailbox;
using Texts = std::vector<std::string>;

class MailboxTest : public testing::Test {
 protected:
  static bool connected(const std::string& topic) { return topic != "/silent"; }

  void push(const std::shared_ptr<Mailbox::Box>& box, const std::string& text) {
    box->push([this, text] { handled_.push_back(text); });
  }
  bool isComplete() const { return mailbox_.isComplete(connected); }
  /// One whole step.
  Texts step() {
    handled_.clear();
    mailbox_.deliver();
    mailbox_.endStep();
    return handled_;
  }

  Mailbox mailbox_;
  Texts handled_;
};

TEST_F(MailboxTest, HandsOutByTopicWhateverCameFirst) {
  const auto b = mailbox_.open("/b");
  const auto a = mailbox_.open("/a");
  push(b, "b1");
  push(b, "b2");
  push(a, "a1");
  mailbox_.announce("/b", 2);
  mailbox_.announce("/a", 1);
  EXPECT_EQ((Texts{"a1", "b1", "b2"}), step());
}

TEST_F(MailboxTest, WaitsForWhatWasAnnounced) {
  const auto box = mailbox_.open("/a");
  EXPECT_TRUE(isComplete());
  mailbox_.announce("/a", 2);
  push(box, "1");
  EXPECT_FALSE(isComplete());
  push(box, "2");
  EXPECT_TRUE(isComplete());
}

TEST_F(MailboxTest, HoldsBackWhatIsAnnouncedWithTheNextStep) {
  const auto box = mailbox_.open("/a");
  mailbox_.announce("/a", 1);
  push(box, "1");
  push(box, "2");  // a fast publisher is a step ahead
  EXPECT_EQ(Texts{"1"}, step());
  mailbox_.announce("/a", 2);
  EXPECT_TRUE(isComplete());
  EXPECT_EQ(Texts{"2"}, step());
}

TEST_F(MailboxTest, HandsOutWhatNobodyAnnouncesWithTheNextStep) {
  const auto box = mailbox_.open("/a");
  push(box, "operator");
  EXPECT_EQ(Texts{}, step());
  EXPECT_EQ(Texts{"operator"}, step());
}

TEST_F(MailboxTest, AMessageThatWasGivenUpDelaysNoOther) {
  const auto box = mailbox_.open("/a");
  mailbox_.announce("/a", 1);
  EXPECT_EQ(Texts{}, step());  // it was waited for long enough
  push(box, "late");
  mailbox_.announce("/a", 2);
  push(box, "2");
  EXPECT_EQ(Texts{"late"}, step());
  EXPECT_EQ(Texts{"2"}, step());
  mailbox_.announce("/a", 3);
  push(box, "3");
  EXPECT_EQ(Texts{"3"}, step());
}

TEST_F(MailboxTest, WaitsForNobodyWhoIsGoneOrBeganAnew) {
  const auto silent = mailbox_.open("/silent");
  mailbox_.announce("/silent", 1);
  EXPECT_TRUE(isComplete());
  const auto box = mailbox_.open("/a");
  mailbox_.announce("/a", 7);
  mailbox_.forgive();
  EXPECT_TRUE(isComplete());
  mailbox_.announce("/a", 1);
  EXPECT_TRUE(isComplete());
  mailbox_.announce("/a", 2);
  EXPECT_FALSE(isComplete());
}

TEST_F(MailboxTest, ForgetsTopicsThatNobodyListensTo) {
  auto box = mailbox_.open("/a");
  mailbox_.announce("/a", 1);
  box.reset();
  EXPECT_TRUE(isComplete());
  EXPECT_EQ(Texts{}, step());
}

}  // namespace
