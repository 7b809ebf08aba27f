#include "validation/engine/field/field_falls.hpp"

#include <utility>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/events_of_rocks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/run/fall_rocks.hpp"
#include "coupling/run/impacts_of_rocks.hpp"
#include "coupling/run/interrupt.hpp"
#include "rockfall/motion/models.hpp"
#include "validation/engine/case/coverage.hpp"

namespace coupling::validation {

OpenedField open_field(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    std::unique_ptr<Scenario> scenario = read_scenario(file, overrides);
    config::Warnings warnings;  // those of the scenario itself: `bannwald check` prints them
    Site site = open_site(*scenario, warnings);
    const auto& description = rockfall::description_of(scenario->rockfall.fall.motion.model);
    return {std::string{description.name}, std::move(scenario), std::move(site)};
}

FallenField fall_field(const OpenedField& opened, const Work& work, bool first_impacts) {
    const Scenario& scenario = *opened.scenario;
    const Site& site = opened.site;
    const config::GridFrame frame = site.map_frame_on_terrain();
    const rockfall::StartLaw start = start_law(scenario.release);
    const double largest_radius_m = rockfall::largest_radius_m(start, site.sources);
    const rockfall::StemIndex stems{site.stems(), site.slope.terrain, largest_radius_m,
                                    scenario.rockfall.fall.tree.taper};
    const rockfall::LogIndex logs{site.lying_logs(), site.slope.terrain, largest_radius_m,
                                  scenario.rockfall.fall.log.loose_share};
    const rockfall::NetIndex nets{site.standing_nets()};
    rockfall::Assessment assessment{
        site.slope,       stems, site.sources, site.targets, start, scenario.rockfall.fall, frame,
        scenario.run.seed};
    std::vector<rockfall::FallDraw> draw;
    if (work.draw) {
        draw.push_back(draws_for(scenario.rockfall.fall, site.slope.types, scenario.run.seed)[*work.draw]);
        assessment.draws = draw;  // of one draw all rocks are the stratum
    }
    assessment.logs = &logs;
    assessment.nets = &nets;
    const rockfall::Cover cover = assessment.only_bare() ? rockfall::Cover::bare : rockfall::Cover::forest;
    rockfall::EnsembleTally total{frame, site.targets.size(), stems.placed().size(), logs.count()};
    const Eigen::Vector2d origin_m = site.origin_m();
    FallenField fallen;
    fallen.arrived.assign(site.targets.size(), 0);
    std::vector<observed::SimulatedPassage> passages;
    const auto keep = [&](const rockfall::ChunkRows& rows) {
        for (const auto& [rock, target, arrival] : rows.arrivals[static_cast<std::size_t>(cover)]) {
            ++fallen.arrived[target];
            passages.push_back({target, static_cast<double>(arrival.speed_mps),
                                static_cast<double>(arrival.height_m),
                                0.001 * static_cast<double>(arrival.energy_j),
                                0.001 * static_cast<double>(arrival.translational_j)});
        }
        for (const rockfall::RockRecord& rock : rows.rocks[static_cast<std::size_t>(cover)]) {
            fallen.stops.push_back({rock.start_m.head<2>() + origin_m, rock.end_m.head<2>() + origin_m,
                                    site.sources[rock.source].zone,
                                    rock.reason == rockfall::StopReason::left_terrain});
            fallen.ways.push_back({(rock.end_m - rock.start_m).norm(), rock.max_speed_mps});
        }
        work.done(rows.rocks[static_cast<std::size_t>(cover)].size() + rows.not_started);
    };
    if (fall_rocks_over(cover, assessment,
                        rockfall::plan_chunks(site.sources,
                                              rockfall::rocks_of_chunk(scenario.rockfall.fall.motion.model)),
                        work.threads, total, keep) == Ended::interrupted) {
        throw Interrupted{};
    }
    std::vector<observed::SimulatedImpact> impacts;
    if (first_impacts || !site.observed_events.impacts.empty()) {
        const std::vector<rockfall::RockImpacts> of_rocks =
            impacts_of(assessment, observed::rocks_for_impacts(opened.rocks()));
        fallen.first_impacts = first_impacts_of(of_rocks, cover);
        impacts = observed::simulated_impacts(of_rocks, cover);
    }
    fallen.events = observed::compare_events(site, passages, impacts, fallen.stops.size());
    return fallen;
}

}  // namespace coupling::validation
