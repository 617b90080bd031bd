#include "sylph_ros/mailbox.hpp"

#include <algorithm>
#include <utility>

namespace sylph_ros {

std::shared_ptr<Mailbox::Box> Mailbox::open(const std::string& topic) {
  auto box = std::make_shared<Box>();
  boxes_[topic].push_back(box);
  return box;
}

std::vector<std::shared_ptr<Mailbox::Box>> Mailbox::boxesOf(const std::string& topic) const {
  std::vector<std::shared_ptr<Box>> open;
  if (const auto found = boxes_.find(topic); found != boxes_.end()) {
    for (const std::weak_ptr<Box>& box : found->second) {
      if (auto held = box.lock()) {
        open.push_back(std::move(held));
      }
    }
  }
  return open;
}

void Mailbox::announce(const std::string& topic, std::uint32_t total) {
  std::uint32_t& known = totals_[topic];
  const std::uint32_t added = total > known ? total - known : 0;
  known = total;
  for (const auto& box : boxesOf(topic)) {
    box->due_ += added;
  }
}

void Mailbox::forgive() {
  for (const auto& [topic, boxes] : boxes_) {
    for (const auto& box : boxesOf(topic)) {
      box->due_ = 0;
    }
  }
}

bool Mailbox::isComplete(const std::function<bool(const std::string&)>& has_publisher) const {
  return std::all_of(boxes_.begin(), boxes_.end(), [&](const auto& entry) {
    const auto open = boxesOf(entry.first);
    return std::all_of(open.begin(), open.end(), [&](const auto& box) {
      return box->waiting_.size() >= box->due_ || !has_publisher(entry.first);
    });
  });
}

void Mailbox::deliver() {
  // Handling a message may open boxes and close them.
  std::vector<std::shared_ptr<Box>> open;
  for (const auto& [topic, boxes] : boxes_) {
    const auto of_topic = boxesOf(topic);
    open.insert(open.end(), of_topic.begin(), of_topic.end());
  }
  for (const auto& box : open) {
    // Not what came beyond: how much that is depends on the machine, and is left for the next step.
    for (std::size_t count = std::max(box->due_, box->left_); count > 0 && !box->waiting_.empty();
         --count) {
      const Delivery delivery = std::move(box->waiting_.front());
      box->waiting_.pop_front();
      delivery();
    }
    box->due_ = 0;
    box->left_ = 0;
  }
}

void Mailbox::endStep() {
  for (auto entry = boxes_.begin(); entry != boxes_.end();) {
    const auto open = boxesOf(entry->first);
    for (const auto& box : open) {
      box->left_ = box->waiting_.size();
    }
    entry = open.empty() ? boxes_.erase(entry) : std::next(entry);
  }
}

}  // namespace sylph_ros
