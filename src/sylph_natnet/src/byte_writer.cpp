#include "sylph_natnet/byte_writer.hpp"

#include <algorithm>
#include <cstring>

namespace sylph_natnet {

void ByteWriter::writeUnsigned(std::uint64_t value, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) {
    bytes_.push_back(static_cast<std::uint8_t>((value >> (8 * i)) & 0xffU));
  }
}

void ByteWriter::writeU8(std::uint8_t value) {
  bytes_.push_back(value);
}

void ByteWriter::writeU16(std::uint16_t value) {
  writeUnsigned(value, 2);
}

void ByteWriter::writeI16(std::int16_t value) {
  writeU16(static_cast<std::uint16_t>(value));
}

void ByteWriter::writeU32(std::uint32_t value) {
  writeUnsigned(value, 4);
}

void ByteWriter::writeI32(std::int32_t value) {
  writeU32(static_cast<std::uint32_t>(value));
}

void ByteWriter::writeU64(std::uint64_t value) {
  writeUnsigned(value, 8);
}

void ByteWriter::writeFloat(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  writeU32(bits);
}

void ByteWriter::writeDouble(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  writeU64(bits);
}

void ByteWriter::writeString(const std::string& text) {
  bytes_.insert(bytes_.end(), text.begin(), text.end());
  bytes_.push_back(0);
}

void ByteWriter::writeFixedString(const std::string& text, std::size_t length) {
  const std::size_t used = std::min(text.size(), length - 1);
  bytes_.insert(bytes_.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(used));
  bytes_.resize(bytes_.size() + length - used, 0);
}

void ByteWriter::writeBytes(const std::vector<std::uint8_t>& bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

}  // namespace sylph_natnet
