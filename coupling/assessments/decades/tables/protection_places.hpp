#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "forest/stand/patch.hpp"

namespace coupling::decades {

/// From so many rocks on that pass a place without meeting a tree there, it is estimated what its trees are
/// worth [choice].
inline constexpr std::uint32_t least_missed = 20;

/// Share of the rocks stopped by the trees of a place that would arrive if these did not stand there, as the
/// rest of the forest would not stop them: estimated by the share that arrives of the rocks that pass the
/// place and by chance meet no tree in it. Nothing for fewer than least_missed of them.
///
/// Rocks that are stopped are slower than those that pass: it is too high where rocks have just started.
std::optional<double> freed_share(const exchange::PlaceCounts& counts);

/// Where the forest stops the rocks of a target: of one year or of all, of one replicate or of several.
struct TargetBands {
    PairedCounts paired;
    std::vector<exchange::PlaceCounts> bands;  ///< from the target on, each exchange::distance_band_m wide
    std::int64_t without_tree = 0;             ///< `spared` of rocks that met no tree

    void add(const TargetBands& other);
    /// Rocks that the forest keeps from the target, minus those that it makes arrive.
    [[nodiscard]] std::int64_t spared() const;
    /// Of these, those whose last tree stands in some neighbouring bands.
    [[nodiscard]] std::int64_t spared_in(std::size_t first, std::size_t count) const;
    /// Their share, NaN where none is spared.
    [[nodiscard]] double spared_percent(std::size_t first, std::size_t count) const;
    /// Points of protection that would be lost if no tree stood in one of these bands, summed over them; NaN
    /// where it is not known.
    [[nodiscard]] double lost_percent(std::size_t first, std::size_t count) const;
};

/// A figure of all replicates together with its 90 % interval (jackknife over replicates, Student's t); no
/// interval for fewer than three replicates and where all agree.
struct PooledFigure {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
    [[nodiscard]] bool has_interval() const { return low <= high; }
};

/// Replicates of a course together.
class PooledBands {
public:
    explicit PooledBands(std::span<const TargetBands> replicates);
    [[nodiscard]] const TargetBands& pool() const { return pool_; }
    [[nodiscard]] PooledFigure spared_percent(std::size_t first, std::size_t count) const;
    [[nodiscard]] PooledFigure lost_percent(std::size_t first, std::size_t count) const;

private:
    template <class Figure>
    [[nodiscard]] PooledFigure figure(const Figure& figure) const;

    TargetBands pool_;
    std::vector<TargetBands> without_one_;  ///< of three replicates and more: without each in turn
};

/// By target and year with rocks; without a year those of all years together.
using BandsOfCourse = std::map<std::pair<std::uint32_t, std::optional<std::int32_t>>, PooledBands>;
BandsOfCourse bands_of_course(const Names& names, std::span<const MemberYears> members, std::size_t course);

/// By patch, of all years, targets and replicates of a course together, in percent; NaN where nothing is
/// known.
struct PatchProtection {
    config::Raster<float> spared;  ///< share of the spared rocks whose last tree stands there
    /// Points of protection lost if no tree stood on the patch alone; the share freed is that of the patch
    /// and its neighbours.
    config::Raster<float> lost;
};
PatchProtection patch_protection(const Names& names, std::span<const MemberYears> members, std::size_t course,
                                 const forest::PatchGrid& grid);

TableLayout protection_by_distance_layout();

/// Writes tables/protection_by_distance.csv: every course, target, year with rocks (and all together) and
/// band.
std::vector<WrittenFile> write_protection_by_distance(const std::filesystem::path& folder, const Names& names,
                                                      const Site& site, std::span<const MemberYears> members);

}  // namespace coupling::decades
