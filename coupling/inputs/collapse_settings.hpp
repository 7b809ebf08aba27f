#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/rock_mass/joint_sets.hpp"
#include "rockfall/rock_mass/laws.hpp"

namespace coupling::collapse {

/// How a rock mass is divided into blocks.
enum class BlockKind : std::uint8_t { joints, voronoi };

/// What becomes of blocks that are alone: they stay in the mass, or go on as single ones.
enum class HandOverTo : std::uint8_t { none, single_blocks };

/// The settings of section [collapse].
struct CollapseSettings {
    std::string source;     ///< layer with polygons: the mass below them, or
    std::string mesh;       ///< PLY or STL: closed surface of the mass
    double depth_m = 20.0;  ///< of the mass below the ground, with `source`
    BlockKind blocks = BlockKind::joints;
    std::string joint_sets;     ///< table
    double block_size_m = 3.0;  ///< of Voronoi cells
    double least_block_m = 0.5;
    double density_kgpm3 = 2750.0;
    double tensile_mpa = 36.0;
    double shear_mpa = 26.0;
    double strength_factor = 1.0;
    double persistence = 0.0;       ///< of the faces of Voronoi cells
    double base_persistence = 1.0;  ///< of the border to the rock that stays
    double strength_angle_deg = 0.0;
    double modulus_mpa = 100.0;
    bool disc_areas = false;
    double settle_s = 0.0;  ///< held under its own weight before it is let go
    double duration_s = 30.0;
    double frame_s = 0.5;
    std::vector<double> picture_times_s;  ///< of side views and maps; none: five over the whole time
    bool series_of_all = false;           ///< every block in block_series.csv, not only chosen ones
    HandOverTo hand_over = HandOverTo::none;
    double hand_over_after_s = 1.0;  ///< how long a block has been alone before
    rockfall::rock_mass::Laws laws;  ///< what the above leaves
};

/// A scenario of a collapse: settings of terrain, trees, targets and output as everywhere, and its own.
struct CollapseScenario {
    Scenario scenario;
    CollapseSettings settings;

    /// The laws with everything that users write in other units.
    [[nodiscard]] rockfall::rock_mass::Laws laws() const;
};

void declare(config::Options& options, CollapseSettings& settings);

/// Whether a scenario file has a section [collapse]; false for a file that cannot be read.
bool is_collapse(const std::filesystem::path& file);

/// Reads a scenario file and `section.key=value` overrides. Throws InputError as read_scenario does.
std::unique_ptr<CollapseScenario> read_collapse(const std::filesystem::path& file,
                                                const std::vector<std::string>& overrides,
                                                const std::filesystem::path& inputs_within = {});

/// A row of collapse.joint_sets.
struct JointSetRow : rockfall::rock_mass::JointSet {
    std::optional<double> tensile_mpa;
    std::optional<double> shear_mpa;
};

const config::Schema<JointSetRow>& joint_set_columns();

/// Joint sets of a table. Throws InputError (data) with up to 20 problems.
std::vector<rockfall::rock_mass::JointSet> joint_sets_of(const config::Table& table,
                                                         const CollapseSettings& settings);

}  // namespace coupling::collapse
