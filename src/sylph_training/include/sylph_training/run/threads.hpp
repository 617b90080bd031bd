#pragma once

namespace sylph_training {

/// Lets libtorch compute with so many threads, and OpenBLAS, if that is what libtorch multiplies
/// with, too: it does not heed libtorch's number, and its idle threads keep a core busy each.
/// @param count  > 0
void useThreads(int count);

}  // namespace sylph_training
