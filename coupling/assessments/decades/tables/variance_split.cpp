#include "coupling/assessments/decades/tables/variance_split.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/assessments/decades/tables/member_columns.hpp"

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

namespace {

TableOf<TargetOfCourse<VarianceSplit>> splits() {
    constexpr const char* split = "law of total variance over the replicates";
    return {
        "variance_split.csv",
        "How much of the differences between replicates is the chance of their rocks, how much that of their "
        "forests.",
        "a target in a year with rocks of a regime in a climate: why its replicates differ",
        {target_of_course_columns<VarianceSplit>(),

         {"replicates", "replicates in which rocks arrive over the bare slope", &VarianceSplit::replicates},
         {"deviation_percent", 3, "standard deviation of protection between replicates", split,
          [](const auto& s) { return std::sqrt(s.between); }},
         {"rocks_deviation_percent", 3,
          "of it what the chance of the rocks leaves within a replicate, as a standard deviation", split,
          [](const auto& s) { return std::sqrt(s.rocks); }},
         {"forest_deviation_percent", 3,
          "the rest (squares add up), at least 0: forests, weather and storms of the replicates, and what "
          "was drawn of ground and trees",
          split, [](const auto& s) { return std::sqrt(s.forest); }},
         {"rocks_share_percent", 1,
          "share of the rocks in the variance, at most 100; empty where all replicates are equal. More "
          "rocks a year lower this part, more replicates do not",
          split, [](const auto& s) {
              return s.between > 0.0 ? std::optional{std::min(100.0, 100.0 * s.rocks / s.between)}
                                     : std::nullopt;
          }}}};
}

}  // namespace

TableLayout variance_split_layout() {
    return splits();
}

std::vector<WrittenFile> write_variance_splits(const std::filesystem::path& folder, const Names& names,
                                               const Site& site, std::span<const MemberYears> members) {
    return {splits().write(folder, rows_at_targets(names, site, members, variance_split))};
}

}  // namespace coupling::decades
