#include "coupling/assessments/decades/tables/pooled_reduction.hpp"

#include <cmath>
#include <limits>

#include "config/random/quantiles.hpp"
#include "coupling/assessments/decades/tables/member_columns.hpp"
#include "rockfall/tally/log_bins.hpp"

namespace coupling::decades {
namespace {

constexpr double reduction_not_known = std::numeric_limits<double>::quiet_NaN();

/// Rocks of one replicate, or of several added up.
struct Arrived {
    PairedCounts paired;
    std::array<std::vector<std::uint64_t>, 2> energies{
        // bare, forest
        std::vector<std::uint64_t>(rockfall::energy_bins.count()),
        std::vector<std::uint64_t>(rockfall::energy_bins.count())};

    void add(const Arrived& other) {
        paired.both += other.paired.both;
        paired.only_forest += other.paired.only_forest;
        paired.only_bare += other.paired.only_bare;
        for (std::size_t cover = 0; cover < energies.size(); ++cover) {
            for (std::size_t bin = 0; bin < energies[cover].size(); ++bin) {
                energies[cover][bin] += other.energies[cover][bin];
            }
        }
    }
};

Arrived arrived_of(const MemberYears& member, std::uint32_t target, std::int32_t year) {
    Arrived arrived;
    for (const TargetRow& row : member.targets) {
        if (row.target == target && row.year == year) {
            arrived.paired = row.paired;
        }
    }
    for (const EnergyRow& row : member.energies) {
        if (row.target == target && row.year == year) {
            arrived.energies[row.cover == static_cast<std::uint32_t>(Cover::bare) ? 0 : 1][row.bin] +=
                row.rocks;
        }
    }
    return arrived;
}

double energy_95(const std::vector<std::uint64_t>& counts) {
    std::uint64_t total = 0;
    for (const std::uint64_t count : counts) {
        total += count;
    }
    return percentile_is_known(total, 95) ? rockfall::quantile(rockfall::energy_bins, counts, 0.95)
                                          : reduction_not_known;
}

std::optional<RiskReduction> reduction_of(const Arrived& arrived) {
    return risk_reduction(arrived.paired, energy_95(arrived.energies[1]), energy_95(arrived.energies[0]));
}

/// Interval of ORPI from the values that the pool takes without each replicate in turn (jackknife).
Interval jackknife(const std::vector<Arrived>& replicates, double orpi_percent) {
    const auto n = static_cast<double>(replicates.size());
    std::vector<double> without;
    for (std::size_t left_out = 0; left_out < replicates.size() && replicates.size() > 2; ++left_out) {
        Arrived rest;
        for (std::size_t r = 0; r < replicates.size(); ++r) {
            if (r != left_out) {
                rest.add(replicates[r]);
            }
        }
        const auto reduction = reduction_of(rest);
        without.push_back(reduction ? reduction->orpi_percent : reduction_not_known);
    }
    double mean = 0.0;
    for (const double value : without) {
        mean += value / n;
    }
    double squares = 0.0;
    for (const double value : without) {
        squares += (value - mean) * (value - mean);
    }
    const double error = std::sqrt((n - 1.0) / n * squares);
    if (without.empty() || !(error > 0.0)) {
        return {reduction_not_known, reduction_not_known};
    }
    const double t = config::students_t_quantile(n - 1.0, 0.95);
    return {orpi_percent - t * error, std::min(100.0, orpi_percent + t * error)};
}

}  // namespace

std::optional<PooledReduction> pooled_reduction(const Names& names, std::span<const MemberYears> members,
                                                std::size_t course, std::uint32_t target, std::int32_t year) {
    std::vector<Arrived> replicates;
    Arrived pool;
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) == course) {
            replicates.push_back(arrived_of(member, target, year));
            pool.add(replicates.back());
        }
    }
    const auto reduction = reduction_of(pool);
    if (!reduction) {
        return std::nullopt;
    }
    return PooledReduction{pool.paired.bare(), pool.paired.forest(), *reduction, replicates.size(),
                           jackknife(replicates, reduction->orpi_percent)};
}

namespace {

TableOf<TargetOfCourse<PooledReduction>> reductions() {
    constexpr const char* pooled = "rocks of all replicates together";
    constexpr const char* named_after = "named after Dupire et al. 2016; formulas [choice], coupling/results";
    constexpr const char* jackknifed = "jackknife over replicates, Student's t";
    return {
        "risk_reduction.csv",
        "Reduction of number, energy and risk (ORPI) at each target, rocks of all replicates together.",
        "a target in a year with rocks of a regime in a climate, all replicates together",
        {target_of_course_columns<PooledReduction>(),

         {"replicates", "replicates", pooled, &PooledReduction::replicates},
         {"reached_bare", "rocks that arrive over the bare slope", pooled, &PooledReduction::arrivals_bare},
         {"reached_forest", "rocks that arrive with forest", pooled, &PooledReduction::arrivals_forest},
         {"bari_percent", 2, "reduction of the number of rocks", named_after,
          [](const auto& p) { return p.reduction.bari_percent; }},
         {"miri_percent", 2, "reduction of the 95th percentile of energy; empty where too few arrive",
          named_after, [](const auto& p) { return p.reduction.miri_percent; }},
         {"orpi_percent", 2, "both together", named_after,
          [](const auto& p) { return p.reduction.orpi_percent; }},
         {"orpi_low_90_percent", 2, "lower end of its 90 % interval; empty for fewer than three replicates",
          jackknifed, [](const auto& p) { return p.orpi_90.low; }},
         {"orpi_high_90_percent", 2, "upper end of the same", jackknifed,
          [](const auto& p) { return p.orpi_90.high; }}}};
}

}  // namespace

TableLayout pooled_reduction_layout() {
    return reductions();
}

std::vector<WrittenFile> write_pooled_reductions(const std::filesystem::path& folder, const Names& names,
                                                 const Site& site, std::span<const MemberYears> members) {
    return {reductions().write(folder, rows_at_targets(names, site, members, pooled_reduction))};
}

}  // namespace coupling::decades
