#pragma once

#include <string>

#include "tests/fuzz/chance.hpp"

namespace fuzz {

/// Longest result of `mutated` [bytes]: inputs that are large are tested by name (tests/runs).
inline constexpr std::size_t longest_input_bytes = 400'000;

/// The bytes of an input after one to four changes: flipped bits; bytes inserted, deleted, doubled; cut off;
/// lines or fields exchanged, doubled, left out; numbers replaced by nan, inf, 1e308, -1 and the like; a byte
/// or a field repeated many times; other encodings and line ends, bytes of zero.
std::string mutated(const std::string& bytes, Chance& chance);

}  // namespace fuzz
