#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// A rock of a sampled path at a time.
struct PathMoment {
    double time_s = 0.0;
    Eigen::Vector3d place_m = Eigen::Vector3d::Zero();  ///< underside, in coordinates of the terrain
    double displacement_m = 0.0;                        ///< distance from the release
    double speed_mps = 0.0;
    /// Change of the mean velocity between the interval before and the one after, by their length; none at
    /// both ends.
    std::optional<double> acceleration_mps2;
    double kinetic_j = 0.0;
    double released_j = 0.0;  ///< by its height below the release, and what it began with
    /// Taken by ground, trees and nets so far.
    [[nodiscard]] double taken_j() const { return released_j - kinetic_j; }
};

/// Time between the moments of a series [s] [choice]; accelerations are means over it.
inline constexpr double series_step_s = 0.1;

/// At equal times from the release on, and at the end of the path. Between corners straight on; a path of
/// one corner has one moment.
std::vector<PathMoment> series_of(const rockfall::PathRecord& path, double mass_kg,
                                  double step_s = series_step_s);

/// By the diameter and the density of the source that the rock comes from.
double mass_of_rock_kg(const RunResults& results, const rockfall::PathRecord& path);

/// The sampled rocks of a slope at a time. Speed, acceleration and energies are means over those that are
/// under way; displacement counts all, those at their end with that.
struct PathMean {
    rockfall::Cover cover = rockfall::Cover::bare;
    double time_s = 0.0;
    std::uint64_t rocks = 0;  ///< under way
    double displacement_m = 0.0;
    double speed_mps = 0.0;
    std::optional<double> acceleration_mps2;
    double kinetic_j = 0.0;
    double taken_j = 0.0;
};
std::vector<PathMean> means_of_paths(const RunResults& results, rockfall::Cover cover);

/// Why a path is shown by itself.
enum class PathReason : std::uint8_t { fastest, farthest, median, named };
struct SeriesPath {
    const rockfall::PathRecord* path;
    std::vector<PathReason> reasons;
};
/// Of the sampled paths on a slope: the one with the highest speed, the one that ends farthest from its
/// release, and the one in the middle by run-out; then those of output.path_rocks. A path may be several of
/// these.
std::vector<SeriesPath> paths_of_series(const RunResults& results, rockfall::Cover cover);

/// Whether paths are shown over time: those of models whose rocks have a shape.
bool has_path_series(const RunResults& results);

std::vector<TableLayout> path_series_layouts();
/// path_series.csv and path_means.csv; nothing unless `has_path_series`.
void write_path_series(const RunResults& results, const std::filesystem::path& folder,
                       std::vector<WrittenFile>& written);

}  // namespace coupling
