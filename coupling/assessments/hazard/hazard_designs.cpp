#include "coupling/assessments/hazard/hazard_designs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/works/work_page.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/years.hpp"

namespace coupling::hazard {
namespace {

using compare::size;

BarrierDesign design_in(const config::Table& table, std::size_t row, const DesignSettings& settings) {
    BarrierDesign design;
    design.percentile_energy_kj = size(table, row, "percentile_energy_kj");
    design.design_energy_kj = size(table, row, "design_energy_kj");
    design.percentile_height_m = size(table, row, "percentile_height_m");
    design.design_height_m = size(table, row, "design_height_m");
    design.energy_class = table.text(row, "design_class");
    design.capacity_kj = size(table, row, "design_capacity_kj");
    const double sold_m = size(table, row, "sold_height_m");
    constexpr double per_m = 10.0;  // heights that no net on offer has are rounded up to 10 cm
    if (!std::isnan(sold_m)) {
        design.sold_height_m = sold_m;
    }
    design.height_m = design.sold_height_m.value_or(std::ceil(design.design_height_m * per_m) / per_m);
    if (!table.text(row, "upper_class").empty()) {
        add_spread(
            design, Interval{size(table, row, "all_energy_low_kj"), size(table, row, "all_energy_high_kj")},
            Interval{size(table, row, "all_height_low_m"), size(table, row, "all_height_high_m")}, settings);
    }
    return design;
}

std::string words_of(const PeriodDesign& design, const DesignSettings& settings) {
    if (design.reached == 0) {
        return "–";
    }
    if (design.design) {
        return report::join_with_semicolons({in_words(*design.design), upper_in_words(*design.design)});
    }
    return report::page_text(
        "too few rocks: {reached_part} of at least {rocks_to_tell_wanted_share}",
        {{"reached_part", report::grouped(design.reached)},
         {"rocks_to_tell_wanted_share", report::grouped(rocks_to_tell(settings.share()))}});
}

/// What may become of rocks at it: the column of nets.csv or works.csv, and what a page says.
std::vector<std::pair<std::string, std::string>> outcomes_at(const PeriodBarrier& barrier, const Site& site) {
    std::vector<std::pair<std::string, std::string>> outcomes;
    if (barrier.is_net) {
        for (std::size_t i = 0; i < rockfall::net_outcomes; ++i) {
            const auto outcome = static_cast<rockfall::NetOutcome>(i);
            outcomes.emplace_back(name_of(outcome), coupling::in_words(outcome));
        }
        return outcomes;
    }
    for (const auto& [outcome, words] : report::outcomes_in_words(site.works[barrier.number].kind)) {
        outcomes.emplace_back(name_of(outcome), words);
    }
    return outcomes;
}

/// A row of nets.csv or works.csv.
PeriodBarrier barrier_in(const config::Table& table, std::size_t row, bool is_net, const Site& site) {
    const char* column = is_net ? "net" : "work";
    const std::string& name = table.text(row, column);
    const auto number_in = [&](const auto& records, const auto& name_of_record) {
        const auto found = std::find_if(records.begin(), records.end(),
                                        [&](const auto& record) { return name_of_record(record) == name; });
        if (found == records.end()) {
            config::fail(config::ExitCode::data, table.place(row, column), config::in_quotes(name),
                         "a net or work of this scenario");
        }
        return static_cast<std::size_t>(found - records.begin());
    };
    PeriodBarrier barrier;
    barrier.is_net = is_net;
    barrier.number = is_net ? number_in(site.nets, [](const NetRecord& net) { return net.name; })
                            : number_in(site.works, [](const WorkRecord& work) { return work.name; });
    barrier.cover = table.text(row, "cover") == name_of(Cover::bare) ? Cover::bare : Cover::forest;
    barrier.rocks = static_cast<std::uint64_t>(compare::count(table, row, "rocks"));
    barrier.reached = static_cast<std::uint64_t>(compare::count(table, row, "reached"));
    for (const auto& [outcome, words] : outcomes_at(barrier, site)) {
        if (!table.text(row, outcome).empty()) {
            barrier.outcomes[outcome] = static_cast<std::uint64_t>(compare::count(table, row, outcome));
        }
    }
    return barrier;
}

/// "290 (93 %)".
std::string of_all(std::uint64_t rocks, std::uint64_t all) {
    return all == 0
               ? "–"
               : report::page_text(
                     "{rocks} ({share})",
                     {{"rocks", report::grouped(rocks)},
                      {"share", report::percent(static_cast<double>(rocks) / static_cast<double>(all))}});
}

/// The same barrier with the rocks of each return period, as in the results.
std::vector<PeriodBarrier> in_all_periods(const PeriodBarrier& barrier, const HazardResults& results) {
    std::vector<PeriodBarrier> found;
    for (const PeriodBarrier& other : results.barriers) {
        if (other.is_net == barrier.is_net && other.number == barrier.number &&
            other.cover == barrier.cover) {
            found.push_back(other);
        }
    }
    return found;
}

report::PageFields barrier_row(const std::string& words, const std::vector<PeriodBarrier>& periods,
                               const auto& text_of) {
    std::vector<report::PageFields> cells;
    for (const PeriodBarrier& period : periods) {
        cells.push_back({{"count", text_of(period)}});
    }
    return {{"words", words}, {"counts", cells}};
}

/// All that the page says of a barrier on a slope.
report::PageFields barrier_part(const PeriodBarrier& barrier, const HazardResults& results) {
    const std::vector<PeriodBarrier> periods = in_all_periods(barrier, results);
    std::vector<report::PageFields> rows{
        barrier_row(report::page_text("Reach it"), periods,
                    [](const PeriodBarrier& of) { return of_all(of.reached, of.rocks); })};
    for (const auto& [outcome, words] : outcomes_at(barrier, results.site)) {
        rows.push_back(barrier_row(words, periods, [&, column = outcome](const PeriodBarrier& of) {
            const auto found = of.outcomes.find(column);
            return found == of.outcomes.end() ? "–" : of_all(found->second, of.reached);
        }));
    }
    const std::string& name =
        barrier.is_net ? results.site.nets[barrier.number].name : results.site.works[barrier.number].name;
    return {{"barrier_on_slope", report::join_with_commas({name, title_of(barrier.cover)})},
            {"outcome_rows", rows}};
}

}  // namespace

std::vector<PeriodBarrier> barriers_of(std::span<const FinishedPeriod> periods, const Site& site) {
    std::vector<PeriodBarrier> barriers;
    for (const FinishedPeriod& period : periods) {
        for (const bool is_net : {true, false}) {
            const char* file = is_net ? "nets.csv" : "works.csv";
            if (is_net ? site.nets.empty() : site.works.empty()) {
                continue;
            }
            std::vector<std::string> wanted{is_net ? "net" : "work", "cover", "rocks", "reached"};
            for (std::size_t i = 0; i < (is_net ? rockfall::net_outcomes : work_outcomes); ++i) {
                wanted.emplace_back(is_net ? name_of(static_cast<rockfall::NetOutcome>(i))
                                           : name_of(static_cast<WorkOutcome>(i)));
            }
            const config::Table table = compare::read_table(period.folder, file, wanted);
            for (std::size_t row = 0; row < table.rows(); ++row) {
                barriers.push_back(barrier_in(table, row, is_net, site));
                barriers.back().return_period_years = period.return_period_years;
            }
        }
    }
    return barriers;
}

std::optional<report::PageFields> barrier_fields(const HazardResults& results) {
    if (results.barriers.empty()) {
        return std::nullopt;
    }
    std::vector<report::PageFields> parts;
    std::size_t all = 0;
    for (const bool is_net : {true, false}) {
        const std::size_t count = is_net ? results.site.nets.size() : results.site.works.size();
        for (std::size_t number = 0; number < count; ++number) {
            for (const SlopeHazard& slope : results.slopes) {
                all += slope.cover == results.slopes.front().cover ? 1 : 0;
                if (all <= most_rows) {
                    parts.push_back(barrier_part({is_net, number, 0.0, slope.cover, 0, 0, {}}, results));
                }
            }
        }
    }
    return report::PageFields{{"barriers_on_slopes", parts},
                              {"period_columns", std::to_string(results.periods.size() + 1)},
                              {"has_more_barriers", all > most_rows},
                              {"barriers_shown", report::grouped(std::min(most_rows, all))},
                              {"barriers_all", report::grouped(all)}};
}

std::optional<report::PageFields> weak_barrier_fields(const HazardResults& results) {
    constexpr double most_broken = 0.05;  // [choice]
    std::vector<std::string> nets;
    std::set<double> years;
    for (std::size_t number = 0; number < results.site.nets.size(); ++number) {
        const PeriodBarrier* worst = nullptr;
        double share = most_broken;
        for (const PeriodBarrier& barrier : results.barriers) {
            const auto broken = barrier.outcomes.find(name_of(rockfall::NetOutcome::broke));
            if (!barrier.is_net || barrier.number != number || barrier.reached == 0 ||
                broken == barrier.outcomes.end()) {
                continue;
            }
            const double here = static_cast<double>(broken->second) / static_cast<double>(barrier.reached);
            if (here > share) {
                share = here;
                worst = &barrier;
            }
        }
        if (worst != nullptr) {
            nets.push_back(report::page_text(
                "{net}: {share} of the rocks with a return period of {period_years} that reach it, "
                "{words_of_slope}",
                {{"net", results.site.nets[number].name},
                 {"share", report::percent(share)},
                 {"period_years", report::years_in_words(worst->return_period_years)},
                 {"words_of_slope", title_of(worst->cover)}}));
            years.insert(worst->return_period_years);
        }
    }
    if (nets.empty()) {
        return std::nullopt;
    }
    std::vector<report::PageFields> pages;
    for (const FinishedPeriod& period : results.periods) {
        if (years.contains(period.return_period_years)) {
            pages.push_back({{"years", report::years_in_words(period.return_period_years)},
                             {"folder", period.folder.filename().string()}});
        }
    }
    return report::PageFields{{"nets_that_break", report::join_with_semicolons(nets)}, {"pages", pages}};
}

std::string unreached_barriers(const HazardResults& results) {
    std::map<std::pair<bool, std::size_t>, std::uint64_t> reached;
    for (const PeriodBarrier& barrier : results.barriers) {
        reached[{!barrier.is_net, barrier.number}] += barrier.reached;
    }
    std::vector<std::string> names;
    for (const auto& [barrier, rocks] : reached) {
        if (rocks == 0) {
            names.push_back(barrier.first ? results.site.works[barrier.second].name
                                          : results.site.nets[barrier.second].name);
        }
    }
    return report::join_with_commas(names);
}

std::vector<PeriodDesign> designs_of(std::span<const FinishedPeriod> periods, const Site& site,
                                     const DesignSettings& settings) {
    std::vector<PeriodDesign> designs;
    for (const FinishedPeriod& period : periods) {
        if (!compare::has_table(period.folder, "target_design.csv")) {
            continue;
        }
        const config::Table table = compare::read_table(
            period.folder, "target_design.csv",
            {"target_id", "cover", "reached", "percentile_energy_kj", "design_energy_kj",
             "percentile_height_m", "design_height_m", "design_class", "design_capacity_kj", "sold_height_m",
             "all_energy_low_kj", "all_energy_high_kj", "all_height_low_m", "all_height_high_m",
             "upper_class"});
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const std::string& id = table.text(row, "target_id");
            const auto target = std::find_if(site.targets.begin(), site.targets.end(),
                                             [&](const rockfall::Target& other) { return other.id == id; });
            if (target == site.targets.end()) {
                config::fail(config::ExitCode::data, table.place(row, "target_id"), config::in_quotes(id),
                             "a target of this scenario");
            }
            PeriodDesign& design = designs.emplace_back();
            design.target = static_cast<std::size_t>(target - site.targets.begin());
            design.return_period_years = period.return_period_years;
            design.cover = table.text(row, "cover") == name_of(Cover::bare) ? Cover::bare : Cover::forest;
            design.reached = static_cast<std::uint64_t>(compare::count(table, row, "reached"));
            if (!table.text(row, "design_class").empty()) {
                design.design = design_in(table, row, settings);
            }
        }
    }
    return designs;
}

std::optional<report::PageFields> design_fields(const HazardResults& results,
                                                std::span<const std::size_t> targets) {
    if (results.designs.empty()) {
        return std::nullopt;
    }
    const DesignSettings& settings = results.scenario.design;
    std::vector<report::PageFields> rows;
    for (const std::size_t target : targets) {
        for (const SlopeHazard& slope : results.slopes) {
            std::vector<report::PageFields> cells;
            for (const FinishedPeriod& period : results.periods) {
                const auto design = std::find_if(
                    results.designs.begin(), results.designs.end(), [&](const PeriodDesign& one) {
                        return one.target == target && one.cover == slope.cover &&
                               one.return_period_years == period.return_period_years;
                    });
                cells.push_back({{"barrier", design == results.designs.end() ? std::string{"–"}
                                                                             : words_of(*design, settings)}});
            }
            rows.push_back({{"is_first", slope.cover == results.slopes.front().cover},
                            {"target", results.site.targets[target].name},
                            {"slope", title_of(slope.cover)},
                            {"cells", cells}});
        }
    }
    return report::PageFields{{"design_rows", rows}, {"design_rule", design_rule_in_words(settings)}};
}

}  // namespace coupling::hazard
