// Any bytes as a line of the event log; one that is read is read again as it is written.

#include "fuzz/reader_input.hpp"
#include "sylph_core/execution/event_line.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<std::string> kNames = {"robot_0", "robot_1"};
  sylph::fuzz::expectAnswer([&] {
    const sylph::StampedEvent entry = sylph::eventFromLine(sylph::fuzz::toText(data, size), kNames);
    const std::string line = sylph::toLine(entry, kNames);
    if (sylph::toLine(sylph::eventFromLine(line, kNames), kNames) != line) {
      sylph::fuzz::fail("an event is another one when it has been written: " + line);
    }
  });
  return 0;
}
