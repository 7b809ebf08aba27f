#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace coupling {

/// A line of a listing: a name, padded, and what there is to say.
void say(std::ostream& out, const std::string& name, const std::string& text);

/// "12.3 kB", "1.2 MB".
std::string size_in_words(std::uint64_t bytes);

/// "less than a second", "about 30 s", "about 12 min", "about 3 h".
std::string duration(double seconds);

/// The time of a part of the whole, such as {"reading", 2.5}.
struct TimeOfPart {
    const char* name;
    double seconds;
};

/// "reading 1 s, falls 11 s": in the unit of the whole, rounded so that they add up to it; those that are
/// rounded to nothing are left out. Empty where the whole is less than a second.
std::string durations_of(const std::vector<TimeOfPart>& parts);

}  // namespace coupling
