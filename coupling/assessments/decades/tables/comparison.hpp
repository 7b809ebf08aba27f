#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/band.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "forest/protection/target_profile.hpp"

namespace coupling::decades {

/// A figure of every member and year in which it is known. Courses (Names) see the same rocks and the same
/// chance, so their replicates are pairs.
struct Series {
    std::string quantity;    ///< with its unit, such as "protection_percent"
    std::string target;      ///< id, empty for figures of the forest
    bool low_is_bad = true;  ///< which extreme over the years is shown
    bool has_worst = false;  ///< whether its extreme means anything
    std::vector<std::vector<std::map<std::int32_t, double>>> values;  ///< [course][replicate][year]
    /// Of a ratio what it is a ratio to, such as the rocks that arrive over the bare slope, where `values`
    /// are known; empty: all count the same.
    std::vector<std::vector<std::map<std::int32_t, double>>> weights{};
};

/// Places for a figure of all members.
Series empty_series(const Names& names, std::span<const MemberYears> members, std::string quantity,
                    std::string target, bool low_is_bad);
/// The same for a figure that is a ratio, with its weights.
Series empty_ratio(const Names& names, std::span<const MemberYears> members, std::string quantity,
                   std::string target, bool low_is_bad);
/// Where the figures of a member belong.
std::map<std::int32_t, double>& values_of(Series& series, const Names& names, const MemberYears& member);
/// A ratio of a member in a year with what it is a ratio to. Requires a series of empty_ratio().
void set_ratio(Series& series, const Names& names, const MemberYears& member, std::int32_t year, double value,
               double weight);

/// Protection, reaching rocks and their energy at each target; protection only of years in which enough
/// rocks arrive over the bare slope, all replicates together (few_rocks.hpp); share of the rocks through the
/// forest that each cause ended; basal area, volume, stems and gaps of the forest; wood felled, salvaged,
/// removed and left, and the contribution margin (yearly_work.hpp); with a profile the share of the forest in
/// stands that meet it.
std::vector<Series> series_of(const Names& names, const Site& site, std::span<const MemberYears> members,
                              const std::optional<forest::TargetProfile>& profile);

/// A figure over the replicates of a course in a year.
struct OverReplicates {
    std::size_t replicates = 0;
    Band band;
};
/// Of a ratio the mean is that of all replicates together. Nothing where no replicate knows the figure.
std::optional<OverReplicates> over_replicates(const Series& series, std::size_t course, std::int32_t year);

/// A ratio as what each replicate brings to it (parts_of_ratio): the mean of these values over replicates is
/// the ratio of all together. Other figures as they are.
Series as_parts(const Series& series);

/// What a figure can be, by its name: percents end at 100, and only protection and money fall below 0.
Bounds bounds_of(const Series& series);

/// Mean difference of pairs with its 95 % interval (Student's t). Unknown for fewer than two pairs: NaN.
struct PairedDifference {
    std::size_t pairs = 0;
    double mean = 0.0;
    double low = 0.0;
    double high = 0.0;
    double deviation = 0.0;  ///< standard deviation of the pairs
};
/// Requires at least one difference.
PairedDifference difference_of(const std::vector<double>& differences);
/// Of a ratio the difference of that of all replicates together.
std::optional<PairedDifference> difference(const Series& series, std::size_t course, std::size_t reference,
                                           std::int32_t year);

/// The year in which the mean over replicates is lowest (highest where high is bad); the first of several.
struct Extreme {
    std::int32_t year = 0;
    OverReplicates value;
};
std::optional<Extreme> worst_year(const Series& series, std::size_t course);

/// Years in which any member knows the figure, rising.
std::vector<std::int32_t> years_of(const Series& series);

/// Writes tables/regimes_by_year.csv, regimes_worst_year.csv and, for two regimes and more,
/// regime_differences.csv (each against the first regime in the same climate), for two climates and more
/// climate_differences.csv (each against the first climate under the same regime). Throws config::InputError
/// (file).
std::vector<WrittenFile> write_comparison(const std::filesystem::path& folder, const Names& names,
                                          std::span<const Series> series);
std::vector<TableLayout> comparison_layouts();

}  // namespace coupling::decades
