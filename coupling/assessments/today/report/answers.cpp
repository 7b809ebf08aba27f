#include <algorithm>
#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/fall_doubts.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/most_reached.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/energy_rates.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

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
    constexpr double length = 205.0;  // a figure such as "less than 0.01 %" has room behind it
    double most = 0.0;
    for (const Cover cover : covers) {
        most = std::max(most, target.at(cover).share.interval.high);
    }
    const double per_share = most > 0.0 ? length / most : 0.0;
    std::string bars;
    double y = 6.0;
    for (const Cover cover : covers) {
        const Share& share = target.at(cover).share;
        const double low = left + per_share * share.interval.low;
        const double high = left + per_share * share.interval.high;
        bars += joined(svg_text(left - 8.0, y + 16.0, title_of(cover), {{"text-anchor", "end"}}),
                       element("rect", {{"class", name_of(cover)},
                                        {"x", left},
                                        {"y", y},
                                        {"width", per_share * share.value},
                                        {"height", 22.0}}),
                       svg_path("whisker", joined("M", place(low), " ", place(y + 11.0), "H", place(high),
                                                  "M", place(low), " ", place(y + 6.0), "v10M", place(high),
                                                  " ", place(y + 6.0), "v10")),
                       svg_text(high + 8.0, y + 16.0, percent(share.value)));
        y += 34.0;
    }
    return element("svg",
                   {{"class", "bars"},
                    {"viewBox", joined("0 0 440 ", place(y))},
                    {"role", "img"},
                    {"aria-label", page_text("share of rocks that arrive")}},
                   bars);
}

/// How the forest changes what arrives: one of six sentences.
PageFields protection_of(const TargetFigures& target, bool no_tree_is_met) {
    const bool meets_none = target.protection && no_tree_is_met;
    const bool is_shown = target.protection && !meets_none && !too_few_for_protection(target.paired);
    const ProtectionEffect effect = target.protection.value_or(ProtectionEffect{});
    return {{"no_danger", !target.protection},
            {"meets_none", meets_none},
            {"too_few", target.protection && !is_shown && !meets_none},
            {"paired_bare", too_few_in_words(target.paired.bare())},
            {"stops_all", is_shown && effect.one_sided},
            {"interval_low", percent(std::max(0.0, effect.interval.low))},
            {"lets_more_arrive", is_shown && !effect.one_sided && effect.value < 0.0},
            {"stops_some", is_shown && !effect.one_sided && !(effect.value < 0.0)},
            {"effect", percent(effect.value)},
            {"effect_interval", interval_text(effect.interval)}};
}

bool nothing_arrives(const TargetFigures& target) {
    return target.at(Cover::bare).share.part == 0 && target.at(Cover::forest).share.part == 0;
}

PageFields shares_on_both_slopes(const TargetFigures& target, bool no_tree_is_met) {
    const Share& bare = target.at(Cover::bare).share;
    const Share& forest = target.at(Cover::forest).share;
    PageFields fields = protection_of(target, no_tree_is_met);
    fields.insert(fields.end(), {{"share", percent(forest.value)},
                                 {"reached", grouped(forest.part)},
                                 {"rocks", grouped(forest.whole)},
                                 {"bare_share", percent(bare.value)},
                                 {"bare_reached", grouped(bare.part)},
                                 {"bare_rocks", grouped(bare.whole)}});
    return fields;
}

/// The fields of target_answer.html. Where rocks arrive it may be left out.
PageFields answer(const TargetFigures& target, const RunResults& results, bool is_left_out) {
    const bool with_forest = results.with_forest;
    const bool no_tree_is_met = met_no_tree(results.tally.runs[index_of(Cover::forest)]);
    const Share& bare = target.at(Cover::bare).share;
    const bool none = nothing_arrives(target);
    const bool answers = !none && !is_left_out;
    const auto part = [](bool is_shown, const PageFields& fields) {
        return is_shown ? std::optional{fields} : std::nullopt;
    };
    return {{"name", target.name.empty() ? target.id : target.name},
            {"none_arrives", part(none, {{"rocks", grouped(bare.whole)},
                                         {"share", percent(greatest_share_of_none(bare.whole))}})},
            {"on_bare_slope", part(answers && !with_forest, {{"share", percent(bare.value)},
                                                             {"reached", grouped(bare.part)},
                                                             {"rocks", grouped(bare.whole)},
                                                             {"interval", interval_text(bare.interval)}})},
            {"on_both_slopes", part(answers && with_forest, shares_on_both_slopes(target, no_tree_is_met))}};
}

/// One quantity at a target on one slope: a row of figures.
PageFields figures_on(const ArrivalFigures& arrivals, const Distribution& d, Cover cover) {
    const std::uint64_t rocks = arrivals.share.part;
    return {{"slope", title_of(cover)},
            {"one_rock", rocks == 1},
            {"rocks", grouped(rocks)},
            {"mean", three_digits(d.mean)},
            {"p50", three_digits(d.p50)},
            {"p90", three_digits(d.p90)},
            {"p95", three_digits(d.p95)},
            {"p95_interval",
             std::isnan(d.p95)
                 ? std::nullopt
                 : std::optional{PageFields{{"open", std::isinf(d.p95_interval.high)},  // too few rocks
                                            {"low", three_digits(d.p95_interval.low)},
                                            {"high", three_digits(d.p95_interval.high)}}}},
            {"p98", three_digits(d.p98)},
            {"p99", three_digits(d.p99)},
            {"max", three_digits(d.max)}};
}

std::vector<PageFields> quantities_at(const TargetFigures& target, const std::vector<Cover>& covers) {
    struct Quantity {
        const char* name;
        Distribution ArrivalFigures::*values;
    };
    constexpr std::array quantities{Quantity{"Energy, kJ", &ArrivalFigures::energy_kj},
                                    Quantity{"Speed, m/s", &ArrivalFigures::speed_mps},
                                    Quantity{"Height above ground, m", &ArrivalFigures::height_m}};
    std::vector<PageFields> rows;
    for (const Quantity& quantity : quantities) {
        std::vector<PageFields> slopes;
        for (const Cover cover : covers) {
            slopes.push_back(figures_on(target.at(cover), target.at(cover).*quantity.values, cover));
        }
        rows.push_back({{"quantity", page_text(quantity.name)}, {"on_slopes", slopes}});
    }
    return rows;
}

std::string rates_at(const TargetFigures& target, const std::vector<Cover>& covers) {
    std::vector<EnergyRates> rows;
    for (const Cover cover : covers) {
        rows.push_back({title_of(cover), target.at(cover).above});
    }
    return energy_rates_table(page_text("at this target"), rows);
}

/// What became of the rocks, how sure the answer is, what would make it surer, and all figures. Where a
/// forest makes the rocks that still arrive look stronger, `reduction` says what that means.
PageFields details_at(const TargetFigures& target, const RunResults& results) {
    const std::vector<Cover> covers = covers_of(results);
    const auto rocks_wanted = static_cast<double>(rocks_for_half(target.at(Cover::bare).share.whole));
    const bool has_reduction = target.reduction && !too_few_for_protection(target.paired);
    return {{"paired", results.with_forest && target.protection
                           ? std::optional{PageFields{{"stopped", grouped(target.paired.only_bare)},
                                                      {"turned", grouped(target.paired.only_forest)}}}
                           : std::nullopt},
            {"rocks", three_digits(rocks_wanted)},
            {"reduced", has_reduction},
            {"reduction", has_reduction ? reduction_in_words(target) : ""},
            {"energy_rates", rates_at(target, covers)},
            {"quantities", quantities_at(target, covers)}};
}

PageFields run_out_on(const SlopeFigures& slope, const std::string& name) {
    return {
        {"slope", name},
        {"mean", three_digits(slope.run_out_m.mean)},
        {"p95", three_digits(slope.run_out_m.p95)},
        {"of_whom", of_those_that_stop(slope.stopped.value, three_digits(slope.run_out_at_least_m.mean))}};
}

/// Of many targets: how many rocks reach at all.
PageFields reached_of_all(const Figures& figures, std::size_t shown) {
    const auto reached = [&](Cover cover) {
        return grouped(static_cast<std::size_t>(
            std::count_if(figures.targets.begin(), figures.targets.end(),
                          [&](const TargetFigures& target) { return target.at(cover).share.part > 0; })));
    };
    return {{"targets", grouped(figures.targets.size())},
            {"reached_bare", reached(Cover::bare)},
            {"reached_forest", reached(Cover::forest)},
            {"shown", grouped(shown)}};
}

}  // namespace

PageFields answers(const RunResults& results, const Figures& figures) {
    const std::vector<Cover> covers = covers_of(results);
    std::vector<PageFields> cards;
    for (const std::size_t i : most_reached(results.tally.targets, most_target_cards)) {
        const TargetFigures& target = figures.targets[i];
        cards.push_back(answer(target, results, false));
        cards.back().push_back({"with_all", answer_with_all(results, figures, i)});
        cards.back().push_back({"share_bars", nothing_arrives(target) ? "" : share_bars(target, covers)});
    }
    std::vector<PageFields> run_outs{run_out_on(figures.at(Cover::bare), page_text("over the bare slope"))};
    if (results.with_forest) {
        run_outs.insert(run_outs.begin(), run_out_on(figures.at(Cover::forest), page_text("with forest")));
    }
    return {{"answers", cards},
            {"run_outs", run_outs},
            {"unanswered", cards.size() < figures.targets.size()
                               ? std::optional{reached_of_all(figures, cards.size())}
                               : std::nullopt}};
}

std::optional<PageFields> answers_in_detail(const RunResults& results, const Figures& figures) {
    std::vector<PageFields> targets;
    for (const std::size_t i : most_reached(results.tally.targets, most_targets_shown)) {
        const TargetFigures& target = figures.targets[i];
        // The answer at a single target stands on the first screen.
        targets.push_back(answer(target, results, figures.targets.size() == 1));
        targets.back().push_back({"arrivals", nothing_arrives(target)
                                                  ? std::nullopt
                                                  : std::optional{details_at(target, results)}});
    }
    return targets.empty()
               ? std::nullopt
               : std::optional{PageFields{{"detailed_targets", targets},
                                          {"some_detailed", targets.size() < figures.targets.size()},
                                          {"charted", grouped(targets.size())},
                                          {"targets", grouped(figures.targets.size())}}};
}

}  // namespace coupling::report
