#include "coupling/assessments/collapse/collapse_run.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <memory>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/assessments/collapse/building_damage.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/assessments/collapse/handed_departures.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/disk/byte_archive.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/progress.hpp"
#include "coupling/run/settings_hash.hpp"
#include "coupling/run/thread_team.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using rockfall::rock_mass::RockMass;

/// Blocks are looked at for maps and targets about so often.
constexpr double look_s = 0.05;
/// A held mass rests once its forces are out of balance by less of its weight [-] [choice].
constexpr double most_unbalanced = 0.01;
/// A state is kept on disk after the first frame, and then about so often.
constexpr double keep_s = 20.0;
/// Time of a step by block on one thread, measured on the example collapse-small [s]; within a factor of
/// three.
constexpr double seconds_per_block_step = 7e-6;

rockfall::rock_mass::ParallelFor on_threads(int threads) {
    if (threads <= 1) {
        return rockfall::rock_mass::one_by_one;
    }
    const auto team = std::make_shared<ThreadTeam>(threads);
    return [team](std::size_t count, const std::function<void(std::size_t)>& work) {
        team->for_each(count, work);
    };
}

/// Threads that share a mass with gain, of those there are. They meet several times a step; those without
/// work sleep (ThreadTeam), so that more of them cost little more CPU time than one, also on busy cores.
int worthwhile_threads(const CollapseSite& site, int threads) {
    constexpr std::size_t blocks_of_a_thread = 500;  // [choice]
    return std::clamp(static_cast<int>(site.count.free / blocks_of_a_thread), 1, std::max(threads, 1));
}

/// How the time of a run is divided: steps of a guard, guards of a look, looks of a frame, frames.
struct TimePlan {
    std::uint64_t steps_of_look;
    GuardPlan guards;  ///< with steps_of_look together
    std::uint64_t looks_of_frame;
    std::uint64_t frames;
    std::uint64_t steps_to_settle;
    [[nodiscard]] std::uint64_t steps() const { return steps_of_look * looks_of_frame * frames; }
};

TimePlan plan_of(const CollapseSettings& settings, const RockMass& mass) {
    const double step_s = mass.step_s();
    const auto whole = [](double value) {
        return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(value + 0.5));
    };
    TimePlan plan{};
    const std::uint64_t steps_of_look = whole(std::min(look_s, settings.frame_s) / step_s);
    plan.guards =
        settings.hand_over == HandOverTo::none ? GuardPlan{1, steps_of_look} : guards_for(steps_of_look);
    plan.steps_of_look = plan.guards.steps();
    const double look = static_cast<double>(plan.steps_of_look) * step_s;
    plan.looks_of_frame = whole(settings.frame_s / look);
    plan.frames =
        whole(std::ceil(settings.duration_s / (static_cast<double>(plan.looks_of_frame) * look) - 1e-9));
    plan.steps_to_settle =
        settings.settle_s > 0.0 ? whole(std::ceil(settings.settle_s / mass.step_when_held_s() - 1e-9)) : 0;
    return plan;
}

RockMass mass_of(const CollapseScenario& scenario, const CollapseSite& site, int threads) {
    return {scenario.laws(), site.blocks, site.bonds, site.ground, site.stems, on_threads(threads)};
}

/// A mass on its way, with what is kept of it.
class MovingMass {
public:
    MovingMass(const CollapseScenario& scenario, const CollapseSite& site, int threads)
        : site_{site},
          mass_{mass_of(scenario, site, threads)},
          record_{site},
          plan_{plan_of(scenario.settings, mass_)},
          hand_over_{scenario, site, static_cast<double>(plan_.guards.steps_of_guard) * mass_.step_s(),
                     plan_.guards.guards, on_threads(threads)} {
        if (scenario.settings.hand_over != HandOverTo::none) {
            mass_.watch_lone_blocks();
        }
    }

    [[nodiscard]] const RockMass& mass() const { return mass_; }
    [[nodiscard]] const CollapseRecord& record() const { return record_; }
    [[nodiscard]] const HandOver& hand_over() const { return hand_over_; }

    /// Brings the mass to rest under its weight, or holds it for as long as the settings say. An interruption
    /// leaves no state: the run begins again.
    template <class AfterLook>
    void settle(const AfterLook& after_look) {
        if (plan_.steps_to_settle == 0) {
            return;
        }
        mass_.hold();
        for (std::uint64_t left = plan_.steps_to_settle; left > 0;) {
            const std::uint64_t steps = std::min(left, plan_.steps_of_look);
            mass_.advance(steps);
            left -= steps;
            after_look(steps);
            if (mass_.unbalanced_share() < most_unbalanced) {
                break;
            }
        }
        mass_.let_go();
    }

    void add_frame() { record_.add_frame(site_, mass_, hand_over_); }

    /// Whether the time is over or all blocks are at rest.
    [[nodiscard]] bool is_over() const { return record_.rows.size() > plan_.frames || is_at_rest(); }

    template <class AfterLook>
    void next_frame(const AfterLook& after_look) {
        for (std::uint64_t look = 0; look < plan_.looks_of_frame; ++look) {
            for (std::uint64_t guard = 0; guard < plan_.guards.guards; ++guard) {
                mass_.advance(plan_.guards.steps_of_guard);
                hand_over_.guard(mass_);
            }
            hand_over_.look(mass_);
            record_.observe(site_, mass_, hand_over_);
            after_look(plan_.steps_of_look);
        }
        // States that are kept begin with a new search for pairs, in runs without a stop too.
        mass_.refresh();
        add_frame();
    }

    /// Steps in all, those that settle included.
    [[nodiscard]] std::uint64_t all_steps() const { return plan_.steps() + plan_.steps_to_settle; }

    /// Goes on from a kept state where there is one. Throws config::InputError for one that does not fit.
    void begin(const OutputFolder& folder, bool quiet) {
        const std::filesystem::path file = state_file(folder);
        if (folder.has_parts() && std::filesystem::exists(file)) {
            ByteReader in{file};
            in.check_whole();
            const std::vector<double> of_mass = in.list<double>();
            const std::vector<double> of_record = in.list<double>();
            const std::vector<double> of_hand_over = in.list<double>();
            in.check_end();
            if (!mass_.unpack(of_mass) || !record_.unpack(of_record) ||
                !hand_over_.unpack(of_hand_over, mass_)) {
                config::fail(config::ExitCode::file, {file.string()}, "a state of another rock mass",
                             joined("the state of this one; ", own_part_remedy));
            }
            return;
        }
        Progress progress{"settling steps", plan_.steps_to_settle, 0, quiet || plan_.steps_to_settle == 0};
        settle([&](std::uint64_t steps) {
            progress.add(steps);
            if (InterruptGuard::requested()) {
                throw Interrupted{};
            }
        });
        progress.finish();
        add_frame();
    }

    /// Throws Interrupted once the last state is on the disk.
    void go_on(const OutputFolder& folder, const std::string& hash, bool quiet) {
        Progress progress{"steps", plan_.steps(), mass_.steps(), quiet};
        auto kept = std::chrono::steady_clock::now();
        bool is_first = true;
        while (!is_over()) {
            next_frame([&](std::uint64_t steps) {
                progress.add(steps);
                if (InterruptGuard::requested()) {
                    keep_last(folder, hash);
                    throw Interrupted{};
                }
            });
            last_mass_ = mass_.packed();
            last_record_ = record_.packed();
            last_hand_over_ = hand_over_.packed();
            const std::chrono::duration<double> since = std::chrono::steady_clock::now() - kept;
            if (since.count() > keep_s || is_first) {
                is_first = false;
                keep_last(folder, hash);
                kept = std::chrono::steady_clock::now();
            }
        }
        progress.finish();
    }

private:
    static std::filesystem::path state_file(const OutputFolder& folder) {
        return folder.parts() / "mass.part";
    }

    [[nodiscard]] bool is_at_rest() const {
        using rockfall::rock_mass::BlockStatus;
        return hand_over_.is_over(mass_.time_s()) &&
               std::none_of(mass_.blocks().begin(), mass_.blocks().end(),
                            [](const auto& block) { return block.status == BlockStatus::moving; });
    }

    /// Writes the last whole state; nothing where there is none yet.
    void keep_last(const OutputFolder& folder, const std::string& hash) {
        if (last_mass_.empty()) {
            return;
        }
        make_folder(folder.parts());
        write_marker(folder.checkpoint(), hash);
        const std::filesystem::path temporary = temporary_beside(state_file(folder));
        ByteWriter out{temporary};
        out.list(last_mass_);
        out.list(last_record_);
        out.list(last_hand_over_);
        close_and_rename(out, temporary, state_file(folder));
        last_mass_.clear();
    }

    const CollapseSite& site_;
    RockMass mass_;
    CollapseRecord record_;
    TimePlan plan_;
    HandOver hand_over_;
    std::vector<double> last_mass_;
    std::vector<double> last_record_;
    std::vector<double> last_hand_over_;
};

void print_summary(const CollapseResults& results) {
    const KeyFigures figures = key_figures(results);
    std::printf(
        "%zu blocks, %.0f m3: mean speed up to %.1f m/s after %.1f s, largest %.1f m/s, front %.0f m, "
        "area %.0f m2\n",
        results.site.count.free, results.site.count.blocks_m3, figures.peak_mean_speed_mps,
        figures.peak_time_s, figures.largest_speed_mps, figures.front_m, figures.area_m2);
    std::printf("  %zu of %zu bonds broke; residual of the energies at most %.3f %%\n",
                results.site.count.bonds - results.mass.bonds_intact(), results.site.count.bonds,
                100.0 * figures.largest_residual);
    if (results.hands_over()) {
        std::printf("  %zu blocks went on as single ones, %zu times one came back near others; %s\n",
                    results.hand_over.blocks(), results.hand_over.returns(),
                    in_words(departures_of_single_blocks(results.hand_over, results.site), "as single blocks")
                        .c_str());
    }
}

/// A run that ends while much of the mass moves has no final figures.
void warn_of_motion_at_end(const MovingMass& run, const CollapseSite& site, config::Warnings& warnings) {
    const FrameRow& last = run.record().rows.back();
    const double share = last.moving_m3 / site.count.blocks_m3;
    if (share > most_moving_share) {
        warnings.add(joined("after ", config::to_text(std::round(10.0 * last.time_s) / 10.0), " s ",
                            config::to_text(std::round(1000.0 * share) / 10.0),
                            " % of the volume still moves faster than 0.5 m/s: front, area and deposit are "
                            "not final; a larger collapse.duration_s lets the blocks come to rest"));
    }
}

class CollapseRun : public RunSteps {
public:
    CollapseRun(const RunRequest& request, const CollapseScenario& scenario, const CollapseSite& site,
                config::Warnings& warnings, std::string hash)
        : quiet_{request.quiet},
          scenario_{scenario},
          site_{site},
          warnings_{warnings},
          hash_{std::move(hash)},
          mass_{scenario, site,
                request.threads > 0 ? request.threads : worthwhile_threads(site, omp_get_max_threads())} {}

    void simulate(const OutputFolder* folder) override {
        mass_.begin(*folder, quiet_);
        mass_.go_on(*folder, hash_, quiet_);
    }

    std::vector<WrittenFile> write(const std::filesystem::path& folder, const WriteWatch& watch) override {
        warn_of_motion_at_end(mass_, site_, warnings_);
        warn_of_departures(departures_of_single_blocks(mass_.hand_over(), site_), warnings_);
        return write_results(results(), folder, watch);
    }

    void print_figures() const override { print_summary(results()); }

    [[nodiscard]] std::string after_interruption(const std::filesystem::path& out) const override {
        return is_there(OutputFolder::checkpoint_of(OutputFolder::parts_of(out)))
                   ? "run the same command again to go on from the last state that was kept"
                   : "no frame was finished, nothing is kept";
    }

private:
    [[nodiscard]] CollapseResults results() const {
        return {scenario_,         site_,     mass_.record(),   mass_.mass(),
                mass_.hand_over(), warnings_, config::version()};
    }

    bool quiet_;
    const CollapseScenario& scenario_;
    const CollapseSite& site_;
    config::Warnings& warnings_;
    std::string hash_;
    MovingMass mass_;
};

}  // namespace

int run_collapse(const RunRequest& request) {
    const auto scenario = read_collapse(request.scenario, request.overrides, request.inputs_within);
    config::Warnings warnings;
    const CollapseSite site = open_collapse(*scenario, warnings);
    RankGroup alone{RankGroup::Alone{}};
    return between_warnings(
        request, warnings, alone,
        [&] {
            const std::string hash = settings_hash(scenario->scenario, site.inputs);
            CollapseRun run{request, *scenario, site, warnings, hash};
            return complete_run(
                run, {request, scenario->scenario, output_folder_of(request, scenario->scenario), hash},
                alone);
        },
        scenario->scenario.names.get());
}

SimulatedCollapse simulate_collapse(const CollapseScenario& scenario, const CollapseSite& site, int threads,
                                    const std::function<void(double)>& share_done) {
    MovingMass run{scenario, site, worthwhile_threads(site, threads)};
    std::uint64_t done = 0;
    const auto after_look = [&](std::uint64_t steps) {
        done += steps;
        share_done(static_cast<double>(done) / static_cast<double>(run.all_steps()));
    };
    run.settle(after_look);
    run.add_frame();
    while (!run.is_over()) {
        run.next_frame(after_look);
    }
    const config::Warnings none;
    const CollapseResults results{scenario,        site, run.record(),     run.mass(),
                                  run.hand_over(), none, config::version()};
    double floor_m2 = 0.0;
    for (const BuildingDamage& damage : building_damage(results)) {
        floor_m2 += damage.reached_m2;
    }
    return {key_figures(results), run.record().rows, run.mass().step_s(), floor_m2};
}

void describe(const CollapseScenario& scenario, int threads, config::Warnings& warnings, std::ostream& out) {
    const CollapseSite site = open_collapse(scenario, warnings);
    const RockMass mass = mass_of(scenario, site, 1);
    const TimePlan plan = plan_of(scenario.settings, mass);
    const auto say = [&](const std::string& name, const std::string& text) {
        out << std::left << std::setw(14) << name << text << '\n';
    };
    const auto whole = [](double value) {
        return std::to_string(static_cast<std::uint64_t>(std::llround(value)));
    };
    say("scenario", scenario.scenario.file.string());
    for (const InputFile& input : site.inputs) {
        say(input.role, joined(input.name, ", ", std::to_string(input.bytes), " bytes, hash ", input.hash));
    }
    out << '\n';
    say("rock mass", joined(whole(site.count.body_m3), " m3 in ", std::to_string(site.count.free),
                            " blocks; ", std::to_string(site.count.merged), " slivers merged, ",
                            whole(site.count.left_out_m3), " m3 left out"));
    say("around it", joined(std::to_string(site.count.fixed), " blocks of rock that stays"));
    say("bonds", joined(std::to_string(site.count.bonds), " and ", std::to_string(site.count.open_faces),
                        " open faces"));
    if (const auto scaled = mass.scaled_mass(); scaled.blocks > 0) {
        say("mass added",
            joined("to the ", std::to_string(scaled.blocks), " thinnest blocks, up to ",
                   config::to_text(std::round(100.0 * scaled.largest_factor) / 100.0), " times their own, ",
                   config::to_text(std::round(1e5 * scaled.added_share) / 1e3), " % of the whole"));
    }
    say("steps", joined(std::to_string(plan.steps()),
                        plan.steps_to_settle > 0
                            ? joined(" after ", std::to_string(plan.steps_to_settle), " that settle the mass")
                            : "",
                        ", ", whole(mass.step_s() * 1e6), " us each"));
    const double frame_bytes = static_cast<double>(plan.frames + 1) * static_cast<double>(site.count.free) *
                               (sizeof(BlockPlace) + 8.0 * sizeof(double));
    const double bytes = 2.0 * static_cast<double>(mass.bytes()) + frame_bytes +
                         static_cast<double>(site.map_frame.size()) * 6.0 * sizeof(double);
    say("memory", joined("about ", whole(bytes / 1e6 + 20.0), " MB"));
    const int shared_by = threads > 0 ? threads : worthwhile_threads(site, omp_get_max_threads());
    const double seconds = static_cast<double>(plan.steps() + plan.steps_to_settle) *
                           static_cast<double>(site.count.free + site.count.fixed / 4) *
                           seconds_per_block_step / std::min(shared_by, 4);
    say("time", joined("about ", seconds < 90.0 ? whole(seconds + 1.0) : whole(seconds / 60.0),
                       seconds < 90.0 ? " s" : " min", " on ", std::to_string(shared_by),
                       shared_by == 1 ? " thread" : " threads", ", within a factor of 3"));
}

}  // namespace coupling::collapse
