#include "coupling/assessments/nets/siting/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace coupling::siting {
namespace {

constexpr double tied_by = 1.1;  // a tenth more [choice]

bool is_on_offer(const Judged& candidate) {
    return candidate.net->sold_height_m.has_value();
}

bool is_in_play(const Judged& candidate) {
    return candidate.net.has_value() && candidate.left.kept.part > 0;
}

}  // namespace

bool keeps_wanted(const Judged& candidate, double wanted_share) {
    const auto whole = static_cast<double>(candidate.left.kept.whole);
    return static_cast<double>(candidate.left.kept.part) >= std::ceil(wanted_share * whole - 1e-9);
}

Ranking rank(std::span<const Judged> candidates, double wanted_share) {
    const auto key = [&](const Judged& c) {
        const bool keeps = keeps_wanted(c, wanted_share);
        return std::tuple{!keeps,           keeps ? 0.0 : c.left.energy_kj,
                          !is_on_offer(c),  c.net->capacity_kj,
                          c.net->area_m2(), c.distance_m};
    };
    Ranking ranking{std::nullopt, std::vector<bool>(candidates.size(), false)};
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (is_in_play(candidates[i]) &&
            (!ranking.best || key(candidates[i]) < key(candidates[*ranking.best]))) {
            ranking.best = i;
        }
    }
    if (!ranking.best) {
        return ranking;
    }
    const Judged& best = candidates[*ranking.best];
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Judged& other = candidates[i];
        if (i == *ranking.best || !is_in_play(other) ||
            keeps_wanted(other, wanted_share) != keeps_wanted(best, wanted_share)) {
            continue;
        }
        ranking.ties[i] = keeps_wanted(best, wanted_share)
                              ? is_on_offer(other) == is_on_offer(best) &&
                                    other.net->energy_class == best.net->energy_class &&
                                    other.net->area_m2() <= tied_by * best.net->area_m2()
                              : other.left.energy_kj <= tied_by * best.left.energy_kj;
    }
    return ranking;
}

}  // namespace coupling::siting
