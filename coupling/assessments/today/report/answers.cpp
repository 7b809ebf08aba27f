#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/energy_rates.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string interval_text(const Interval& interval) {
    return page_text("today.answers.to",
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
    std::string svg = joined(
        "<svg class=\"bars\" viewBox=\"0 0 440 ", place(34.0 * static_cast<double>(covers.size()) + 6.0),
        "\" role=\"img\" aria-label=\"", page_text("today.answers.share_of_rocks_that_arrive"), "\">");
    double y = 6.0;
    for (const Cover cover : covers) {
        const Share& share = target.at(cover).share;
        const double low = left + per_share * share.interval.low;
        const double high = left + per_share * share.interval.high;
        svg += joined(
            "<text text-anchor=\"end\" x=\"", place(left - 8.0), "\" y=\"", place(y + 16.0), "\">",
            (cover == Cover::forest ? page_text("common.with_forest") : page_text("common.bare_slope")),
            "</text><rect class=\"", name_of(cover), "\" x=\"", place(left), "\" y=\"", place(y),
            "\" width=\"", place(per_share * share.value), "\" height=\"22\"/><path class=\"whisker\" d=\"M",
            place(low), " ", place(y + 11.0), "H", place(high), "M", place(low), " ", place(y + 6.0), "v10M",
            place(high), " ", place(y + 6.0), "v10\"/><text x=\"", place(high + 8.0), "\" y=\"",
            place(y + 16.0), "\">", percent(share.value), "</text>");
        y += 34.0;
    }
    return joined(svg, "</svg>");
}

std::string reaching(const Share& share) {
    return page_text("today.answers.of_the_rocks_of", {{"share", percent(share.value)},
                                                       {"share_part", grouped(share.part)},
                                                       {"share_whole", grouped(share.whole)}});
}

std::string protection_sentence(const TargetFigures& target) {
    if (!target.protection) {
        return page_text("today.answers.no_rock_arrives_over_the_bare");
    }
    if (too_few_for_protection(target.paired)) {
        return page_text("today.answers.no_protection_figure",
                         {{"paired_bare", too_few_in_words(target.paired.bare())}});
    }
    const ProtectionEffect& effect = *target.protection;
    if (effect.one_sided) {
        return page_text("today.answers.the_forest_stops_all_of_them",
                         {{"interval_low", percent(std::max(0.0, effect.interval.low))}});
    }
    if (effect.value < 0.0) {
        return page_text(
            "today.answers.with_forest_more_rocks_arrive",
            {{"effect", percent(effect.value)}, {"effect_interval", interval_text(effect.interval)}});
    }
    return page_text(
        "today.answers.the_forest_stops_of_the_rocks",
        {{"effect", percent(effect.value)}, {"effect_interval", interval_text(effect.interval)}});
}

bool nothing_arrives(const TargetFigures& target) {
    return target.at(Cover::bare).share.part == 0 && target.at(Cover::forest).share.part == 0;
}

std::string nothing(const TargetFigures& target, const RunResults& results) {
    const Share& bare = target.at(Cover::bare).share;
    return joined(
        "<p class=\"answer\">",
        page_text("today.answers.no_rock_of_arrives_here_with_95",
                  {{"bare_whole", grouped(bare.whole)},
                   {"part", results.with_forest ? page_text("today.answers.neither_with_today_s_forest_nor")
                                                : page_text("today.answers.over_the_bare_slope")},
                   {"interval_high", percent(bare.interval.high)}}),
        "</p>");
}

std::string answer(const TargetFigures& target, const RunResults& results) {
    const Share& bare = target.at(Cover::bare).share;
    if (!results.with_forest) {
        return joined("<p class=\"answer\">",
                      page_text("today.answers.reach_it_over_the_bare_slope_95",
                                {{"reaching_bare", reaching(bare)},
                                 {"bare_interval", interval_text(bare.interval)},
                                 {"why_no_obstacles", why_no_obstacles(results)}}),
                      "</p>");
    }
    return joined("<p class=\"answer\">",
                  page_text("today.answers.reach_it_with_today_s_forest",
                            {{"forest_share", reaching(target.at(Cover::forest).share)},
                             {"reaching_bare", reaching(bare)},
                             {"protection_sentence_target", protection_sentence(target)}}),
                  "</p>");
}

/// "812 (790 to 834)"; an interval that is open upwards has too few rocks.
std::string with_interval(const Distribution& d) {
    if (std::isnan(d.p95)) {
        return "–";
    }
    const bool open = std::isinf(d.p95_interval.high);
    return joined(
        three_digits(d.p95), " <span class=\"soft\">(", three_digits(d.p95_interval.low),
        (open ? page_text("today.answers.or_more")
              : page_text("today.answers.to_2", {{"p95_interval_high", three_digits(d.p95_interval.high)}})),
        ")</span>");
}

std::string figures_at(const TargetFigures& target, const std::vector<Cover>& covers) {
    HtmlTable table{"",
                    {page_text("today.answers.at_this_target"), page_text("common.mean"), "50 %", "90 %",
                     page_text("today.answers.95_interval"), "98 %", "99 %", page_text("common.largest")}};
    struct Quantity {
        const char* name;
        Distribution ArrivalFigures::*values;
    };
    constexpr std::array quantities{Quantity{"common.energy_kj", &ArrivalFigures::energy_kj},
                                    Quantity{"today.answers.speed_m_s", &ArrivalFigures::speed_mps},
                                    Quantity{"common.height_above_ground_m", &ArrivalFigures::height_m}};
    for (const Quantity& quantity : quantities) {
        table.group(page_text(quantity.name));
        for (const Cover cover : covers) {
            const Distribution& d = target.at(cover).*quantity.values;
            const std::uint64_t rocks = target.at(cover).share.part;
            table.row({joined(cover == Cover::forest ? page_text("common.with_forest")
                                                     : page_text("common.bare_slope"),
                              " <small>(", grouped(rocks),
                              rocks == 1 ? page_text("today.answers.rock") : page_text("today.answers.rocks"),
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
    std::string text = "<p class=\"soft\">";
    if (results.with_forest && target.protection) {
        const std::uint64_t turned = target.paired.only_forest;
        text += page_text(
            "today.answers.the_forest_stops_rocks_that",
            {{"paired_only_bare", grouped(target.paired.only_bare)},
             {"turned", grouped(turned)},
             {"part", turned == 1 ? page_text("today.answers.arrives") : page_text("today.answers.arrive")},
             {"part_2", turned == 1 ? page_text("today.answers.it") : page_text("today.answers.them")}});
    }
    return joined(page_text("today.answers.to_halve_the_uncertainty",
                            {{"value", text}, {"rocks_for_half_rocks", grouped(rocks_for_half(rocks))}}),
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
        rows.push_back(
            {cover == Cover::forest ? page_text("common.with_forest") : page_text("common.bare_slope"),
             target.at(cover).above});
    }
    return energy_rates_table(page_text("today.answers.at_this_target"), rows);
}

std::string name_of_target(const TargetFigures& target) {
    return escaped(target.name.empty() ? target.id : target.name);
}

std::string run_out_on(const SlopeFigures& slope, const std::string& name) {
    return page_text(
        "today.answers.mean_run_out",
        {{"slope", name},
         {"mean", three_digits(slope.run_out_m.mean)},
         {"p95", three_digits(slope.run_out_m.p95)},
         {"of_whom", of_those_that_stop(slope.stopped.value, three_digits(slope.run_out_at_least_m.mean))}});
}

std::string without_targets(const RunResults& results, const Figures& figures) {
    std::string text = joined("<section class=\"card\"><p class=\"answer\">",
                              page_text("today.answers.no_target_was_given_so_nothing"));
    if (results.with_forest) {
        text += joined(run_out_on(figures.at(Cover::forest), page_text("common.with_forest_in_text")), " ");
    }
    return joined(text, run_out_on(figures.at(Cover::bare), page_text("common.bare_slope_in_text")),
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
                        page_text("today.first.more_targets",
                                  {{"more", grouped(figures.targets.size() - most_answers)}}),
                        "</p>\n");
}

std::string answers_in_detail(const RunResults& results, const Figures& figures) {
    if (figures.targets.empty()) {
        return "";
    }
    std::string html = results.with_forest
                           ? joined("<h2>", page_text("today.answers.what_arrives_and_what_the"), "</h2>\n")
                           : joined("<h2>", page_text("today.answers.what_arrives"), "</h2>\n");
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
    return joined(html, "<p class=\"soft\">",
                  page_text("today.answers.energy_is_translation_and",
                            {{"energies", in_page_language(rockfall::what_energies_count())}}),
                  "</p>\n");
}

}  // namespace coupling::report
