#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/effect_words.hpp"
#include "coupling/results/few_rocks.hpp"
#include "coupling/results/report/energy_rates.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/sections.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string interval_text(const Interval& interval) {
    return joined(percent(interval.low), " to ", percent(interval.high));
}

/// The shares of both slopes as bars with their intervals.
std::string share_bars(const TargetFigures& target, const std::vector<Cover>& covers) {
    constexpr double left = 96.0;
    constexpr double length = 250.0;
    double most = 0.0;
    for (const Cover cover : covers) {
        most = std::max(most, target.at(cover).share.interval.high);
    }
    const double per_share = most > 0.0 ? length / most : 0.0;
    std::string svg = joined("<svg class=\"bars\" viewBox=\"0 0 440 ",
                             place(34.0 * static_cast<double>(covers.size()) + 6.0),
                             "\" role=\"img\" aria-label=\"share of rocks that arrive\">");
    double y = 6.0;
    for (const Cover cover : covers) {
        const Share& share = target.at(cover).share;
        const double low = left + per_share * share.interval.low;
        const double high = left + per_share * share.interval.high;
        svg += joined("<text text-anchor=\"end\" x=\"", place(left - 8.0), "\" y=\"", place(y + 16.0), "\">",
                      (cover == Cover::forest ? "with forest" : "bare slope"), "</text><rect class=\"",
                      name_of(cover), "\" x=\"", place(left), "\" y=\"", place(y), "\" width=\"",
                      place(per_share * share.value), "\" height=\"22\"/><path class=\"whisker\" d=\"M",
                      place(low), " ", place(y + 11.0), "H", place(high), "M", place(low), " ",
                      place(y + 6.0), "v10M", place(high), " ", place(y + 6.0), "v10\"/><text x=\"",
                      place(high + 8.0), "\" y=\"", place(y + 16.0), "\">", percent(share.value), "</text>");
        y += 34.0;
    }
    return joined(svg, "</svg>");
}

std::string reaching(const Share& share) {
    return joined("<b>", percent(share.value), "</b> of the rocks (", grouped(share.part), " of ",
                  grouped(share.whole), ")");
}

std::string protection_sentence(const TargetFigures& target) {
    if (!target.protection) {
        return "No rock arrives over the bare slope: there is no danger here that the forest could lower.";
    }
    if (too_few_for_protection(target.paired)) {
        return joined("<b>No protection figure</b>: ", too_few_in_words(target.paired.bare()), ".");
    }
    const ProtectionEffect& effect = *target.protection;
    if (effect.one_sided) {
        return joined("The forest stops <b>all of them</b>; with 95 % confidence at least ",
                      percent(std::max(0.0, effect.interval.low)), ".");
    }
    if (effect.value < 0.0) {
        return joined("With forest <b>more</b> rocks arrive here: protection effect <b>",
                      percent(effect.value), "</b> (95 % interval ", interval_text(effect.interval), ").");
    }
    return joined("The forest stops <b>", percent(effect.value),
                  "</b> of the rocks that would arrive (95 % interval ", interval_text(effect.interval),
                  ").");
}

bool nothing_arrives(const TargetFigures& target) {
    return target.at(Cover::bare).share.part == 0 && target.at(Cover::forest).share.part == 0;
}

std::string nothing(const TargetFigures& target, const RunResults& results) {
    const Share& bare = target.at(Cover::bare).share;
    return joined("<p class=\"answer\"><b>No rock</b> of ", grouped(bare.whole), " arrives here",
                  results.with_forest ? ", neither with today's forest nor over the bare slope"
                                      : " over the bare slope",
                  ". With 95 % confidence fewer than ", percent(bare.interval.high),
                  " of rocks released like these would.</p>");
}

std::string answer(const TargetFigures& target, const RunResults& results) {
    const Share& bare = target.at(Cover::bare).share;
    if (!results.with_forest) {
        return joined("<p class=\"answer\">", reaching(bare), " reach it over the bare slope (95 % interval ",
                      interval_text(bare.interval),
                      "). Only the bare slope is assessed: ", why_no_obstacles(results), ".</p>");
    }
    return joined("<p class=\"answer\">", reaching(target.at(Cover::forest).share),
                  " reach it with today's forest, ", reaching(bare), " over the bare slope. ",
                  protection_sentence(target), "</p>");
}

/// "812 (790 to 834)"; an interval that is open upwards has too few rocks.
std::string with_interval(const Distribution& d) {
    if (std::isnan(d.p95)) {
        return "–";
    }
    const bool open = std::isinf(d.p95_interval.high);
    return joined(three_digits(d.p95), " <span class=\"soft\">(", three_digits(d.p95_interval.low),
                  (open ? " or more" : joined(" to ", three_digits(d.p95_interval.high))), ")</span>");
}

/// What happens beyond the rim of the terrain nobody knows.
std::string leaving(const RunResults& results, const Figures& figures) {
    constexpr auto left = static_cast<std::size_t>(rockfall::StopReason::left_terrain);
    const Share& bare = figures.at(Cover::bare).by_reason[left];
    const Share& forest = figures.at(Cover::forest).by_reason[left];
    if (bare.part + forest.part == 0) {
        return "";
    }
    return joined("<p class=\"soft\">", percent(bare.value),
                  " of the rocks leave the terrain over the bare slope",
                  results.with_forest ? joined(", ", percent(forest.value), " with forest") : std::string{},
                  ", over its rim or into a hole without heights: where they end is not known, and a target "
                  "beyond counts none of them.</p>\n");
}

std::string figures_at(const TargetFigures& target, const std::vector<Cover>& covers) {
    HtmlTable table{"",
                    {"at this target", "mean", "50 %", "90 %", "95 % (interval)", "98 %", "99 %", "largest"}};
    struct Quantity {
        const char* name;
        Distribution ArrivalFigures::*values;
    };
    constexpr std::array quantities{Quantity{"Energy, kJ", &ArrivalFigures::energy_kj},
                                    Quantity{"Speed, m/s", &ArrivalFigures::speed_mps},
                                    Quantity{"Height above ground, m", &ArrivalFigures::height_m}};
    for (const Quantity& quantity : quantities) {
        table.group(quantity.name);
        for (const Cover cover : covers) {
            const Distribution& d = target.at(cover).*quantity.values;
            const std::uint64_t rocks = target.at(cover).share.part;
            table.row({joined(cover == Cover::forest ? "with forest" : "bare slope", " <small>(",
                              grouped(rocks), rocks == 1 ? " rock" : " rocks", ")</small>"),
                       three_digits(d.mean), three_digits(d.p50), three_digits(d.p90), with_interval(d),
                       three_digits(d.p98), three_digits(d.p99), three_digits(d.max)});
        }
    }
    return table.html();
}

/// What became of the rocks, how sure the answer is, and what would make it surer.
std::string certainty(const TargetFigures& target, const RunResults& results) {
    const std::uint64_t rocks = target.at(Cover::bare).share.whole;
    std::string text = "<p class=\"soft\">";
    if (results.with_forest && target.protection) {
        const std::uint64_t turned = target.paired.only_forest;
        text += joined("The forest stops ", grouped(target.paired.only_bare), " rocks that would arrive; ",
                       grouped(turned), turned == 1 ? " arrives" : " arrive",
                       " only because a tree or log deflected ", turned == 1 ? "it. " : "them. ");
    }
    return joined(text, "To halve the uncertainty, simulate ", grouped(rocks_for_half(rocks)), " rocks.</p>");
}

/// Whether the forest makes the rocks that still arrive look stronger, and what that means.
std::string effect_on_energy(const TargetFigures& target) {
    return !target.reduction || too_few_for_protection(target.paired)
               ? ""
               : joined("<p>", reduction_in_words(target), "</p>\n");
}

std::string rates_at(const TargetFigures& target, const std::vector<Cover>& covers) {
    std::vector<EnergyRates> rows;
    for (const Cover cover : covers) {
        rows.push_back({cover == Cover::forest ? "with forest" : "bare slope", target.at(cover).above});
    }
    return energy_rates_table("at this target", rows);
}

std::string without_targets(const RunResults& results, const Figures& figures) {
    const SlopeFigures& bare = figures.at(Cover::bare);
    std::string text =
        "<section class=\"card\"><p class=\"answer\">No target was given, so nothing is counted at a road or "
        "house. ";
    if (results.with_forest) {
        const SlopeFigures& forest = figures.at(Cover::forest);
        text += joined("With forest rocks run out <b>", three_digits(forest.run_out_m.mean),
                       " m</b> on average (95 % of them at most ", three_digits(forest.run_out_m.p95),
                       " m), over the bare slope ");
    } else {
        text += "Over the bare slope rocks run out ";
    }
    return joined(text, "<b>", three_digits(bare.run_out_m.mean),
                  " m</b> (95 %: ", three_digits(bare.run_out_m.p95), " m).</p></section>\n");
}

}  // namespace

std::string answers(const RunResults& results, const Figures& figures) {
    std::string html = results.with_forest ? "<h2>What arrives, and what the forest stops</h2>\n"
                                           : "<h2>What arrives</h2>\n";
    if (figures.targets.empty()) {
        return html + without_targets(results, figures);
    }
    const std::vector<Cover> covers = covers_of(results);
    for (const TargetFigures& target : figures.targets) {
        html += joined("<section class=\"card\"><h3>", escaped(target.name.empty() ? target.id : target.name),
                       "</h3>");
        html += nothing_arrives(target)
                    ? nothing(target, results)
                    : joined(answer(target, results), "<div class=\"two\">", share_bars(target, covers),
                             certainty(target, results), "</div>\n", effect_on_energy(target),
                             rates_at(target, covers), figures_at(target, covers));
        html += "</section>\n";
    }
    return joined(
        html, leaving(results, figures), "<p class=\"soft\">Energy (", rockfall::what_energies_count(),
        ") is that of a rock where it first meets the target; height is that of its underside, vertically "
        "above the ground. Intervals cover the chance in the simulated rocks, "
        "not what the "
        "terrain model, the tree list or the rockfall model get wrong. How often rocks break off is not "
        "part of this "
        "run: shares are per released rock, not per year.</p>\n");
}

}  // namespace coupling::report
