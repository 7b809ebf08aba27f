#include "coupling/assessments/profile/profile_run.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>

#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/assessments/profile/falls/profile_departures.hpp"
#include "coupling/assessments/profile/profile_results.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/rock_count.hpp"
#include "coupling/inputs/scenario/profile_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/drawn_words.hpp"
#include "coupling/results/figures/fall_doubts.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/report/interval_rows.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/progress.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling::profile {
namespace {

/// Stations as lines across the strip. Rocks end at the ends of the profile: a line there lies a millimetre
/// inside.
std::vector<rockfall::Target> targets_of(const ProfileSite& site) {
    constexpr double inside_m = 1e-3;
    constexpr double half_width_m = 5.0;
    std::vector<rockfall::Target> targets;
    for (const Station& station : site.stations) {
        const double x_m =
            std::clamp(station.distance_m, site.first_m() + inside_m, site.last_m() - inside_m);
        rockfall::Target target;
        target.name = target.id = station.name;
        target.parts = {{Eigen::Vector2d{x_m, -half_width_m}, Eigen::Vector2d{x_m, half_width_m}}};
        targets.push_back(rockfall::with_bounds(target));
    }
    return targets;
}

void print_summary(const ProfileResults& results) {
    const ProfileTally& tally = results.tally;
    std::printf("%s rocks along a profile of %s m; mean run-out %s m", report::grouped(tally.rocks).c_str(),
                report::three_digits(results.site.last_m() - results.site.first_m()).c_str(),
                report::three_digits(tally.run_out_m.mean()).c_str());
    if (tally.run_out_m.count() < tally.rocks) {
        std::printf(" of the %s that stop on it",
                    report::percent(share_of(tally.run_out_m.count(), tally.rocks).value).c_str());
    }
    if (tally.run_out_m.count() > 1) {
        std::printf(", standard deviation %s m", report::three_digits(tally.run_out_m.deviation()).c_str());
    }
    std::printf("\n");
    std::printf("  %s\n", departures_in_words(tally).c_str());
    if (tally.run_out_m.count() < tally.rocks) {
        std::printf("  run-out of all rocks: at least %s m on average\n",
                    report::three_digits(tally.run_out_at_least_m.mean()).c_str());
    }
    const auto words = report::interval_in_words;
    if (results.intervals && results.intervals->run_out_mean_m) {
        const DrawnFigure& mean_m = *results.intervals->run_out_mean_m;
        const std::string causes = main_causes_in_words(mean_m, results.draws);
        std::printf("  mean run-out with what is not known of the ground: %s m%s\n",
                    words(mean_m.of_all, report::three_digits).c_str(),
                    causes.empty() ? "" : (" (mostly by " + causes + ")").c_str());
    }
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        const Moments& energy = tally.stations[i].energy_j.moments;
        const Share share = share_of(energy.count(), tally.rocks);
        std::printf("  %s: %s of the rocks pass (95 %% interval %s)", results.site.stations[i].name.c_str(),
                    report::percent(share.value).c_str(), words(share.interval, report::percent).c_str());
        if (energy.count() > 1) {
            std::printf(", energy %s kJ on average, standard deviation %s kJ",
                        report::three_digits(1e-3 * energy.mean()).c_str(),
                        report::three_digits(1e-3 * energy.deviation()).c_str());
        }
        if (results.intervals && results.intervals->stations[i].share) {
            std::printf("; with what is not known of the ground %s pass",
                        words(results.intervals->stations[i].share->of_all, report::percent).c_str());
            if (const auto& mean_kj = results.intervals->stations[i].energy_mean_kj) {
                std::printf(", mean energy %s kJ", words(mean_kj->of_all, report::three_digits).c_str());
            }
        }
        std::printf("\n");
    }
}

/// Everything that a run holds while its rocks fall. No part of it is kept: it takes seconds.
class ProfileRun : public RunSteps {
public:
    ProfileRun(const RunRequest& request, const Scenario& scenario, const ProfileSite& site,
               config::Warnings& warnings)
        : request_{request},
          scenario_{scenario},
          site_{site},
          warnings_{warnings},
          targets_{targets_of(site)},
          sources_(1),
          draws_{draws_on(scenario, site, rocks_of(scenario))},
          tally_{site, scenario.profile.segment_m, draws_.has_spread() ? draws_.falls.size() : 0},
          assessment_{site.slope,
                      no_stems_,
                      sources_,
                      targets_,
                      start_law(scenario.release),
                      scenario.rockfall.fall,
                      tally_.frame(site),
                      scenario.run.seed} {
        sources_[0].kind = rockfall::ReleaseSource::Kind::line;
        sources_[0].first_m = sources_[0].last_m = {site.start_m, 0.0};
        rockfall::allot(sources_, rocks_of(scenario));
        assessment_.start.along_x_on_flat = true;
        assessment_.draws = draws_.falls;
        if (scenario.output.sample_paths > 0) {
            assessment_.path_every =
                std::max<std::uint64_t>(1, rocks_of(scenario) / scenario.output.sample_paths);
        }
    }

    void simulate(const OutputFolder* folder) override {
        if (!scenario_.output.rock_table) {
            fall(nullptr);
            return;
        }
        streamed_.push_back(rock_table().write(folder->staging(), [&](auto& rows) { fall(&rows); }));
    }

    std::vector<WrittenFile> write(const std::filesystem::path& folder, const WriteWatch& watch) override {
        warn_of_departures(tally_, warnings_);
        warn_of_falls(scenario_.rockfall.fall.motion, fall_figures_of(tally_), warnings_);
        return write_results(results(), folder, streamed_, watch);
    }

    void print_figures() const override { print_summary(results()); }

    [[nodiscard]] std::string after_interruption(const std::filesystem::path&) const override {
        return "nothing is kept; run the same command again";
    }

private:
    [[nodiscard]] ProfileResults results() const {
        return {scenario_, site_, tally_, draws_, intervals_of(tally_, draws_), warnings_, config::version()};
    }

    void fall(TableOf<rockfall::RockRecord>::Rows* rock_rows) {
        Progress progress{"falling", rocks_of(scenario_), 0, request_.quiet};
        const int threads = request_.threads > 0 ? request_.threads : omp_get_max_threads();
        const bool in_flight = assessment_.start.height_m > 0.0;
        std::uint64_t done = 0;
        const auto keep = [&](const WatchedFall& fall) {
            if (fall.started) {
                tally_.add(site_, fall, in_flight,
                           tally_.strata.empty() ? 0 : assessment_.stratum_of(fall.record.rock));
                if (rock_rows != nullptr) {
                    rock_rows->add(fall.record);
                }
            }
            constexpr std::uint64_t rocks_at_once = 256;
            if (++done == rocks_at_once) {
                progress.add(done);
                done = 0;
            }
        };
        if (watch_falls(assessment_, rockfall::Cover::bare, threads, keep) == Ended::interrupted) {
            throw Interrupted{};
        }
        progress.add(done);
        progress.finish();
    }

    const RunRequest& request_;
    const Scenario& scenario_;
    const ProfileSite& site_;
    config::Warnings& warnings_;
    rockfall::StemIndex no_stems_;
    std::vector<rockfall::Target> targets_;
    std::vector<rockfall::ReleaseSource> sources_;
    ParameterDraws draws_;
    ProfileTally tally_;
    rockfall::Assessment assessment_;
    std::vector<WrittenFile> streamed_;
};

}  // namespace

std::uint64_t rocks_of(const Scenario& scenario) {
    return scenario.release.rocks > 0 ? scenario.release.rocks : usual_rocks;
}

void describe(const Scenario& scenario, const ProfileSite& site, std::ostream& out) {
    const auto say = [&](const std::string& name, const std::string& text) {
        out << std::left << std::setw(14) << name << text << '\n';
    };
    const auto metres = [](double value_m) {
        return config::to_text(std::round(100.0 * value_m) / 100.0) + " m";
    };
    say("scenario", scenario.file.string());
    for (const InputFile& input : site.inputs) {
        say(input.role, input.name + ", " + std::to_string(input.bytes) + " bytes, hash " + input.hash);
    }
    out << '\n';
    say("profile", counted(site.corners.size(), "corner") + " from " + metres(site.first_m()) + " to " +
                       metres(site.last_m()) + " in plan, " + metres(site.slope_length_m(site.last_m())) +
                       " along the slope, drop " +
                       metres(site.corners.front().height_m - site.corners.back().height_m));
    std::string ground;
    for (const rockfall::SurfaceType& type : site.slope.types) {
        ground += (ground.empty() ? "" : "; ") + type.label;
    }
    say("ground", ground);
    say("start", metres(site.start_m));
    std::string stations;
    for (const Station& station : site.stations) {
        stations += (stations.empty() ? "" : ", ") + station.name;
    }
    say("stations", stations.empty() ? "none" : stations);
    say("rocks", std::to_string(rocks_of(scenario)) + " in two dimensions: no deviation, no trees");
}

int run_profile(const RunRequest& request, const Scenario& scenario) {
    config::Warnings warnings;
    const ProfileSite site = open_profile(scenario, warnings);
    plausible::warn_of_few_rocks(rocks_of(scenario), warnings);
    ProfileRun run{request, scenario, site, warnings};
    RankGroup alone{RankGroup::Alone{}};
    return between_warnings(
        request, warnings, alone,
        [&] {
            return complete_run(run,
                                {request, scenario, output_folder_of(request, scenario),
                                 settings_hash(scenario, site.inputs)},
                                alone);
        },
        scenario.names.get());
}

}  // namespace coupling::profile
