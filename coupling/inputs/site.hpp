#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/grid/raster.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/inputs/observed/observed_events.hpp"
#include "coupling/inputs/observed/observed_stop.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/input_file.hpp"
#include "coupling/inputs/works/work_record.hpp"
#include "rockfall/obstacles/log.hpp"
#include "rockfall/obstacles/stem.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling {

struct Scenario;

struct ForestSite;
struct GroundPicture;
struct ParameterKnowledge;

/// The logo that was read with the scenario joins the files of a run.
void add_logo(const Scenario& scenario, std::vector<InputFile>& inputs);

/// A slope with everything on it, read, checked and valid. Without rocks (run.rockfall_every = 0) it has no
/// ground types, sources and targets.
struct Site {
    rockfall::Slope slope;                 ///< the ground that rocks feel
    config::Raster<double> heights;        ///< heights on the map frame for pictures, absolute; NaN: none
    config::Raster<std::uint8_t> surface;  ///< index into slope.types on the map frame; 255: none
    std::string projection;                ///< ESRI text of the .prj file, empty without one
    config::GridFrame map_frame;           ///< of the results, absolute coordinates
    std::vector<TreeRecord> trees;         ///< on the terrain, in file order; none where they grow over years
    std::vector<LogRecord> logs;           ///< on the terrain, in file order
    std::vector<rockfall::ReleaseSource> sources;  ///< allotted, coordinates of the terrain
    std::vector<rockfall::Target> targets;         ///< coordinates of the terrain
    std::vector<NetRecord> nets;                   ///< coordinates of the terrain, in file order
    std::vector<InputFile> inputs;
    std::shared_ptr<const ForestSite> forest;    ///< with run.years > 0
    std::vector<ObservedStop> observed_stops{};  ///< as seen in the field; none without such a file
    ObservedEvents observed_events{};            ///< passages and impacts seen in the field
    std::shared_ptr<const ParameterKnowledge> knowledge{};  ///< of the laws of the fall; null: without rocks
    std::vector<LeftOutFace> left_out_faces{};              ///< of a mesh whose upper faces were kept
    std::shared_ptr<const GroundPicture> picture{};         ///< behind the maps of pages; null: none
    std::vector<WorkRecord> works{};                        ///< coordinates of the terrain, in file order

    /// That fall from all sources.
    [[nodiscard]] std::uint64_t rocks() const {
        return sources.empty() ? 0 : sources.back().first_rock + sources.back().rocks;
    }
    [[nodiscard]] Eigen::Vector2d origin_m() const { return slope.terrain.origin_m(); }
    /// The map frame in coordinates of the terrain.
    [[nodiscard]] config::GridFrame map_frame_on_terrain() const;
    [[nodiscard]] std::vector<rockfall::Stem> stems() const;
    [[nodiscard]] std::vector<rockfall::Log> lying_logs() const;
    /// The nets, then for each work the line that it has in the way of rocks: a wall that holds them, or
    /// the outline at which they are counted.
    [[nodiscard]] std::vector<rockfall::Net> standing_nets() const;
};

/// Opens, reads and checks every file of a scenario. Throws InputError with all problems that can be found at
/// once; what is only doubtful becomes a warning (or an error with strict_inputs).
Site open_site(const Scenario& scenario, config::Warnings& warnings);

}  // namespace coupling
