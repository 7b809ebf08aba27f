#include "coupling/program/actions/listing.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace coupling {

void say(std::ostream& out, const std::string& name, const std::string& text) {
    out << std::left << std::setw(13) << name << ' ' << text << '\n';
}

std::string size_in_words(std::uint64_t bytes) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1);
    if (bytes < 100'000) {
        text << static_cast<double>(bytes) / 1e3 << " kB";
    } else {
        text << static_cast<double>(bytes) / 1e6 << " MB";
    }
    return text.str();
}

namespace {

struct TimeUnit {
    double seconds;
    const char* name;
};

TimeUnit unit_for(double seconds) {
    return seconds < 100.0    ? TimeUnit{1.0, " s"}
           : seconds < 6000.0 ? TimeUnit{60.0, " min"}
                              : TimeUnit{3600.0, " h"};
}

}  // namespace

std::string duration(double seconds) {
    if (seconds < 1.0) {
        return "less than a second";
    }
    const TimeUnit unit = unit_for(seconds);
    return "about " + std::to_string(std::lround(seconds / unit.seconds)) + unit.name;
}

std::string durations_of(const std::vector<TimeOfPart>& parts) {
    double whole_s = 0.0;
    for (const TimeOfPart& part : parts) {
        whole_s += part.seconds;
    }
    std::string text;
    if (whole_s < 1.0) {
        return text;
    }
    // The sums up to each part are rounded: their differences add up to the whole, rounded.
    const TimeUnit unit = unit_for(whole_s);
    double until_s = 0.0;
    long said = 0;
    for (const TimeOfPart& part : parts) {
        until_s += part.seconds;
        const long until = std::lround(until_s / unit.seconds);
        if (until > said) {
            text += (text.empty() ? "" : ", ") + std::string{part.name} + ' ' + std::to_string(until - said) +
                    unit.name;
        }
        said = until;
    }
    return text;
}

}  // namespace coupling
