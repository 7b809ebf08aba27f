#include "coupling/assessments/nets/siting/siting_words.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::siting {
namespace {

using config::joined;
using report::page_text;

std::string cover_in_words(rockfall::Cover cover) {
    return cover == rockfall::Cover::forest ? page_text("with forest") : page_text("bare slope");
}

}  // namespace

LineSums sums_of(const std::vector<LineBin>& bins) {
    LineSums sums;
    for (const LineBin& bin : bins) {
        sums.rocks += bin.rocks;
        sums.energy_kj += bin.energy_sum_kj;
    }
    return sums;
}

std::string line_in_words(const SitingResults& results, std::size_t line) {
    const auto judged = static_cast<std::size_t>(results.judged);
    const LineSums comes = sums_of(results.by_line[line].bins[judged]);
    const std::string& name = results.lines[line].name;
    if (comes.rocks == 0) {
        return page_text("{line}: no rock comes to it {cover}; no nets are needed",
                         {{"line", name}, {"cover", cover_in_words(results.judged)}});
    }
    double needed_m = 0.0;
    std::size_t stretches = 0;
    for (const StretchResult& stretch : results.stretches) {
        if (stretch.sited.line == line) {
            needed_m += stretch.sited.stretch.to_m - stretch.sited.stretch.from_m;
            ++stretches;
        }
    }
    const LineSums left = sums_of(results.by_line[line].left[judged]);
    const double left_share = comes.energy_kj > 0.0 ? left.energy_kj / comes.energy_kj : 0.0;
    const std::string found = page_text(
        stretches == 1
            ? "{line}: works are needed on {needed_m} of {length_m} m: {stretches} stretch receives at "
              "least {wanted} of the energy that comes to the line {cover}. Rocks that come: {rocks}; past "
              "the nets below: {left_rocks}, with {left_energy} of the energy."
            : "{line}: works are needed on {needed_m} of {length_m} m: {stretches} stretches receive at "
              "least {wanted} of the energy that comes to the line {cover}. Rocks that come: {rocks}; past "
              "the nets below: {left_rocks}, with {left_energy} of the energy.",
        {{"line", name},
         {"needed_m", report::fixed(needed_m, 0)},
         {"length_m", report::fixed(length_m(results.lines[line].line_m), 0)},
         {"stretches", std::to_string(stretches)},
         {"wanted", report::percent(results.wish.share)},
         {"cover", cover_in_words(results.judged)},
         {"rocks", report::grouped(comes.rocks)},
         {"left_rocks", report::grouped(left.rocks)},
         {"left_energy", report::percent(left_share)}});
    constexpr double rounding = 1e-9;
    const bool has_nets =
        std::any_of(results.stretches.begin(), results.stretches.end(), [&](const StretchResult& stretch) {
            return stretch.sited.line == line && stretch.ranking.best.has_value();
        });
    return !has_nets || left_share <= 1.0 - results.wish.share + rounding
               ? found
               : report::join_sentences(
                     {found, page_text("Together they keep less than the wanted {wanted} of the energy.",
                                       {{"wanted", report::percent(results.wish.share)}})});
}

std::string net_in_words(const NetDesign& net) {
    const std::string text =
        page_text("class {class} ({capacity_kj} kJ), {height_m} m high, {length_m} m long",
                  {{"class", net.energy_class},
                   {"capacity_kj", report::tick_text(net.capacity_kj)},
                   {"height_m", report::exact(net.height_m)},
                   {"length_m", report::fixed(net.length_m(), 0)}});
    return net.sold_height_m
               ? text
               : page_text("{net}; no net on offer is that high (design.sold_heights_m)", {{"net", text}});
}

std::string ties_of(const SitingResults& results, const StretchResult& stretch) {
    std::string list;
    for (std::size_t i = 0; i < stretch.candidates.size(); ++i) {
        if (stretch.ranking.ties[i]) {
            list += joined(list.empty() ? "" : ", ",
                           config::to_text(results.candidates[stretch.candidates[i]].distance_m));
        }
    }
    return list;
}

std::string stretch_in_words(const SitingResults& results, const StretchResult& stretch) {
    const std::string where =
        page_text("{from_m} to {to_m} m", {{"from_m", report::fixed(stretch.sited.stretch.from_m, 0)},
                                           {"to_m", report::fixed(stretch.sited.stretch.to_m, 0)}});
    if (!stretch.ranking.best) {
        const std::uint64_t needed =
            std::max(rocks_to_tell(results.wish.share), rocks_to_tell(results.wish.design.share()));
        return stretch.rocks < needed
                   ? page_text(stretch.rocks == 1
                                   ? "{where}: {rocks} rock comes, too few for an estimate (at "
                                     "least {needed}); simulate more rocks"
                                   : "{where}: {rocks} rocks come, too few for an estimate (at "
                                     "least {needed}); simulate more rocks",
                               {{"where", where},
                                {"rocks", report::grouped(stretch.rocks)},
                                {"needed", report::grouped(needed)}})
                   : page_text(
                         "{where}: no candidate keeps a rock from it; try other distances "
                         "(--distances) or another direction (--azimuth)",
                         {{"where", where}});
    }
    const std::size_t best = stretch.candidates[*stretch.ranking.best];
    const CandidateFigures& figures = results.figures[best][static_cast<std::size_t>(results.judged)];
    const auto& bare = results.figures[best][static_cast<std::size_t>(rockfall::Cover::bare)].needed;
    const Share& kept = figures.judged.left.kept;
    const std::string ties = ties_of(results, stretch);
    return report::join_with_semicolons(
        {page_text("{where}: {net}, {distance_m} m upslope, keeps {kept} ({kept_low} to {kept_high}) of "
                   "{rocks} rocks",
                   {{"where", where},
                    {"net", net_in_words(*figures.judged.net)},
                    {"distance_m", report::exact(results.candidates[best].distance_m)},
                    {"kept", report::percent(kept.value)},
                    {"kept_low", report::percent(kept.interval.low)},
                    {"kept_high", report::percent(kept.interval.high)},
                    {"rocks", report::grouped(kept.whole)}}),
         keeps_wanted(figures.judged, results.wish.share)
             ? ""
             : page_text("this is less than the wanted {wanted}",
                         {{"wanted", report::percent(results.wish.share)}}),
         page_text("left below: {left_energy} of the energy, the largest {largest_kj} kJ",
                   {{"left_energy", report::percent(0.01 * figures.judged.left.energy_percent)},
                    {"largest_kj", report::three_digits(figures.judged.left.largest_kj)}}),
         page_text("rocks that pass over it: {over}, through it: {through}, beside it: {beside}",
                   {{"over", report::grouped(figures.judged.left.over)},
                    {"through", report::grouped(figures.judged.left.through)},
                    {"beside", report::grouped(figures.judged.left.beside)}}),
         figures.needed ? upper_in_words(*figures.needed) : "",
         results.with_forest && bare
             ? page_text("without forest this net would be {net}", {{"net", coupling::in_words(*bare)}})
             : "",
         ties.empty() ? "" : page_text("as good: {ties} m upslope", {{"ties", ties}})});
}

std::vector<std::string> in_words(const SitingResults& results) {
    std::vector<std::string> lines;
    for (std::size_t line = 0; line < results.lines.size(); ++line) {
        lines.push_back(line_in_words(results, line));
        for (const StretchResult& stretch : results.stretches) {
            if (stretch.sited.line == line) {
                lines.push_back(joined("  ", stretch_in_words(results, stretch)));
            }
        }
    }
    return lines;
}

}  // namespace coupling::siting
