#pragma once

#include <optional>
#include <string>

namespace coupling::plausible::terrain {

/// What a rule says of heights: an error where they cannot be meant, else a warning that the answer itself
/// may be wrong. The sentences are those of a problem: found, expected, what to do.
struct Finding {
    bool is_error = false;
    std::string found;
    std::string expected;
    std::string advice;
};

}  // namespace coupling::plausible::terrain
