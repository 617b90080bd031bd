#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sylph_ros {

/// Holds messages back until all that were announced have come, and hands them out in an order that
/// does not depend on when they came: by topic, then as they were published.
///
/// A message that nobody announced, as of a publisher that is not in lock step, is handed out with
/// the step after the one before whose end it came.
class Mailbox {
 public:
  /// What handling a message means.
  using Delivery = std::function<void()>;

  /// Messages of one topic. As long as a subscriber holds it, they are waited for.
  class Box {
   public:
    /// Keeps a message that has come until it is due.
    void push(Delivery delivery) { waiting_.push_back(std::move(delivery)); }

   private:
    friend class Mailbox;
    std::deque<Delivery> waiting_;
    std::size_t due_ = 0;   ///< so many are to be handed out in this step
    std::size_t left_ = 0;  ///< were there at the end of the last step
  };

  /// A box for a topic's messages from now on.
  std::shared_ptr<Box> open(const std::string& topic);

  /// @param total  messages on the topic since its publisher began; less than before: it was
  ///               started again, and what it has published is taken as it comes
  void announce(const std::string& topic, std::uint32_t total);

  /// What was announced so far need not be waited for: it went to who was there before.
  void forgive();

  /// @param has_publisher  whether anybody is connected who publishes a topic
  /// @return whether all announced messages are there, of topics that have a publisher
  bool isComplete(const std::function<bool(const std::string& topic)>& has_publisher) const;

  /// Hands out what is due and what was left over before.
  void deliver();

  /// To be called when the step is over.
  void endStep();

 private:
  std::vector<std::shared_ptr<Box>> boxesOf(const std::string& topic) const;

  std::map<std::string, std::vector<std::weak_ptr<Box>>> boxes_;
  std::map<std::string, std::uint32_t> totals_;
};

}  // namespace sylph_ros
