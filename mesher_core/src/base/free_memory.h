// What the allocator keeps of memory that was freed.
#pragma once

namespace advlayers {

// Gives it back to the system, where the allocator can (glibc). A stage of a large mesh frees half
// a kilobyte per element beneath blocks that live on, and the next stage would grow on top of that.
void release_free_memory();

}  // namespace advlayers
