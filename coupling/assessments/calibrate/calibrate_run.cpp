#include "coupling/assessments/calibrate/calibrate_run.hpp"

#include <cstdio>
#include <memory>
#include <optional>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/calibrate/calibration_results.hpp"
#include "coupling/assessments/calibrate/observation_checks.hpp"
#include "coupling/assessments/calibrate/search/adjustment.hpp"
#include "coupling/assessments/calibrate/search/search_part.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/site_draws.hpp"
#include "coupling/inputs/site_falls.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/progress.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

void refuse_other_runs(const Scenario& scenario) {
    const char* other = scenario.run.years != 0             ? "run.years above 0"
                        : !scenario.terrain.profile.empty() ? "terrain.profile"
                        : wants_hazard_map(scenario)        ? "a hazard map"
                        : !scenario.run.parameter_draws     ? "run.parameter_draws = no"
                                                            : nullptr;
    if (other != nullptr) {
        config::fail(config::ExitCode::settings, {scenario.file.string()}, other,
                     scenario.run.parameter_draws ? "an assessment of today on a map: the rocks of one event"
                                                  : "draws: their widths are what is known before");
    }
}

/// Mean of the places from which rocks of an observation start.
Eigen::Vector2d mean_source(const Site& site, const Observation& observation) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double rocks = 0.0;
    for (const rockfall::ReleaseSource& source : site.sources) {
        if (observation.zones.empty() ||
            std::binary_search(observation.zones.begin(), observation.zones.end(), source.zone)) {
            sum += 0.5 * source.rocks * (source.first_m + source.last_m);
            rocks += source.rocks;
        }
    }
    return rocks > 0.0 ? Eigen::Vector2d{sum / rocks} : sum;
}

/// From the mean source to the mean of what was observed.
SightLine line_of(const Site& site, const Observation& observation) {
    SightLine line;
    if (!observation.is_plane()) {
        return line;
    }
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Sample* sample : {&observation.fit, &observation.held_out}) {
        for (const Eigen::Vector2d& point : sample->points) {
            mean += point;
        }
    }
    mean /= static_cast<double>(observation.fit.size() + observation.held_out.size());
    line.from_m = mean_source(site, observation);
    const Eigen::Vector2d along = mean - line.from_m;
    line.along = along.norm() > 0.0 ? Eigen::Vector2d{along.normalized()} : Eigen::Vector2d{1.0, 0.0};
    return line;
}

std::vector<SightLine> lines_of(const Site& site, const std::vector<Observation>& observations) {
    std::vector<SightLine> lines;
    for (const Observation& observation : observations) {
        lines.push_back(line_of(site, observation));
    }
    return lines;
}

class CalibrationRun : public RunSteps {
public:
    CalibrationRun(const RunRequest& request, const Scenario& scenario, const Site& site,
                   const config::Warnings& warnings, RankGroup& ranks)
        : request_{request},
          scenario_{scenario},
          site_{site},
          warnings_{warnings},
          ranks_{ranks},
          falls_{scenario, site, config::GridFrame{}},
          drawn_{drawn_site(site)},
          space_{components_on(*site.knowledge, drawn_)},
          observations_{observations_on(site, scenario.calibrate, scenario.run.seed)},
          lines_{lines_of(site, observations_)},
          search_{search_on(site, scenario.calibrate)},
          plan_{.first_sets = scenario.calibrate.first_sets,
                .sets = scenario.calibrate.sets,
                .most_sets = scenario.calibrate.most_sets,
                .rocks = scenario.calibrate.rocks},
          simulator_{falls_.assessment,
                     site,
                     space_,
                     observations_,
                     lines_,
                     search_,
                     [this](const std::vector<double>& factors) {
                         return draw_of_sets(*site_.knowledge, drawn_, scenario_.rockfall.fall, {factors})
                             .falls.front();
                     },
                     request.threads > 0 ? request.threads : ranks.usual_threads(),
                     ranks} {
        if (space_.size() == 0) {
            config::fail(config::ExitCode::settings, {scenario.file.string()}, "widths that are all 0",
                         "a parameter that is not known", "see `bannwald info parameter_widths`");
        }
        if (plan_.rocks > most_repeats * site.rocks()) {
            config::fail(config::ExitCode::settings, {scenario.file.string()},
                         joined(std::to_string(site.rocks()), " released rocks for sets of ",
                                std::to_string(plan_.rocks)),
                         "more rocks of the release", "raise release.rocks or lower calibrate.rocks");
        }
    }

    void simulate(const OutputFolder* folder) override {
        const std::filesystem::path part = part_in(request_.out);
        const bool goes_on = folder != nullptr && folder->has_parts() && is_there(part);
        if (ranks_.from_first({goes_on ? 1U : 0U}).front() == 1) {
            state_ = read_search(part);
        }
        ranks_.meet();  // before the first one writes it again
        Progress progress{"parameter sets", plan_.most_sets, state_.tried(), request_.quiet};
        search(
            simulator_, plan_, state_,
            [&](const SearchState& state) {
                if (folder != nullptr) {
                    make_folder(folder->parts());
                    write_search(part, state);
                }
            },
            [&](std::uint64_t sets) { progress.add(sets); });
        progress.finish();
        if (folder == nullptr) {
            return;  // the first rank judges and writes
        }
        adjust(state_.population, simulator_.observed_summary());
        judgement_ = judge(simulator_, state_, plan_.rocks, lines_,
                           figure_names(site_, !falls_.assessment.only_bare()));
    }

    std::vector<WrittenFile> write(const std::filesystem::path& folder, const WriteWatch& watch) override {
        return write_results(calibration(), folder, request_.out, watch);
    }

    void print_figures() const override {
        const std::string reason = reason_against(*judgement_, state_);
        std::printf("%s\n", judgement_->is_calibrated
                                ? "Calibrated: what was fitted to and what was held out agree with the sets."
                                : joined("Not calibrated. ", reason).c_str());
        std::printf("%llu sets tried in %zu rounds, %zu kept\n",
                    static_cast<unsigned long long>(state_.tried()), state_.waves.size(),
                    state_.population.size());
        for (const Learned& learned : judgement_->parameters) {
            std::printf("  %s: factor %.2f (%.2f to %.2f), %.0f %% learned\n",
                        learned.component.parameter.c_str(), learned.median, learned.low, learned.high,
                        100.0 * std::max(0.0, learned.learned));
        }
        std::printf(
            "`bannwald run %s` uses the sets; in another scenario of this site\n"
            "run.parameters = %s\n",
            (request_.out / calibrated_file).string().c_str(),
            std::filesystem::absolute(request_.out / "tables" / sample_file).string().c_str());
    }

    [[nodiscard]] std::string after_interruption(const std::filesystem::path& out) const override {
        return is_there(part_in(out)) ? "the sets tried so far are kept, run the same command again to go on"
                                      : "nothing is kept of work this short";
    }

private:
    static std::filesystem::path part_in(const std::filesystem::path& out) {
        return OutputFolder::parts_of(out) / "search.part";
    }
    [[nodiscard]] Calibration calibration() const {
        return {scenario_, site_, warnings_, space_,      observations_,
                lines_,    plan_, state_,    *judgement_, config::version()};
    }

    const RunRequest& request_;
    const Scenario& scenario_;
    const Site& site_;
    const config::Warnings& warnings_;
    RankGroup& ranks_;
    SiteFalls falls_;
    DrawnSite drawn_;
    Space space_;
    std::vector<Observation> observations_;
    std::vector<SightLine> lines_;
    Search search_;
    SearchPlan plan_;
    Simulator simulator_;
    SearchState state_;
    std::optional<Judgement> judgement_;
};

}  // namespace

int run_calibration(RunRequest request, RankGroup& ranks) {
    const std::unique_ptr<Scenario> scenario = read_scenario(request.scenario, request.overrides);
    refuse_other_runs(*scenario);
    if (request.out.empty()) {
        request.out = request.scenario.parent_path() / "calibration";
    }
    config::Warnings warnings;
    const Site site = open_site(*scenario, warnings);
    if (site.knowledge->sample) {
        config::fail(config::ExitCode::settings, scenario->options->place_of("run.parameters"),
                     "the sample of an earlier calibration", "widths: a sample is a result, not a beginning",
                     "leave run.parameters out, or name a table of widths");
    }
    check_observations(*scenario, site, warnings);
    CalibrationRun run{request, *scenario, site, warnings, ranks};
    return between_warnings(request, warnings, ranks, [&] {
        return complete_run(run, {request, *scenario, request.out, settings_hash(*scenario, site.inputs)},
                            ranks);
    });
}

}  // namespace coupling::calibrate
