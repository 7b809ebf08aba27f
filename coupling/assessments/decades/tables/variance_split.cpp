#include "coupling/assessments/decades/tables/variance_split.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {
namespace {

/// What arrives in each replicate of a course, where rocks arrive over the bare slope at all.
std::vector<PairedCounts> arrivals_by_replicate(const Names& names, std::span<const MemberYears> members,
                                                std::size_t course, std::uint32_t target, std::int32_t year) {
    std::vector<PairedCounts> replicates;
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) != course) {
            continue;
        }
        for (const TargetRow& row : member.targets) {
            if (row.target == target && row.year == year && row.paired.bare() > 0) {
                replicates.push_back(row.paired);
            }
        }
    }
    return replicates;
}

}  // namespace

std::optional<VarianceSplit> variance_split(const Names& names, std::span<const MemberYears> members,
                                            std::size_t course, std::uint32_t target, std::int32_t year) {
    const std::vector<PairedCounts> replicates = arrivals_by_replicate(names, members, course, target, year);
    if (replicates.size() < 2) {
        return std::nullopt;
    }
    const auto n = static_cast<double>(replicates.size());
    constexpr double percent = 100.0;
    double mean = 0.0;
    double bare = 0.0;
    double forest = 0.0;
    double changed = 0.0;
    double inverse = 0.0;
    for (const PairedCounts& counts : replicates) {
        const auto here = static_cast<double>(counts.bare());
        mean += percent * (1.0 - static_cast<double>(counts.forest()) / here) / n;
        bare += here;
        forest += static_cast<double>(counts.forest());
        changed += static_cast<double>(counts.only_bare + counts.only_forest);
        inverse += 1.0 / here / n;
    }
    VarianceSplit split{.replicates = replicates.size()};
    for (const PairedCounts& counts : replicates) {
        const double value =
            percent * (1.0 - static_cast<double>(counts.forest()) / static_cast<double>(counts.bare()));
        split.between += (value - mean) * (value - mean) / (n - 1.0);
    }
    split.rocks = percent * percent * forest / bare * (changed / bare) * inverse;
    split.forest = std::max(0.0, split.between - split.rocks);
    return split;
}

TableLayout variance_split_layout() {
    constexpr const char* split = "law of total variance over the replicates";
    return {"variance_split.csv",
            "a target in a year with rocks of a regime in a climate: why its replicates differ",
            {{"regime", "text", "name of the regime", "input regimes.list"},
             {"climate", "text", "name of the climate", "input climate.variants"},
             {"year", "-", "simulated years since the start; 0 is the start", "simulated"},
             {"target_id", "text", "target", "input targets.file"},
             {"replicates", "-", "replicates in which rocks arrive over the bare slope", "simulated"},
             {"deviation_percent", "%", "standard deviation of protection between replicates", split},
             {"rocks_deviation_percent", "%",
              "of it what the chance of the rocks leaves within a replicate, as a standard deviation", split},
             {"forest_deviation_percent", "%",
              "the rest (squares add up), at least 0: forests, weather and storms of the replicates", split},
             {"rocks_share_percent", "%",
              "share of the rocks in the variance, at most 100; empty where all replicates are equal. More "
              "rocks a year lower this part, more replicates do not",
              split}}};
}

std::vector<WrittenFile> write_variance_splits(const std::filesystem::path& folder, const Names& names,
                                               const Site& site, std::span<const MemberYears> members) {
    std::set<std::int32_t> years;
    for (const MemberYears& member : members) {
        for (const TargetRow& row : member.targets) {
            years.insert(row.year);
        }
    }
    const auto write_row = [&](TableRows& row, std::size_t course, std::int32_t year, std::uint32_t target) {
        const auto split = variance_split(names, members, course, target, year);
        if (!split) {
            return;
        }
        row.text(names.regimes[names.regime_of(course)]).text(names.climates[names.climate_of(course)]);
        row.whole(static_cast<std::uint32_t>(year)).text(site.targets[target].id).whole(split->replicates);
        row.number<3>(std::sqrt(split->between)).number<3>(std::sqrt(split->rocks));
        row.number<3>(std::sqrt(split->forest));
        split->between > 0.0 ? row.number<1>(std::min(100.0, 100.0 * split->rocks / split->between))
                             : row.empty();
        row.end();
    };
    return {write_table(folder, "variance_split.csv",
                        "How much of the differences between replicates is the chance of their rocks, how "
                        "much that of their forests.",
                        [&](std::ostream& out) {
                            TableRows row{out, variance_split_layout()};
                            for (std::size_t course = 0; course < names.courses(); ++course) {
                                for (const std::int32_t year : years) {
                                    for (std::uint32_t t = 0; t < site.targets.size(); ++t) {
                                        write_row(row, course, year, t);
                                    }
                                }
                            }
                        })};
}

}  // namespace coupling::decades
