#include "coupling/results/figures/effect_words.hpp"

#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

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
    return bari < 0.0 ? report::page_text("{share} more rocks (BARI {bari}).",
                                          {{"share", percent_text(-bari)}, {"bari", percent_text(bari)}})
                      : report::page_text("{bari} fewer rocks (BARI).", {{"bari", percent_text(bari)}});
}

std::string intensity_in_words(const TargetFigures& target) {
    const double miri = target.reduction->miri_percent;
    const ArrivalFigures& forest = target.at(Cover::forest);
    const ArrivalFigures& bare = target.at(Cover::bare);
    const std::string rise = rise_in_words(forest, bare);
    if (std::isnan(miri)) {
        return report::join_sentences(
            {report::page_text(
                 "MIRI and ORPI cannot be estimated: the 95 % energy needs 20 rocks on each slope."),
             rise});
    }
    const std::string value = percent_text(miri);
    if (forest.share.part == 0) {
        return report::page_text("No rock gets through (MIRI {miri}).", {{"miri", value}});
    }
    if (miri <= -least_change_percent) {
        return rise_in_words(forest, bare, value);
    }
    return report::join_sentences(
        {report::page_text(
             miri < least_change_percent
                 ? "The 95 % energy of those that still arrive is nearly the same (MIRI {miri})."
                 : "The 95 % energy of those that still arrive is {miri} lower (MIRI {miri}).",
             {{"miri", value}}),
         rise});
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
        return EnergyRise{false, 100.0 * (with.p95 / without.p95 - 1.0),
                          with.p95_interval.low >= without.p95_interval.high, true};
    }
    if (is_a_rise(with.mean, without.mean)) {
        return EnergyRise{true, 100.0 * (with.mean / without.mean - 1.0), false, false};
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
        const std::string from = rate_per_1000(before.value);
        const std::string to = rate_per_1000(after.value);
        const std::string energy_kj = kj_text(energy);
        return from == to
                   ? report::page_text("Rocks above {energy_kj} kJ per 1000 released stay at {to}.",
                                       {{"energy_kj", energy_kj}, {"to", to}})
                   : report::page_text(
                         after.value < before.value
                             ? "Rocks above {energy_kj} kJ per 1000 released fall from {from} to {to}."
                             : "Rocks above {energy_kj} kJ per 1000 released rise from {from} to {to}.",
                         {{"energy_kj", energy_kj}, {"from", from}, {"to", to}});
    }
    return "";
}

std::string rise_in_words(const ArrivalFigures& forest, const ArrivalFigures& bare, const std::string& miri) {
    const auto rise = energy_rise(forest, bare);
    if (!rise) {
        return "";
    }
    const bool is_open = rise->has_interval && !rise->is_certain;  // chance alone may be the cause
    const std::string percent = percent_text(rise->percent);
    const std::string text =
        rise->of_mean ? report::page_text(
                            "The mean energy of those that still arrive is {rise} higher, because the forest "
                            "stops small and slow rocks more often than large and fast ones.",
                            {{"rise", percent}})
        : miri.empty()
            ? report::page_text(is_open
                                    ? "The 95 % energy of those that still arrive is {rise} higher (within "
                                      "the uncertainty of few rocks)."
                                    : "The 95 % energy of those that still arrive is {rise} higher, because "
                                      "the forest stops small and slow rocks more often than large and fast "
                                      "ones.",
                                {{"rise", percent}})
            : report::page_text(
                  is_open
                      ? "The 95 % energy of those that still arrive is {rise} higher (MIRI {miri}), within "
                        "the uncertainty of few rocks."
                      : "The 95 % energy of those that still arrive is {rise} higher (MIRI {miri}), because "
                        "the forest stops small and slow rocks more often than large and fast ones.",
                  {{"rise", percent}, {"miri", miri}});
    return report::join_sentences({text, change_of_strong_rocks(forest, bare)});
}

std::string reduction_in_words(const TargetFigures& target) {
    const RiskReduction& reduction = *target.reduction;
    return report::join_sentences(
        {frequency_in_words(reduction), intensity_in_words(target),
         std::isnan(reduction.orpi_percent)
             ? ""
             : report::page_text("Combined (ORPI): {orpi}.",
                                 {{"orpi", percent_text(reduction.orpi_percent)}})});
}

}  // namespace coupling
