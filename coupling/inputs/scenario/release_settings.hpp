#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "coupling/inputs/scenario/block_shapes.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// Which law rock sizes follow.
enum class DiameterKind : std::uint8_t { fixed, classes, uniform, lognormal };

/// The settings of section [release].
struct ReleaseSettings {
    std::string source;                     ///< grid: 0 no source, k > 0 release zone k, or
    std::string source_shapes;              ///< CSV with WKT points, lines or polygons, or
    double steeper_than_deg = 0.0;          ///< > 0: only cells steeper than this; alone: all of them
    double undrawn_steeper_than_deg = 0.0;  ///< the same while source_shapes are not drawn yet
    std::uint64_t rocks = 0;                ///< in all; 0: rocks_per_source times the number of sources
    std::uint64_t rocks_per_source = 10;
    DiameterKind diameter_kind = DiameterKind::fixed;
    double diameter_m = 1.0;  ///< fixed, or mean of the log-normal law
    double diameter_deviation_m = 0.0;
    double diameter_low_m = 0.0;
    double diameter_high_m = 0.0;
    std::vector<double> diameter_classes_m;
    std::vector<double> diameter_shares;
    double elongation = rockfall::usual_elongation;  ///< median, of rocks whose shape is not given
    double elongation_scatter = rockfall::usual_elongation_scatter;
    double density_kgpm3 = 2700.0;
    double start_height_m = 1.5;
    double start_speed_mps = 3.0;
    double start_dip_deg = 30.0;
    double start_scatter_deg = 0.0;
    double fall_height_m = 0.0;  ///< > 0: dropped from this height at rest instead
    bool random_place = true;
    ShapeSettings shapes;                                     ///< as written
    std::optional<rockfall::ElongationLaw> shape_elongation;  ///< what they say of it; none: not given
    std::shared_ptr<const rockfall::ShapeLaw> shape_law;      ///< what they say; null: spheres
};

void declare(config::Options& options, ReleaseSettings& release);

/// Diameters of the rocks. The settings must have passed `check`.
rockfall::DiameterLaw diameter_law(const ReleaseSettings& release);

/// Start of the rocks as the rockfall room wants it.
rockfall::StartLaw start_law(const ReleaseSettings& release);

}  // namespace coupling
