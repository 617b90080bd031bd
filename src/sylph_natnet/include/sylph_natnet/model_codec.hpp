#pragma once

#include "sylph_natnet/byte_reader.hpp"
#include "sylph_natnet/message.hpp"
#include "sylph_natnet/types.hpp"

namespace sylph_natnet {

/// Reads model definitions: rigid bodies and the names of marker sets. From 4.1 on, where each
/// description tells its size, all others are skipped; before, the first that is not one of the two
/// ends the reading and `complete` is false.
/// @throws ParseError if the payload ends early or a count cannot be true
ModelDefinitions parseModelDefinitions(ByteReader payload, const Version& version);

/// The definitions as a server of that version sends them; marker sets and bodies have no markers.
/// @throws std::invalid_argument if they do not fit into a datagram
Datagram makeModelDefinitions(const ModelDefinitions& definitions, const Version& version);

}  // namespace sylph_natnet
