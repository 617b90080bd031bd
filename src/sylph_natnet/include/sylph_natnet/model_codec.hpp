#pragma once

#include "sylph_natnet/byte_reader.hpp"
#include "sylph_natnet/message.hpp"
#include "sylph_natnet/types.hpp"

namespace sylph_natnet {

/// Reads model definitions: rigid bodies and the names of marker sets. Skeletons, force plates,
/// devices, cameras and trained assets are passed: from 4.1 on by the size that they tell, before
/// by their layout. One whose layout is not known ends the reading; `unread` names it.
/// @throws ParseError if the payload ends early or behind the last description, or a count cannot
/// be true
ModelDefinitions parseModelDefinitions(ByteReader payload, const Version& version);

/// The definitions as a server of that version sends them; marker sets and bodies have no markers.
/// @throws std::invalid_argument if they do not fit into a datagram
Datagram makeModelDefinitions(const ModelDefinitions& definitions, const Version& version);

}  // namespace sylph_natnet
