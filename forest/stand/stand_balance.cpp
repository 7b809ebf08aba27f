#include "forest/stand/stand_balance.hpp"

#include <numeric>

namespace forest {

std::string_view name_of(Cause cause) {
    constexpr std::array<std::string_view, cause_count> names = {
        "background", "stress", "self_thinning", "wind",     "snow",   "beetle",
        "rock",       "wound",  "felled",        "browsing", "drought"};
    return names[index_of(cause)];
}

std::uint64_t StandBalance::all_stems_in() const {
    return std::accumulate(stems_in.begin(), stems_in.end(), std::uint64_t{0});
}

std::uint64_t StandBalance::all_stems_out() const {
    return std::accumulate(stems_out.begin(), stems_out.end(), std::uint64_t{0});
}

double StandBalance::all_lost_kg() const {
    return std::accumulate(lost_kg.begin(), lost_kg.end(), 0.0);
}

double StandBalance::all_stem_lost_kg() const {
    return std::accumulate(stem_lost_kg.begin(), stem_lost_kg.end(), 0.0);
}

double StandBalance::all_dead_wood_out_kg() const {
    return dead_wood_decayed_kg + dead_wood_to_soil_kg + dead_wood_taken_kg;
}

std::uint64_t StandBalance::all_saplings_out() const {
    return std::accumulate(saplings_out.begin(), saplings_out.end(), std::uint64_t{0});
}

StandBalance& StandBalance::operator+=(const StandBalance& other) {
    for (std::size_t i = 0; i < origin_count; ++i) {
        stems_in[i] += other.stems_in[i];
    }
    for (std::size_t i = 0; i < cause_count; ++i) {
        stems_out[i] += other.stems_out[i];
        lost_kg[i] += other.lost_kg[i];
        stem_lost_kg[i] += other.stem_lost_kg[i];
        saplings_out[i] += other.saplings_out[i];
    }
    mass_in_kg += other.mass_in_kg;
    grown_kg += other.grown_kg;
    shed_kg += other.shed_kg;
    stem_in_kg += other.stem_in_kg;
    stem_grown_kg += other.stem_grown_kg;
    dead_wood_in_kg += other.dead_wood_in_kg;
    dead_wood_decayed_kg += other.dead_wood_decayed_kg;
    dead_wood_to_soil_kg += other.dead_wood_to_soil_kg;
    dead_wood_taken_kg += other.dead_wood_taken_kg;
    saplings_in += other.saplings_in;
    saplings_recruited += other.saplings_recruited;
    return *this;
}

}  // namespace forest
