#include "coupling/results/effect_words.hpp"

#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/few_rocks.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling {
namespace {

using config::joined;

/// Smaller changes are none in words [choice].
constexpr double least_change_percent = 0.5;

std::string percent_text(double value) {
    return joined(report::fixed(value, 1), "\u00a0%");
}

bool is_a_rise(double forest, double bare) {
    return bare > 0.0 && 100.0 * (forest / bare - 1.0) >= least_change_percent;  // false for NaN
}

std::string frequency_in_words(const RiskReduction& reduction) {
    const double bari = reduction.bari_percent;
    return bari < 0.0 ? joined(percent_text(-bari), " more rocks (BARI ", percent_text(bari), ").")
                      : joined(percent_text(bari), " fewer rocks (BARI).");
}

std::string intensity_in_words(const TargetFigures& target) {
    const double miri = target.reduction->miri_percent;
    const ArrivalFigures& forest = target.at(Cover::forest);
    const ArrivalFigures& bare = target.at(Cover::bare);
    if (std::isnan(miri)) {
        const std::string rise = rise_in_words(forest, bare);
        return joined(
            " MIRI and ORPI cannot be estimated: the 95\u00a0% energy needs 20 rocks on each slope.",
            rise.empty() ? "" : " ", rise);
    }
    const std::string index = joined(" (MIRI ", percent_text(miri), ")");
    const std::string subject = " The 95\u00a0% energy of those that still arrive is ";
    if (forest.share.part == 0) {
        return joined(" No rock gets through", index, ".");
    }
    if (miri <= -least_change_percent) {
        return joined(" ", rise_in_words(forest, bare, index));
    }
    std::string text = miri < least_change_percent
                           ? joined(subject, "nearly the same", index, ".")
                           : joined(subject, percent_text(miri), " lower", index, ".");
    const std::string rise = rise_in_words(forest, bare);
    return rise.empty() ? text : joined(text, " ", rise);
}

}  // namespace

std::string kj_text(std::size_t counted_energy) {
    return std::to_string(
        std::lround(static_cast<double>(rockfall::counted_energies_j[counted_energy]) / config::j_per_kj));
}

std::string rate_per_1000(double share) {
    const double rate = 1000.0 * share;
    if (!(rate > 0.0)) {
        return rate == 0.0 ? "0" : "–";
    }
    const int decimals = rate >= 99.95   ? 0
                         : rate >= 0.995 ? 1
                                         : 1 - static_cast<int>(std::floor(std::log10(rate)));
    return report::fixed(rate, std::min(decimals, 9));
}

std::optional<EnergyRise> energy_rise(const ArrivalFigures& forest, const ArrivalFigures& bare) {
    if (too_few_for_protection(forest.share.part) || too_few_for_protection(bare.share.part)) {
        return std::nullopt;
    }
    const Distribution& with = forest.energy_kj;
    const Distribution& without = bare.energy_kj;
    if (is_a_rise(with.p95, without.p95)) {
        return EnergyRise{"95\u00a0% energy", 100.0 * (with.p95 / without.p95 - 1.0),
                          with.p95_interval.low >= without.p95_interval.high};
    }
    if (is_a_rise(with.mean, without.mean)) {
        return EnergyRise{"mean energy", 100.0 * (with.mean / without.mean - 1.0), false};
    }
    return std::nullopt;
}

std::string change_of_strong_rocks(const ArrivalFigures& forest, const ArrivalFigures& bare) {
    constexpr std::array<std::size_t, 3> preferred{2, 1, 0};  // 300, 100, 30 kJ
    for (const std::size_t energy : preferred) {
        const Share& before = bare.above[energy];
        const Share& after = forest.above[energy];
        if (too_few_for_protection(before.part)) {
            continue;
        }
        const std::string which = joined("rocks above ", kj_text(energy), "\u00a0kJ per 1000 released ");
        const std::string from = rate_per_1000(before.value);
        const std::string to = rate_per_1000(after.value);
        return from == to                   ? joined(which, "stay at ", to)
               : after.value < before.value ? joined(which, "fall from ", from, " to ", to)
                                            : joined(which, "rise from ", from, " to ", to);
    }
    return "";
}

std::string rise_in_words(const ArrivalFigures& forest, const ArrivalFigures& bare, const std::string& note) {
    const auto rise = energy_rise(forest, bare);
    if (!rise) {
        return "";
    }
    const bool has_interval = std::string_view{rise->figure}.starts_with("95");
    const std::string change = change_of_strong_rocks(forest, bare);
    return joined("The ", rise->figure, " of those that still arrive is ", percent_text(rise->percent),
                  " higher", note,
                  has_interval && !rise->is_certain ? " (within the uncertainty of few rocks)" : "",
                  ", because the forest stops small and slow rocks more often than large and fast ones",
                  change.empty() ? "" : joined("; ", change), ".");
}

std::string reduction_in_words(const TargetFigures& target) {
    const RiskReduction& reduction = *target.reduction;
    const std::string text = joined(frequency_in_words(reduction), intensity_in_words(target));
    return std::isnan(reduction.orpi_percent)
               ? text
               : joined(text, " Combined (ORPI): ", percent_text(reduction.orpi_percent), ".");
}

}  // namespace coupling
