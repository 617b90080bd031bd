#pragma once

#include "sylph_natnet/byte_reader.hpp"
#include "sylph_natnet/message.hpp"
#include "sylph_natnet/types.hpp"

namespace sylph_natnet {

/// Reads a frame of data. Markers, skeletons, assets, force plates and devices are skipped.
/// @param version  of the stream, from the server info
/// @throws ParseError if the payload does not end with the frame (it is of another version then,
/// and what was read of it may be anything), a count cannot be true or the version is older than
/// kOldestVersion
Frame parseFrame(ByteReader payload, const Version& version);

/// The frame as a server of that version sends it: rigid bodies, all other sections empty.
/// @throws std::invalid_argument if the version is older than kOldestVersion or the frame too large
Datagram makeFrame(const Frame& frame, const Version& version);

}  // namespace sylph_natnet
