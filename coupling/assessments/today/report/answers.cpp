#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/energy_rates.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string interval_text(const Interval& interval) {
    return page_text("{interval_low} to {interval_high}",
                     {{"interval_low", percent(interval.low)}, {"interval_high", percent(interval.high)}});
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
                             "\" role=\"img\" aria-label=\"", page_text("share of rocks that arrive"), "\">");
    double y = 6.0;
    for (const Cover cover : covers) {
        const Share& share = target.at(cover).share;
        const double low = left + per_share * share.interval.low;
        const double high = left + per_share * share.interval.high;
        svg += joined("<text text-anchor=\"end\" x=\"", place(left - 8.0), "\" y=\"", place(y + 16.0), "\">",
                      (cover == Cover::forest ? page_text("with forest") : page_text("bare slope")),
                      "</text><rect class=\"", name_of(cover), "\" x=\"", place(left), "\" y=\"", place(y),
                      "\" width=\"", place(per_share * share.value),
                      "\" height=\"22\"/><path class=\"whisker\" d=\"M", place(low), " ", place(y + 11.0),
                      "H", place(high), "M", place(low), " ", place(y + 6.0), "v10M", place(high), " ",
                      place(y + 6.0), "v10\"/><text x=\"", place(high + 8.0), "\" y=\"", place(y + 16.0),
                      "\">", percent(share.value), "</text>");
        y += 34.0;
    }
    return joined(svg, "</svg>");
}

std::string protection_sentence(const TargetFigures& target) {
    if (!target.protection) {
        return page_text(
            "No rock arrives over the bare slope: there is no danger here that the forest could lower.");
    }
    if (too_few_for_protection(target.paired)) {
        return page_text("<b>No protection figure</b>: {paired_bare}.",
                         {{"paired_bare", too_few_in_words(target.paired.bare())}});
    }
    const ProtectionEffect& effect = *target.protection;
    if (effect.one_sided) {
        return page_text("The forest stops <b>all of them</b>; with 95 % confidence at least {interval_low}.",
                         {{"interval_low", percent(std::max(0.0, effect.interval.low))}});
    }
    if (effect.value < 0.0) {
        return page_text(
            "With forest <b>more</b> rocks arrive here: protection effect <b>{effect}</b> (95 % interval "
            "{effect_interval}).",
            {{"effect", percent(effect.value)}, {"effect_interval", interval_text(effect.interval)}});
    }
    return page_text(
        "The forest stops <b>{effect}</b> of the rocks that would arrive (95 % interval {effect_interval}).",
        {{"effect", percent(effect.value)}, {"effect_interval", interval_text(effect.interval)}});
}

bool nothing_arrives(const TargetFigures& target) {
    return target.at(Cover::bare).share.part == 0 && target.at(Cover::forest).share.part == 0;
}

std::string nothing(const TargetFigures& target, const RunResults& results) {
    const Share& bare = target.at(Cover::bare).share;
    return joined(
        "<p class=\"answer\">",
        page_text(results.with_forest
                      ? "<b>No rock</b> of {rocks} arrives here, neither with today's forest nor over "
                        "the bare slope. With 95 % confidence fewer than {share} of rocks released like "
                        "these would."
                      : "<b>No rock</b> of {rocks} arrives here over the bare slope. With 95 % "
                        "confidence fewer than {share} of rocks released like these would.",
                  {{"rocks", grouped(bare.whole)}, {"share", percent(bare.interval.high)}}),
        "</p>");
}

std::string answer(const TargetFigures& target, const RunResults& results) {
    const Share& bare = target.at(Cover::bare).share;
    if (!results.with_forest) {
        return joined(
            "<p class=\"answer\">",
            page_text("<b>{share}</b> of the rocks ({reached} of {rocks}) reach it over the bare slope "
                      "(95 % interval {interval}). Only the bare slope is assessed: {why_no_obstacles}.",
                      {{"share", percent(bare.value)},
                       {"reached", grouped(bare.part)},
                       {"rocks", grouped(bare.whole)},
                       {"interval", interval_text(bare.interval)},
                       {"why_no_obstacles", why_no_obstacles(results)}}),
            "</p>");
    }
    const Share& forest = target.at(Cover::forest).share;
    return joined(
        "<p class=\"answer\">",
        join_sentences(
            {page_text("<b>{share}</b> of the rocks ({reached} of {rocks}) reach it with today's forest, "
                       "<b>{bare_share}</b> of the rocks ({bare_reached} of {bare_rocks}) over the bare "
                       "slope.",
                       {{"share", percent(forest.value)},
                        {"reached", grouped(forest.part)},
                        {"rocks", grouped(forest.whole)},
                        {"bare_share", percent(bare.value)},
                        {"bare_reached", grouped(bare.part)},
                        {"bare_rocks", grouped(bare.whole)}}),
             protection_sentence(target)}),
        "</p>");
}

/// "812 (790 to 834)"; an interval that is open upwards has too few rocks.
std::string with_interval(const Distribution& d) {
    if (std::isnan(d.p95)) {
        return "–";
    }
    const std::string low = three_digits(d.p95_interval.low);
    return joined(
        three_digits(d.p95), " <span class=\"soft\">(",
        std::isinf(d.p95_interval.high)
            ? page_text("{low} or more", {{"low", low}})
            : page_text("{interval_low} to {interval_high}",
                        {{"interval_low", low}, {"interval_high", three_digits(d.p95_interval.high)}}),
        ")</span>");
}

std::string figures_at(const TargetFigures& target, const std::vector<Cover>& covers) {
    HtmlTable table{"",
                    {page_text("at this target"), page_text("mean"), "50 %", "90 %",
                     page_text("95 % (interval)"), "98 %", "99 %", page_text("largest")}};
    struct Quantity {
        const char* name;
        Distribution ArrivalFigures::*values;
    };
    constexpr std::array quantities{Quantity{"Energy, kJ", &ArrivalFigures::energy_kj},
                                    Quantity{"Speed, m/s", &ArrivalFigures::speed_mps},
                                    Quantity{"Height above ground, m", &ArrivalFigures::height_m}};
    for (const Quantity& quantity : quantities) {
        table.group(page_text(quantity.name));
        for (const Cover cover : covers) {
            const Distribution& d = target.at(cover).*quantity.values;
            const std::uint64_t rocks = target.at(cover).share.part;
            table.row(
                {joined(cover == Cover::forest ? page_text("with forest") : page_text("bare slope"),
                        " <small>(",
                        page_text(rocks == 1 ? "{rocks} rock" : "{rocks} rocks", {{"rocks", grouped(rocks)}}),
                        ")</small>"),
                 three_digits(d.mean), three_digits(d.p50), three_digits(d.p90), with_interval(d),
                 three_digits(d.p98), three_digits(d.p99), three_digits(d.max)});
        }
    }
    return table.html();
}

/// What became of the rocks, how sure the answer is, and what would make it surer.
std::string certainty(const TargetFigures& target, const RunResults& results) {
    const std::uint64_t rocks = target.at(Cover::bare).share.whole;
    std::string turned;
    if (results.with_forest && target.protection) {
        turned = page_text(
            "Of the rocks that would arrive the forest stops {stopped}; arriving only by deflection at a "
            "tree or log: "
            "{turned}.",
            {{"stopped", grouped(target.paired.only_bare)}, {"turned", grouped(target.paired.only_forest)}});
    }
    return joined(
        "<p class=\"soft\">",
        join_sentences(
            {turned, page_text("To halve the uncertainty, simulate {rocks} rocks.",
                               {{"rocks", three_digits(static_cast<double>(rocks_for_half(rocks)))}})}),
        "</p>");
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
        rows.push_back({cover == Cover::forest ? page_text("with forest") : page_text("bare slope"),
                        target.at(cover).above});
    }
    return energy_rates_table(page_text("at this target"), rows);
}

std::string name_of_target(const TargetFigures& target) {
    return escaped(target.name.empty() ? target.id : target.name);
}

std::string run_out_on(const SlopeFigures& slope, const std::string& name) {
    return page_text(
        "Mean run-out {slope}: <b>{mean} m</b> (95 % at most {p95} m) {of_whom}.",
        {{"slope", name},
         {"mean", three_digits(slope.run_out_m.mean)},
         {"p95", three_digits(slope.run_out_m.p95)},
         {"of_whom", of_those_that_stop(slope.stopped.value, three_digits(slope.run_out_at_least_m.mean))}});
}

std::string without_targets(const RunResults& results, const Figures& figures) {
    return joined(
        "<section class=\"card\"><p class=\"answer\">",
        join_sentences(
            {page_text("No target was given, so nothing is counted at a road or house."),
             results.with_forest ? run_out_on(figures.at(Cover::forest), page_text("with forest")) : "",
             run_out_on(figures.at(Cover::bare), page_text("over the bare slope"))}),
        "</p></section>\n");
}

}  // namespace

std::string answers(const RunResults& results, const Figures& figures) {
    if (figures.targets.empty()) {
        return without_targets(results, figures);
    }
    constexpr std::size_t most_answers = 4;
    const std::vector<Cover> covers = covers_of(results);
    std::string html;
    for (std::size_t i = 0; i < std::min(most_answers, figures.targets.size()); ++i) {
        const TargetFigures& target = figures.targets[i];
        html += joined("<section class=\"card\"><h3>", name_of_target(target), "</h3>",
                       nothing_arrives(target) ? nothing(target, results)
                                               : joined(answer(target, results), share_bars(target, covers)),
                       "</section>\n");
    }
    return figures.targets.size() <= most_answers
               ? html
               : joined(html, "<p class=\"soft\">",
                        page_text("{more} more targets stand in the appendix.",
                                  {{"more", grouped(figures.targets.size() - most_answers)}}),
                        "</p>\n");
}

std::string answers_in_detail(const RunResults& results, const Figures& figures) {
    if (figures.targets.empty()) {
        return "";
    }
    std::string html = results.with_forest
                           ? joined("<h2>", page_text("What arrives, and what the forest stops"), "</h2>\n")
                           : joined("<h2>", page_text("What arrives"), "</h2>\n");
    const std::vector<Cover> covers = covers_of(results);
    const bool all_are_above = figures.targets.size() == 1;
    for (const TargetFigures& target : figures.targets) {
        html += joined("<section class=\"card\"><h3>", name_of_target(target), "</h3>");
        html += nothing_arrives(target)
                    ? nothing(target, results)
                    : joined(all_are_above ? "" : answer(target, results), certainty(target, results),
                             effect_on_energy(target), rates_at(target, covers), figures_at(target, covers));
        html += "</section>\n";
    }
    return joined(
        html, "<p class=\"soft\">",
        page_text(
            "Energy ({energies}) is that of a rock where it first meets the target; height is that of its "
            "underside, vertically above the ground. Intervals cover the chance in the simulated rocks, not "
            "what the terrain model, the tree list or the rockfall model get wrong. How often rocks break "
            "off is not part of this run: shares are per released rock, not per year.",
            {{"energies", in_page_language(rockfall::what_energies_count())}}),
        "</p>\n");
}

}  // namespace coupling::report
