#include "coupling/results/figures/effect_words.hpp"

#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/figures/few_rocks.hpp"
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
    return bari < 0.0 ? report::page_text("{percent_text_bari} more rocks (BARI {percent_text_bari_2}).",
                                          {{"percent_text_bari", percent_text(-bari)},
                                           {"percent_text_bari_2", percent_text(bari)}})
                      : report::page_text("{percent_text_bari} fewer rocks (BARI).",
                                          {{"percent_text_bari", percent_text(bari)}});
}

std::string intensity_in_words(const TargetFigures& target) {
    const double miri = target.reduction->miri_percent;
    const ArrivalFigures& forest = target.at(Cover::forest);
    const ArrivalFigures& bare = target.at(Cover::bare);
    if (std::isnan(miri)) {
        const std::string rise = rise_in_words(forest, bare);
        return report::page_text(
            " MIRI and ORPI cannot be estimated: the 95 % energy needs 20 rocks on each slope.{part}{rise}",
            {{"part", rise.empty() ? "" : " "}, {"rise", rise}});
    }
    const std::string index =
        report::page_text(" (MIRI {percent_text_miri})", {{"percent_text_miri", percent_text(miri)}});
    const std::string subject = report::page_text(" The 95 % energy of those that still arrive is ");
    if (forest.share.part == 0) {
        return report::page_text(" No rock gets through{index}.", {{"index", index}});
    }
    if (miri <= -least_change_percent) {
        return joined(" ", rise_in_words(forest, bare, index));
    }
    std::string text =
        miri < least_change_percent
            ? report::page_text("{subject}nearly the same{index}.", {{"subject", subject}, {"index", index}})
            : report::page_text(
                  "{subject}{percent_text_miri} lower{index}.",
                  {{"subject", subject}, {"percent_text_miri", percent_text(miri)}, {"index", index}});
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
        return EnergyRise{report::page_text("95 % energy"), 100.0 * (with.p95 / without.p95 - 1.0),
                          with.p95_interval.low >= without.p95_interval.high, true};
    }
    if (is_a_rise(with.mean, without.mean)) {
        return EnergyRise{report::page_text("mean energy"), 100.0 * (with.mean / without.mean - 1.0), false,
                          false};
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
        const std::string which = report::page_text("rocks above {kj_text_energy} kJ per 1000 released ",
                                                    {{"kj_text_energy", kj_text(energy)}});
        const std::string from = rate_per_1000(before.value);
        const std::string to = rate_per_1000(after.value);
        return from == to ? report::page_text("{which}stay at {to}", {{"which", which}, {"to", to}})
               : after.value < before.value
                   ? report::page_text("{which}fall from {from} to {to}",
                                       {{"which", which}, {"from", from}, {"to", to}})
                   : report::page_text("{which}rise from {from} to {to}",
                                       {{"which", which}, {"from", from}, {"to", to}});
    }
    return "";
}

std::string rise_in_words(const ArrivalFigures& forest, const ArrivalFigures& bare, const std::string& note) {
    const auto rise = energy_rise(forest, bare);
    if (!rise) {
        return "";
    }
    const std::string change = change_of_strong_rocks(forest, bare);
    const bool is_open = rise->has_interval && !rise->is_certain;  // chance alone may be the cause
    return report::page_text(
        is_open
            ? "The {rise_figure} of those that still arrive is {percent_text_rise} "
              "higher{note}{part}{part_2}."
            : "The {rise_figure} of those that still arrive is {percent_text_rise} higher{note}{part}, "
              "because the forest stops small and slow rocks more often than large and fast ones{part_2}.",
        {{"rise_figure", rise->figure},
         {"percent_text_rise", percent_text(rise->percent)},
         {"note", note},
         {"part", is_open ? report::page_text(" (within the uncertainty of few rocks)") : ""},
         {"part_2", change.empty() ? "" : joined("; ", change)}});
}

std::string reduction_in_words(const TargetFigures& target) {
    const RiskReduction& reduction = *target.reduction;
    const std::string text = joined(frequency_in_words(reduction), intensity_in_words(target));
    return std::isnan(reduction.orpi_percent)
               ? text
               : report::page_text(
                     "{value} Combined (ORPI): {reduction_orpi_percent}.",
                     {{"value", text}, {"reduction_orpi_percent", percent_text(reduction.orpi_percent)}});
}

}  // namespace coupling
