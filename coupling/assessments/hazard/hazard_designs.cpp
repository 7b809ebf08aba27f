#include "coupling/assessments/hazard/hazard_designs.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/assessments/hazard/hazard_answers.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

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
         {"rocks_to_tell_wanted_share", report::grouped(rocks_to_tell(0.01 * settings.percentile))}});
}

}  // namespace

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
                            {"slope", slope_words(slope.cover)},
                            {"cells", cells}});
        }
    }
    return report::PageFields{{"design_rows", rows}, {"design_rule", design_rule_in_words(settings)}};
}

}  // namespace coupling::hazard
