#pragma once

#include <string>

#include "coupling/assessments/nets/siting/siting.hpp"

namespace coupling::siting {

/// Rocks and energy that come to all pieces of a line.
struct LineSums {
    std::uint64_t rocks = 0;
    double energy_kj = 0.0;
};
LineSums sums_of(const std::vector<LineBin>& bins);

/// "road: nets are needed on 120 m of 840 m, in 2 stretches that receive ...". Text, not markup.
std::string line_in_words(const SitingResults& results, std::size_t line);

/// "230-310 m: class 3 (1 000 kJ), 2.5 m high, 85 m long, 20 m upslope keeps ...; as good: 30, 40 m upslope".
std::string stretch_in_words(const SitingResults& results, const StretchResult& stretch);

/// "class 3 (1 000 kJ), 2.5 m high, 85 m long".
std::string net_in_words(const NetDesign& net);

/// Distances of the candidates that tie with the best: "30, 40"; "" where none does.
std::string ties_of(const SitingResults& results, const StretchResult& stretch);

}  // namespace coupling::siting
