#pragma once

#include <cstdint>
#include <span>

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// What can be drawn on a site: its grounds, and whether stems or logs lie on it.
DrawnSite drawn_site(const Site& site);

/// What is not known, drawn for the strata of the rocks of today. Where run.parameter_draws is off, the
/// central values: empty without a joint sample.
ParameterDraws draws_on(const Scenario& scenario, const Site& site);

/// Largest distance of any point of a rock from its centre over all starts and draws [m].
double largest_radius_m(const rockfall::StartLaw& common, std::span<const rockfall::ReleaseSource> sources,
                        const ParameterDraws& draws);

/// The draw of a replicate of a run over years; the first one falls by the central values, as all do where
/// run.parameter_draws is off.
ParameterDraws draw_of_replicate_on(const Scenario& scenario, const Site& site, std::uint32_t replicate);

}  // namespace coupling
