#include "coupling/assessments/decades/tables/protection_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "config/random/quantiles.hpp"
#include "coupling/assessments/decades/tables/member_columns.hpp"

namespace coupling::decades {
namespace {

constexpr double unknown_place = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::optional<double> freed_share(const exchange::PlaceCounts& counts) {
    return counts.missed < least_missed
               ? std::nullopt
               : std::optional{static_cast<double>(counts.missed_arrived) / counts.missed};
}

void TargetBands::add(const TargetBands& other) {
    paired.both += other.paired.both;
    paired.only_forest += other.paired.only_forest;
    paired.only_bare += other.paired.only_bare;
    bands.resize(std::max(bands.size(), other.bands.size()));
    for (std::size_t band = 0; band < other.bands.size(); ++band) {
        bands[band].add(other.bands[band]);
    }
    without_tree += other.without_tree;
}

std::int64_t TargetBands::spared() const {
    return static_cast<std::int64_t>(paired.only_bare) - static_cast<std::int64_t>(paired.only_forest);
}

std::int64_t TargetBands::spared_in(std::size_t first, std::size_t count) const {
    std::int64_t sum = 0;
    for (std::size_t band = first; band < std::min(first + count, bands.size()); ++band) {
        sum += bands[band].spared;
    }
    return sum;
}

double TargetBands::spared_percent(std::size_t first, std::size_t count) const {
    return spared() > 0 ? 100.0 * static_cast<double>(spared_in(first, count)) / static_cast<double>(spared())
                        : unknown_place;
}

double TargetBands::lost_percent(std::size_t first, std::size_t count) const {
    double rocks = 0.0;
    for (std::size_t band = first; band < std::min(first + count, bands.size()); ++band) {
        if (bands[band].spared != 0) {
            rocks += freed_share(bands[band]).value_or(unknown_place) * bands[band].spared;
        }
    }
    return 100.0 * rocks / static_cast<double>(paired.bare());
}

BandsOfCourse bands_of_course(const Names& names, std::span<const MemberYears> members, std::size_t course) {
    std::map<std::pair<std::uint32_t, std::optional<std::int32_t>>, std::vector<TargetBands>> bands;
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) != course) {
            continue;
        }
        std::map<std::pair<std::uint32_t, std::int32_t>, TargetBands> years;
        for (const TargetRow& row : member.targets) {
            years[{row.target, row.year}].paired = row.paired;
        }
        for (const BandRow& row : member.bands) {
            TargetBands& year = years[{row.target, row.year}];
            if (row.band == all) {
                year.without_tree += row.counts.spared;
                continue;
            }
            year.bands.resize(std::max<std::size_t>(year.bands.size(), row.band + 1));
            year.bands[row.band].add(row.counts);
        }
        std::map<std::uint32_t, TargetBands> together;
        for (const auto& [key, year] : years) {
            bands[{key.first, key.second}].push_back(year);
            together[key.first].add(year);
        }
        for (const auto& [target, sum] : together) {
            bands[{target, std::nullopt}].push_back(sum);
        }
    }
    BandsOfCourse pooled;
    for (const auto& [key, replicates] : bands) {
        pooled.emplace(key, replicates);
    }
    return pooled;
}

PooledBands::PooledBands(std::span<const TargetBands> replicates) {
    for (std::size_t left_out = 0; left_out < replicates.size(); ++left_out) {
        pool_.add(replicates[left_out]);
        TargetBands& rest = without_one_.emplace_back();
        for (std::size_t r = 0; r < replicates.size(); ++r) {
            if (r != left_out) {
                rest.add(replicates[r]);
            }
        }
    }
}

template <class Figure>
PooledFigure PooledBands::figure(const Figure& figure) const {
    PooledFigure result{figure(pool_), unknown_place, unknown_place};
    const auto n = static_cast<double>(without_one_.size());
    if (without_one_.size() < 3) {
        return result;
    }
    std::vector<double> values;
    double mean = 0.0;
    for (const TargetBands& rest : without_one_) {
        values.push_back(figure(rest));
        mean += values.back() / n;
    }
    double squares = 0.0;
    for (const double value : values) {
        squares += (value - mean) * (value - mean);
    }
    const double error = std::sqrt((n - 1.0) / n * squares);
    if (error > 1e-9) {
        const double t = config::students_t_quantile(n - 1.0, 0.95);
        result.low = result.value - t * error;
        result.high = result.value + t * error;
    }
    return result;
}

PooledFigure PooledBands::spared_percent(std::size_t first, std::size_t count) const {
    return figure([&](const TargetBands& bands) { return bands.spared_percent(first, count); });
}

PooledFigure PooledBands::lost_percent(std::size_t first, std::size_t count) const {
    return figure([&](const TargetBands& bands) { return bands.lost_percent(first, count); });
}

namespace {

/// The patch and those around it.
std::vector<std::size_t> with_neighbours(const forest::PatchGrid& grid, std::size_t patch) {
    std::vector<std::size_t> patches;
    const config::Cell middle = grid.patches()[patch].cell;
    for (int row = middle.row - 1; row <= middle.row + 1; ++row) {
        for (int column = middle.column - 1; column <= middle.column + 1; ++column) {
            if (const auto there = grid.at(config::Cell{column, row})) {
                patches.push_back(forest::index_of(*there));
            }
        }
    }
    return patches;
}

}  // namespace

PatchProtection patch_protection(const Names& names, std::span<const MemberYears> members, std::size_t course,
                                 const forest::PatchGrid& grid) {
    TargetBands pool;  // its bands are patches
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) == course) {
            TargetBands of_member;
            for (const TargetRow& row : member.targets) {
                of_member.add({row.paired, {}, 0});
            }
            of_member.bands = member.stopping_patches;
            pool.add(of_member);
        }
    }
    const auto nothing = std::numeric_limits<float>::quiet_NaN();
    PatchProtection maps{config::Raster<float>{grid.frame(), nothing},
                         config::Raster<float>{grid.frame(), nothing}};
    for (std::size_t patch = 0; patch < grid.size() && pool.bands.size() > grid.size(); ++patch) {
        const config::Cell cell = grid.patches()[patch].cell;
        if (!pool.bands[patch].empty()) {
            maps.spared.at(cell) = static_cast<float>(pool.spared_percent(patch, 1));
        }
        exchange::PlaceCounts around;
        for (const std::size_t near : with_neighbours(grid, patch)) {
            around.add(pool.bands[near]);
        }
        if (const auto freed = freed_share(around); freed && pool.bands[patch].came > 0) {
            maps.lost.at(cell) = static_cast<float>(100.0 * *freed * pool.bands[patch].spared /
                                                    static_cast<double>(pool.paired.bare()));
        }
    }
    return maps;
}

namespace {

/// A band, or the rocks without a tree.
struct BandOfCourse {
    const Names& names;
    std::size_t course;
    const std::string& target;  ///< its id
    std::optional<std::int32_t> year;
    std::optional<std::size_t> band;
    exchange::PlaceCounts counts;
    std::int64_t spared;
    PooledFigure spared_percent;
    PooledFigure lost_percent;
};

TableOf<BandOfCourse> protection_by_distance() {
    constexpr const char* jackknifed = "jackknife over replicates, Student's t";
    constexpr const char* missed = "estimate from rocks that meet no tree of the band";
    const auto end_of_band = [](std::size_t end) {
        return [end](const BandOfCourse& row) {
            return row.band ? std::optional{exchange::distance_band_m * static_cast<double>(*row.band + end)}
                            : std::nullopt;
        };
    };
    return {
        "protection_by_distance.csv",
        "Where the forest protects: by distance from each target, which rocks it stops and what cutting "
        "would "
        "cost.",
        "a band of 10 m of distance from a target in a year with rocks, or in all of them, of a regime in a "
        "climate, all replicates together",
        {course_columns<BandOfCourse>(),
         {"target_id", "target", "input targets.file", [](const auto& row) { return &row.target; }},
         {"year", "simulated years since the start; all: all years with rocks together",
          [](const auto& row) { return row.year ? std::to_string(*row.year) : std::string{"all"}; }},
         {"distance_from_m", 0,
          "distance on the map from the nearest point of the target; empty: rocks that met no tree",
          end_of_band(0)},
         {"distance_to_m", 0, "farther end of the band", end_of_band(1)},
         {"came", "rocks that arrive over the bare slope and come into the band through the forest",
          from_counting, [](const auto& row) { return row.counts.came; }},
         {"met_tree", "of these, those that meet a tree or log of the band", from_counting,
          [](const auto& row) { return row.counts.met; }},
         {"spared",
          "rocks that the forest keeps from the target whose last tree or log stands in the band, minus "
          "those "
          "that arrive through the forest alone; over all bands: arrivals over the bare slope minus those "
          "through the forest",
          from_counting, [](const auto& row) { return row.spared; }},
         {"spared_percent", 2, "their share in all bands", from_counting,
          [](const auto& row) { return row.spared_percent.value; }},
         {"spared_low_90_percent", 2, "lower end of its 90 % interval; empty for fewer than three replicates",
          jackknifed, [](const auto& row) { return row.spared_percent.low; }},
         {"spared_high_90_percent", 2, "upper end of the same", jackknifed,
          [](const auto& row) { return row.spared_percent.high; }},
         {"lost_if_cut_percent", 2,
          "estimate: points of protection that would be lost if no tree and no log stood in this band alone; "
          "empty where fewer than 20 rocks meet none",
          missed, [](const auto& row) { return row.lost_percent.value; }},
         {"lost_if_cut_low_90_percent", 2, "lower end of its 90 % interval", jackknifed,
          [](const auto& row) { return row.lost_percent.low; }},
         {"lost_if_cut_high_90_percent", 2, "upper end of the same", jackknifed,
          [](const auto& row) { return row.lost_percent.high; }}}};
}

}  // namespace

TableLayout protection_by_distance_layout() {
    return protection_by_distance();
}

std::vector<WrittenFile> write_protection_by_distance(const std::filesystem::path& folder, const Names& names,
                                                      const Site& site,
                                                      std::span<const MemberYears> members) {
    return {protection_by_distance().write(folder, [&](auto& rows) {
        for (std::size_t course = 0; course < names.courses(); ++course) {
            for (const auto& [key, replicates] : bands_of_course(names, members, course)) {
                const TargetBands& pool = replicates.pool();
                const std::string& target = site.targets[key.first].id;
                for (std::size_t band = 0; band < pool.bands.size(); ++band) {
                    if (!pool.bands[band].empty()) {
                        rows.add({names, course, target, key.second, band, pool.bands[band],
                                  pool.bands[band].spared, replicates.spared_percent(band, 1),
                                  replicates.lost_percent(band, 1)});
                    }
                }
                if (pool.without_tree != 0) {
                    const double share = pool.spared() > 0 ? 100.0 * static_cast<double>(pool.without_tree) /
                                                                 static_cast<double>(pool.spared())
                                                           : unknown_place;
                    rows.add({names,
                              course,
                              target,
                              key.second,
                              std::nullopt,
                              {},
                              pool.without_tree,
                              {share, unknown_place, unknown_place},
                              {unknown_place, unknown_place, unknown_place}});
                }
            }
        }
    })};
}

}  // namespace coupling::decades
