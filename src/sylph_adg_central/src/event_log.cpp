#include "sylph_adg_central/event_log.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace sylph_adg_central {
namespace {

std::string readAll(const std::string& path) {
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return file ? content.str() : std::string();
}

[[noreturn]] void failToWrite(const std::string& path, int reason) {
  throw std::runtime_error(path + ": cannot be written: " + std::strerror(reason));
}

}  // namespace

EventLog::EventLog(std::string path, std::vector<std::string> names)
    : path_(std::move(path)), names_(std::move(names)) {
  const std::string content = readAll(path_);
  const std::size_t complete =
      content.rfind('\n') == std::string::npos ? 0 : content.rfind('\n') + 1;
  std::istringstream lines(content.substr(0, complete));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    try {
      past_.push_back(sylph::eventFromLine(line, names_));
    } catch (const std::exception& error) {
      throw std::runtime_error(path_ + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  if (complete < content.size()) {
    std::filesystem::resize_file(path_, complete);
  }
  file_.open(path_, std::ios::app | std::ios::binary);
  if (!file_) {
    failToWrite(path_, errno);
  }
}

void EventLog::append(const sylph::StampedEvent& event) {
  // A file that has been removed takes lines as before, and nobody will ever read them.
  if (!std::filesystem::exists(path_)) {
    failToWrite(path_, ENOENT);
  }
  errno = 0;
  file_ << sylph::toLine(event, names_) << '\n' << std::flush;
  if (!file_) {
    failToWrite(path_, errno);
  }
}

}  // namespace sylph_adg_central
