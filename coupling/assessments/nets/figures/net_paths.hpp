#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coupling/inputs/scenario/design_settings.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/run/in_order.hpp"
#include "rockfall/draws/strata.hpp"
#include "rockfall/ensemble.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// A flight or a piece on the ground of a stored path, in coordinates of the terrain.
struct StoredPiece {
    std::uint32_t triangle = 0;  ///< under its end
    bool flies = false;
    bool slides = false;  ///< on the ground: without spin
    Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d other = Eigen::Vector3d::Zero();  ///< flight: velocity [m/s]; ground: end [m]
    double first = 0.0;   ///< flight: duration [s]; ground: square of the speed at the start [m2/s2]
    double second = 0.0;  ///< flight: spin [rad/s]; ground: square of the speed at the end
    double rotation_start_j = -1.0;  ///< ground: energy of rotation where a block has its own; else below 0
    double rotation_end_j = -1.0;
};

/// The path of a rock over a slope without nets.
struct StoredPath {
    std::uint64_t rock = 0;
    rockfall::Cover cover = rockfall::Cover::bare;
    rockfall::Rock body;
    std::vector<StoredPiece> pieces;
};

/// What stands before the paths in the file.
struct PathsHead {
    std::string version;                                        ///< of the program
    std::vector<InputFile> inputs;                              ///< of the run
    std::vector<std::pair<std::string, std::string>> settings;  ///< of the run: key and value
    std::uint64_t seed = 0;
    rockfall::Strata strata{};  ///< of the draws of what is not known
    double wanted_share = 0.95;
    DesignSettings design;
    bool with_forest = false;
    std::array<std::uint64_t, rockfall::covers> rocks{};  ///< that fell on each slope
};

/// Lets all rocks of an assessment fall without nets and writes their paths to a file: paths that no net has
/// changed, from which any set of nets can be looked at. Done or interrupted; an interrupted file is not
/// whole.
Ended write_net_paths(const std::filesystem::path& file, const PathsHead& head,
                      const rockfall::Assessment& assessment, int threads);

/// Whether a file can hold this terrain: at least one triangle, finite coordinates, corners and neighbours
/// that there are, and neighbours that know each other.
bool is_whole_terrain(std::span<const rockfall::Vertex> vertices,
                      std::span<const rockfall::Triangle> triangles);
/// Whether settings of [design] are such as a scenario may have.
bool is_whole_design(const DesignSettings& design);
/// Whether a path can lie on a terrain of so many triangles: all of them there, all numbers finite, a rock
/// with size and mass.
bool is_whole_path(const StoredPath& path, std::size_t triangles);

/// Reads the file back, path by path. The whole file is read once for its checksum before anything is built
/// of it. Throws InputError (file) where it is cut off, damaged or none.
class NetPathsReader {
public:
    explicit NetPathsReader(const std::filesystem::path& file);
    NetPathsReader(NetPathsReader&& other) noexcept;
    ~NetPathsReader();
    [[nodiscard]] const PathsHead& head() const { return head_; }
    [[nodiscard]] const rockfall::Terrain& terrain() const { return *terrain_; }
    /// Calls `look` with each path, from the first one on in every call, and makes sure at the end that the
    /// file is whole.
    void each(const std::function<void(const StoredPath&)>& look);

private:
    std::string file_;
    PathsHead head_;
    std::unique_ptr<rockfall::Terrain> terrain_;
};

}  // namespace coupling
