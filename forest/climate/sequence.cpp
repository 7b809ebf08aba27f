#include "forest/climate/sequence.hpp"

#include <algorithm>
#include <string>

#include "config/errors/input_error.hpp"

namespace forest {

void check(const YearWindow& window, const ClimateSeries& series) {
    if (window.size() < 1 || series.find(window.first) == nullptr || series.find(window.last) == nullptr) {
        config::fail(config::ExitCode::settings, {},
                     "climate years " + std::to_string(window.first) + " to " + std::to_string(window.last),
                     "years of the climate table, " + std::to_string(series.first_year()) + " to " +
                         std::to_string(series.last_year()));
    }
}

YearSequence YearSequence::repeating(const ClimateSeries& series, YearWindow window) {
    return {Kind::repeating, window, {series.first_year(), series.last_year()}, {}};
}

YearSequence YearSequence::drawn(YearWindow window, std::uint64_t seed, std::uint32_t replicate) {
    return {Kind::drawn, window, {1, 0}, {.seed = seed, .replicate = replicate}};
}

int YearSequence::source_of(int simulated_year) const {
    if (kind_ == Kind::drawn) {
        config::StreamKey key = key_;
        key.year = static_cast<std::uint16_t>(simulated_year);
        const double u = config::RandomStream{key, config::Purpose::weather}.uniforms_of(0)[0];
        return window_.first + std::min(static_cast<int>(u * window_.size()), window_.size() - 1);
    }
    if (simulated_year >= own_.first && simulated_year <= own_.last) {
        return simulated_year;
    }
    const int size = window_.size();
    const int steps =
        simulated_year > own_.last ? simulated_year - own_.last - 1 : simulated_year - own_.first;
    return window_.first + ((steps % size) + size) % size;
}

}  // namespace forest
