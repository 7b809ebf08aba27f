#include <algorithm>
#include <cmath>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"

namespace coupling::hazard {
namespace {

using compare::number;

PeriodArrivals& entry_of(const config::Table& table, std::size_t row, double years, const Site& site,
                         std::vector<PeriodArrivals>& all) {
    const std::string& target_id = table.text(row, "target_id");
    const auto target = static_cast<std::size_t>(
        std::find_if(site.targets.begin(), site.targets.end(),
                     [&](const rockfall::Target& other) { return other.id == target_id; }) -
        site.targets.begin());
    if (target == site.targets.size()) {
        config::fail(config::ExitCode::data, table.place(row, "target_id"), config::in_quotes(target_id),
                     "a target of this scenario");
    }
    const auto known = std::find_if(all.begin(), all.end(), [&](const PeriodArrivals& other) {
        return other.target == target && other.return_period_years == years;
    });
    return known != all.end()
               ? *known
               : all.emplace_back(PeriodArrivals{.target = target, .return_period_years = years});
}

/// How far shares may be off with all that is not known, where parameters were drawn.
void read_intervals(const FinishedPeriod& period, const Site& site, std::vector<PeriodArrivals>& all) {
    if (!compare::has_table(period.folder, "intervals.csv")) {
        return;
    }
    const config::Table intervals = compare::read_table(
        period.folder, "intervals.csv", {"target_id", "cover", "quantity", "all_low", "all_high"});
    for (std::size_t row = 0; row < intervals.rows(); ++row) {
        if (intervals.text(row, "quantity") != "reached") {
            continue;  // others may lie below 0
        }
        const Interval with_all{compare::size(intervals, row, "all_low"),
                                compare::size(intervals, row, "all_high")};
        if (std::isnan(with_all.low) || std::isnan(with_all.high)) {
            continue;
        }
        const bool bare = intervals.text(row, "cover") == name_of(Cover::bare);
        entry_of(intervals, row, period.return_period_years, site, all)
            .with_all_percent[index_of(bare ? Cover::bare : Cover::forest)] = with_all;
    }
}

void read(const FinishedPeriod& period, const Site& site, std::vector<PeriodArrivals>& all) {
    const config::Table targets =
        compare::read_table(period.folder, "targets.csv", {"target_id", "cover", "reached", "share_percent"});
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        PeriodArrivals& entry = entry_of(targets, row, period.return_period_years, site, all);
        const bool bare = targets.text(row, "cover") == name_of(Cover::bare);
        if (bare) {
            entry.bare_rocks = static_cast<std::uint64_t>(number(targets, row, "reached"));
        }
        (bare ? entry.bare_percent : entry.forest_percent) = number(targets, row, "share_percent");
    }
    read_intervals(period, site, all);
    if (!compare::has_table(period.folder, "protection.csv")) {
        return;
    }
    const config::Table protection = compare::read_table(
        period.folder, "protection.csv",
        {"target_id", "protection_percent", "protection_low_percent", "protection_high_percent"});
    for (std::size_t row = 0; row < protection.rows(); ++row) {
        PeriodArrivals& entry = entry_of(protection, row, period.return_period_years, site, all);
        entry.protection_percent = number(protection, row, "protection_percent");
        entry.protection_low_percent = number(protection, row, "protection_low_percent");
        entry.protection_high_percent = number(protection, row, "protection_high_percent");
    }
}

}  // namespace

std::vector<PeriodArrivals> arrivals_of(const std::vector<FinishedPeriod>& periods, const Site& site) {
    std::vector<PeriodArrivals> all;
    if (site.targets.empty()) {
        return all;
    }
    for (const FinishedPeriod& period : periods) {
        read(period, site, all);
        for (PeriodArrivals& entry : all) {
            if (entry.return_period_years == period.return_period_years) {
                entry.hits = period.hits[entry.target];
            }
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const PeriodArrivals& a, const PeriodArrivals& b) { return a.target < b.target; });
    return all;
}

}  // namespace coupling::hazard
