#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "rockfall/tally/target.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// The terrain of a finished run, onto which commands bring the layers of users.
struct RunTerrain {
    const rockfall::Terrain& terrain;
    std::string projection{};  ///< well-known text; empty where the run has none
};

/// A table or layer of a user with its shapes.
struct TableOnRun {
    config::Table table;
    bool has_own_shapes;  ///< a GIS wrote them
};

/// Reads a table or layer for a command on a finished run. One in another coordinate system is brought into
/// that of the run, as in a scenario, with a remark. `expected` says what the file should be. Throws
/// config::InputError.
TableOnRun table_on(const RunTerrain& run, const std::filesystem::path& file, const std::string& expected,
                    std::vector<std::string>& remarks);

/// The houses (is_house) among the targets of a finished run, in coordinates of its terrain: where nobody can
/// build. From its GeoPackage; where there is none a remark says that they are not known.
std::vector<rockfall::Target> houses_of_run(const std::filesystem::path& run,
                                            const rockfall::Terrain& terrain,
                                            std::vector<std::string>& remarks);

/// The same with its lines, such as roads.
std::vector<rockfall::Target> houses_and_lines_of_run(const std::filesystem::path& run,
                                                      const rockfall::Terrain& terrain,
                                                      std::vector<std::string>& remarks);

}  // namespace coupling
