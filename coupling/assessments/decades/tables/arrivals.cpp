#include "coupling/assessments/decades/tables/arrivals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace coupling::decades {
namespace {

std::vector<const TargetRow*> rows_of(const Names& names, std::span<const MemberYears> members,
                                      std::size_t course, std::uint32_t target, std::int32_t year) {
    std::vector<const TargetRow*> rows;
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) != course) {
            continue;
        }
        for (const TargetRow& row : member.targets) {
            if (row.target == target && row.year == year) {
                rows.push_back(&row);
            }
        }
    }
    return rows;
}

PairedCounts sum_of(const std::vector<const TargetRow*>& rows) {
    PairedCounts sum;
    for (const TargetRow* row : rows) {
        sum.both += row->paired.both;
        sum.only_forest += row->paired.only_forest;
        sum.only_bare += row->paired.only_bare;
    }
    return sum;
}

/// A share of the rocks of all replicates together.
template <class Pick>
Share pooled(const std::vector<const TargetRow*>& rows, const Pick& pick) {
    std::uint64_t part = 0;
    std::uint64_t whole = 0;
    for (const TargetRow* row : rows) {
        part += pick(*row).part;
        whole += pick(*row).whole;
    }
    return share_of(part, whole);
}

double mean_of_known(const std::vector<const TargetRow*>& rows, ArrivalFigures TargetRow::*slope,
                     double Distribution::*figure) {
    double sum = 0.0;
    double count = 0.0;
    for (const TargetRow* row : rows) {
        const double value = (row->*slope).energy_kj.*figure;
        if (!std::isnan(value)) {
            sum += value;
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// That of a single replicate; of several the range of their values.
Interval p95_interval_over(const std::vector<const TargetRow*>& rows, ArrivalFigures TargetRow::*slope) {
    if (rows.size() == 1) {
        return (rows.front()->*slope).energy_kj.p95_interval;
    }
    Interval range{std::numeric_limits<double>::infinity(), 0.0};
    for (const TargetRow* row : rows) {
        const double p95 = (row->*slope).energy_kj.p95;
        if (!std::isnan(p95)) {
            range = {std::min(range.low, p95), std::max(range.high, p95)};
        }
    }
    return range.low <= range.high ? range : Distribution{}.p95_interval;
}

ArrivalFigures over_rows(const std::vector<const TargetRow*>& rows, ArrivalFigures TargetRow::*slope) {
    ArrivalFigures figures;
    figures.share = pooled(rows, [&](const TargetRow& row) { return (row.*slope).share; });
    for (std::size_t i = 0; i < figures.above.size(); ++i) {
        figures.above[i] = pooled(rows, [&](const TargetRow& row) { return (row.*slope).above[i]; });
    }
    figures.energy_kj.mean = mean_of_known(rows, slope, &Distribution::mean);
    figures.energy_kj.p95 = mean_of_known(rows, slope, &Distribution::p95);
    figures.energy_kj.p95_interval = p95_interval_over(rows, slope);
    return figures;
}

}  // namespace

PairedCounts arrivals_of(const Names& names, std::span<const MemberYears> members, std::size_t course,
                         std::uint32_t target, std::int32_t year) {
    return sum_of(rows_of(names, members, course, target, year));
}

YearAtTarget at_target(const Names& names, std::span<const MemberYears> members, std::size_t course,
                       std::uint32_t target, std::int32_t year) {
    const std::vector<const TargetRow*> rows = rows_of(names, members, course, target, year);
    return {year, sum_of(rows), over_rows(rows, &TargetRow::forest), over_rows(rows, &TargetRow::bare)};
}

}  // namespace coupling::decades
