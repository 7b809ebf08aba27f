#pragma once

#include <optional>
#include <span>
#include <string>

#include "config/table/declared.hpp"
#include "coupling/inputs/observed/observed_events.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling {

struct ObservedPassageRow;
struct ObservedImpactRow;
struct ObservedScarRow;
struct ObservedTreeRow;
struct ObservedOutlineRow;
struct SearchedAreaRow;
const config::Schema<ObservedPassageRow>& observed_passage_columns();
const config::Schema<ObservedImpactRow>& observed_impact_columns();
const config::Schema<ObservedScarRow>& observed_scar_columns();
const config::Schema<ObservedTreeRow>& observed_tree_columns();
const config::Schema<ObservedOutlineRow>& observed_outline_columns();
const config::Schema<SearchedAreaRow>& searched_area_columns();

/// The tables observed.passages, observed.impacts, observed.scars, observed.trees and observed.outline, and
/// calibrate.window. Empty without these settings. Refuses targets that the run does not have, rows in which
/// nothing was measured, and impacts of a track at one place.
std::optional<ObservedEvents> read_observed_events(std::span<const rockfall::Target> targets,
                                                   Reading& reading);

/// Lets the passages point to `kept`, what is left of the targets `given` on the terrain, both by id. Refuses
/// passages at a target that was left out.
void keep_targets(ObservedEvents& events, std::span<const std::string> given,
                  std::span<const std::string> kept, Reading& reading);

/// Refuses grounds of impacts that the run does not have.
void check_observed_grounds(const ObservedEvents& events, std::span<const rockfall::SurfaceType> types,
                            Reading& reading);

}  // namespace coupling
