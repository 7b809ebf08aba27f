#pragma once

#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/options/options.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {

/// What settings change of single ground types: `[ground.NAME]`, or `--set ground.NAME.r_t=0.8`. NAME is a
/// shipped type or a code of terrain.surface_types; a shipped type changes for all types that are `like` it
/// and do not say otherwise.
class GroundChanges {
public:
    static void declare(config::Options& options);

    /// None.
    GroundChanges() = default;
    /// Throws InputError (settings) for a value that no ground has, an unknown name of a shipped type, or a
    /// key that is none of r_n, r_t, jump_angle_factor, p_stop, rolling_stops_per_m, rolling_friction,
    /// sliding_friction, or of the figures of blocks with a shape (block_grounds.hpp).
    GroundChanges(const config::Options& options, const std::vector<std::string>& shipped_names);

    /// The type with what is changed of it. A changed coefficient counts as the user's own under the
    /// published laws too.
    void apply(const std::string& name, rockfall::SurfaceType& type) const;

    [[nodiscard]] bool empty() const { return changes_.empty(); }
    /// Where grounds are changed that are none of `names`, one place for each.
    [[nodiscard]] std::vector<config::Place> of_others_than(const std::vector<std::string>& names) const;

private:
    struct Change {
        std::string ground;
        std::string column;
        double value = 0.0;
        config::Place place;
    };
    std::vector<Change> changes_;
};

}  // namespace coupling
