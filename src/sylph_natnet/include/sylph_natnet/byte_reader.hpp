#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace sylph_natnet {

/// A datagram is not what its version says. The text names the field.
class ParseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads little-endian fields one after the other and never beyond the end. A view: the bytes must
/// outlive it. Every read names its field, for the error.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  /// Bytes behind those that were read.
  std::size_t remaining() const { return size_; }

  /// The next field.
  /// @throws ParseError naming it if the bytes end before it does
  ///@{
  std::uint8_t readU8(const char* field);
  std::uint16_t readU16(const char* field);
  std::int16_t readI16(const char* field);
  std::uint32_t readU32(const char* field);
  std::int32_t readI32(const char* field);
  std::uint64_t readU64(const char* field);
  float readFloat(const char* field);
  double readDouble(const char* field);
  ///@}

  /// Up to the next NUL, which is taken too.
  std::string readString(const char* field);
  /// A field of `length` bytes that holds a NUL-terminated text.
  std::string readFixedString(std::size_t length, const char* field);

  /// A count of items of which each takes at least `least_item_bytes`: a number that cannot be true
  /// is an error before anything is allocated.
  std::size_t readCount(std::size_t least_item_bytes, const char* field);

  /// Passes over bytes whose meaning is not needed.
  void skip(std::size_t bytes, const char* field);
  /// Bytes behind the last field belong to another layout.
  void requireEnd(const char* message) const;
  /// The next `bytes` as a reader of its own.
  ByteReader take(std::size_t bytes, const char* field);

 private:
  /// Moves on by `bytes`. @return where they began
  const std::uint8_t* advance(std::size_t bytes, const char* field);
  std::uint64_t readUnsigned(std::size_t bytes, const char* field);

  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace sylph_natnet
