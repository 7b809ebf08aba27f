#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/ground_columns.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {

struct SurfaceTypeRow;
const config::Schema<SurfaceTypeRow>& surface_type_columns();

/// A row of config/data/surfaces.csv with its rows of stopping.csv.
struct ShippedSurface {
    std::string name;
    rockfall::SurfaceType type;  ///< code 0
};

std::vector<ShippedSurface> shipped_surfaces();
/// The same with what sections `[ground.NAME]` of these settings change. Throws as GroundChanges does.
std::vector<ShippedSurface> shipped_surfaces(const config::Options& settings);

/// The ground types of a scenario; empty where it names none.
///
/// A row of terrain.surface_types takes r_n, r_t, p_stop from its own columns, else from the shipped type in
/// its column `like`. Stopping comes from terrain.stopping where that has the code, else from p_stop, else
/// from the curve of the shipped type. Its soil is named in its column `soil`, else that of the
/// shipped type; where rockfall.motion asks for soils, a row without one is refused. Stopping tables that do
/// not reach over all sizes of `rocks` are doubtful.
std::optional<std::vector<rockfall::SurfaceType>> read_surface_types(const rockfall::DiameterRange& rocks,
                                                                     Reading& reading);

/// The shipped type that terrain.ground names; nothing without that setting. Throws InputError (settings)
/// with the nearest name for an unknown one.
std::optional<rockfall::SurfaceType> uniform_ground(const Reading& reading);

}  // namespace coupling
