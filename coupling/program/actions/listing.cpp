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

std::string duration(double seconds) {
    if (seconds < 1.0) {
        return "a second";
    }
    if (seconds < 100.0) {
        return std::to_string(std::lround(seconds)) + " s";
    }
    return seconds < 6000.0 ? std::to_string(std::lround(seconds / 60.0)) + " min"
                            : std::to_string(std::lround(seconds / 3600.0)) + " h";
}

}  // namespace coupling
