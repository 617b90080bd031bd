#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sylph_natnet {

/// Writes little-endian fields one after the other.
class ByteWriter {
 public:
  /// One field.
  ///@{
  void writeU8(std::uint8_t value);
  void writeU16(std::uint16_t value);
  void writeI16(std::int16_t value);
  void writeU32(std::uint32_t value);
  void writeI32(std::int32_t value);
  void writeU64(std::uint64_t value);
  void writeFloat(float value);
  void writeDouble(double value);
  ///@}
  /// The text and a NUL.
  void writeString(const std::string& text);
  /// The text in a field of `length` bytes, cut to leave a NUL.
  void writeFixedString(const std::string& text, std::size_t length);
  /// The bytes as they are, without a count.
  void writeBytes(const std::vector<std::uint8_t>& bytes);

  /// All that was written so far.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  void writeUnsigned(std::uint64_t value, std::size_t bytes);

  std::vector<std::uint8_t> bytes_;
};

}  // namespace sylph_natnet
