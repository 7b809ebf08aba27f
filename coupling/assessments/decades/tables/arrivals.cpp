#include "coupling/assessments/decades/tables/arrivals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "config/units/constants.hpp"
#include "rockfall/tally/log_bins.hpp"

namespace coupling::decades {
namespace {

struct TargetYear {
    std::uint32_t target;
    std::int32_t year;
};

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

/// Over the rocks that arrive in all replicates together.
double mean_of_rocks(const std::vector<const TargetRow*>& rows, ArrivalFigures TargetRow::*slope) {
    double sum = 0.0;
    double count = 0.0;
    for (const TargetRow* row : rows) {
        const double value = (row->*slope).energy_kj.mean;
        const auto rocks = static_cast<double>((row->*slope).share.part);
        if (!std::isnan(value)) {
            sum += rocks * value;
            count += rocks;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// Energies of the rocks of all replicates that arrive, one replicate seldom has enough for a percentile.
double p95_of_rocks_kj(const Names& names, std::span<const MemberYears> members, std::size_t course,
                       const TargetYear& at, Cover cover) {
    std::vector<std::uint64_t> counts(rockfall::energy_bins.count());
    for (const MemberYears& member : members) {
        for (const EnergyRow& row : member.energies) {
            if (names.course_of(member.member) == course && row.target == at.target && row.year == at.year &&
                row.cover == static_cast<std::uint32_t>(cover)) {
                counts[row.bin] += row.rocks;
            }
        }
    }
    const std::uint64_t rocks = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    return percentile_is_known(rocks, 95)
               ? rockfall::quantile(rockfall::energy_bins, counts, 0.95) / config::j_per_kj
               : std::numeric_limits<double>::quiet_NaN();
}

/// That of a single replicate; of several the range of their values and that of all together.
Interval p95_interval_over(const std::vector<const TargetRow*>& rows, ArrivalFigures TargetRow::*slope,
                           double p95_kj) {
    if (rows.size() == 1) {
        return (rows.front()->*slope).energy_kj.p95_interval;
    }
    Interval range{p95_kj, p95_kj};
    for (const TargetRow* row : rows) {
        const double p95 = (row->*slope).energy_kj.p95;
        if (!std::isnan(p95)) {
            range = {std::min(range.low, p95), std::max(range.high, p95)};
        }
    }
    return range;
}

ArrivalFigures over_rows(const std::vector<const TargetRow*>& rows, ArrivalFigures TargetRow::*slope,
                         double p95_kj) {
    ArrivalFigures figures;
    figures.share = pooled(rows, [&](const TargetRow& row) { return (row.*slope).share; });
    for (std::size_t i = 0; i < figures.above.size(); ++i) {
        figures.above[i] = pooled(rows, [&](const TargetRow& row) { return (row.*slope).above[i]; });
    }
    figures.energy_kj.mean = mean_of_rocks(rows, slope);
    if (rows.size() == 1) {
        figures.energy_kj.p95 = (rows.front()->*slope).energy_kj.p95;
    } else {
        figures.energy_kj.p95 = p95_kj;
    }
    if (!std::isnan(figures.energy_kj.p95)) {
        figures.energy_kj.p95_interval = p95_interval_over(rows, slope, p95_kj);
    }
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
    const auto of = [&](Cover cover, ArrivalFigures TargetRow::*slope) {
        return over_rows(rows, slope, p95_of_rocks_kj(names, members, course, {target, year}, cover));
    };
    return {year, sum_of(rows), of(Cover::forest, &TargetRow::forest), of(Cover::bare, &TargetRow::bare)};
}

}  // namespace coupling::decades
