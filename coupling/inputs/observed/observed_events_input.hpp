#pragma once

#include <optional>
#include <span>

#include "coupling/inputs/observed/observed_events.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling {

/// The tables observed.passages (`target_id`, and of `speed_mps`, `height_m`, `energy_kj`, `translational_kj`
/// what is known; perhaps `group`) and observed.impacts (`speed_in_mps`, `speed_out_mps`, `angle_in_deg`,
/// `angle_out_deg`; perhaps `ground`, `group`). Empty without these settings. Refuses targets that the run
/// does not have and rows in which nothing was measured.
std::optional<ObservedEvents> read_observed_events(std::span<const rockfall::Target> targets,
                                                   Reading& reading);

/// Refuses grounds of impacts that the run does not have.
void check_observed_grounds(const ObservedEvents& events, std::span<const rockfall::SurfaceType> types,
                            Reading& reading);

}  // namespace coupling
