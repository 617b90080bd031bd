#include "sylph_natnet/byte_reader.hpp"

#include <algorithm>
#include <cstring>

namespace sylph_natnet {

const std::uint8_t* ByteReader::advance(std::size_t bytes, const char* field) {
  if (bytes > size_) {
    throw ParseError(std::string(field) + ": needs " + std::to_string(bytes) + " bytes, " +
                     std::to_string(size_) + " are left");
  }
  const std::uint8_t* const begin = data_;
  data_ += bytes;
  size_ -= bytes;
  return begin;
}

std::uint64_t ByteReader::readUnsigned(std::size_t bytes, const char* field) {
  const std::uint8_t* const begin = advance(bytes, field);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    value |= static_cast<std::uint64_t>(begin[i]) << (8 * i);
  }
  return value;
}

std::uint8_t ByteReader::readU8(const char* field) {
  return static_cast<std::uint8_t>(readUnsigned(1, field));
}

std::uint16_t ByteReader::readU16(const char* field) {
  return static_cast<std::uint16_t>(readUnsigned(2, field));
}

std::int16_t ByteReader::readI16(const char* field) {
  return static_cast<std::int16_t>(readU16(field));
}

std::uint32_t ByteReader::readU32(const char* field) {
  return static_cast<std::uint32_t>(readUnsigned(4, field));
}

std::int32_t ByteReader::readI32(const char* field) {
  return static_cast<std::int32_t>(readU32(field));
}

std::uint64_t ByteReader::readU64(const char* field) {
  return readUnsigned(8, field);
}

float ByteReader::readFloat(const char* field) {
  const std::uint32_t bits = readU32(field);
  float value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

double ByteReader::readDouble(const char* field) {
  const std::uint64_t bits = readU64(field);
  double value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

std::string ByteReader::readString(const char* field) {
  const std::uint8_t* const end = std::find(data_, data_ + size_, std::uint8_t{0});
  if (end == data_ + size_) {
    throw ParseError(std::string(field) + ": text without an end");
  }
  std::string text(data_, end);
  advance(text.size() + 1, field);
  return text;
}

std::string ByteReader::readFixedString(std::size_t length, const char* field) {
  const std::uint8_t* const begin = advance(length, field);
  return {begin, std::find(begin, begin + length, std::uint8_t{0})};
}

std::size_t ByteReader::readCount(std::size_t least_item_bytes, const char* field) {
  const std::int32_t count = readI32(field);
  if (count < 0 || static_cast<std::uint64_t>(count) * least_item_bytes > size_) {
    throw ParseError(std::string(field) + ": count of " + std::to_string(count) + " in " +
                     std::to_string(size_) + " bytes");
  }
  return static_cast<std::size_t>(count);
}

void ByteReader::skip(std::size_t bytes, const char* field) {
  advance(bytes, field);
}

void ByteReader::requireEnd(const char* message) const {
  if (size_ > 0) {
    throw ParseError(std::string(message) + ": " + std::to_string(size_) +
                     " bytes are left behind its end");
  }
}

ByteReader ByteReader::take(std::size_t bytes, const char* field) {
  return {advance(bytes, field), bytes};
}

}  // namespace sylph_natnet
