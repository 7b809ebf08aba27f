#pragma once

#include "coupling/assessments/decades/members/kept_member.hpp"
#include "coupling/results/disk/byte_archive.hpp"

namespace coupling::decades {

/// Writes a member after its last year: all fields of its stand and of what its regime remembers. A field
/// that is new in one of these structs does not compile until it is written, too.
void write(ByteWriter& out, const MemberEnd& end);

/// Reads it back, bit for bit. Throws config::InputError (file) if it is cut off.
void read(ByteReader& in, MemberEnd& end);

}  // namespace coupling::decades
