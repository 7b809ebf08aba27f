#include "coupling/assessments/today/assess_today.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <tuple>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/language.hpp"
#include "config/version.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/assessments/today/arrival_breakdown.hpp"
#include "coupling/assessments/today/bound_falls.hpp"
#include "coupling/assessments/today/closing_summary.hpp"
#include "coupling/assessments/today/fallen.hpp"
#include "coupling/assessments/today/observed_events.hpp"
#include "coupling/assessments/today/observed_stops.hpp"
#include "coupling/assessments/today/pieces.hpp"
#include "coupling/assessments/today/unreached_today.hpp"
#include "coupling/assessments/today/write_results.hpp"
#include "coupling/assessments/works/work_figures.hpp"
#include "coupling/inputs/events_of_rocks.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_falls.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/figures/fall_doubts.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/impacts_of_rocks.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/progress.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr const char* joined_folder = "joined";  // of tables that pieces leave together

/// Rising. Throws config::InputError (settings) for a rock that there is not.
std::vector<std::uint64_t> path_rocks_of(const Scenario& scenario, std::uint64_t rocks) {
    std::vector<std::uint64_t> wanted;
    for (const double rock : scenario.output.path_rocks) {
        wanted.push_back(static_cast<std::uint64_t>(rock));
        if (wanted.back() >= rocks) {
            config::fail(config::ExitCode::settings, scenario.options->place_of("output.path_rocks"),
                         joined("rock ", std::to_string(wanted.back())),
                         joined("rocks from 0 to ", std::to_string(rocks - 1)));
        }
    }
    std::sort(wanted.begin(), wanted.end());
    return wanted;
}

constexpr const char* paths_name = "net_paths.bin";

/// Everything that a run holds while its rocks fall.
class AssessmentRun : public RunSteps {
public:
    AssessmentRun(const RunRequest& request, const Scenario& scenario, const Site& site,
                  config::Warnings& warnings, std::filesystem::path out, RankGroup& ranks)
        : request_{request},
          scenario_{scenario},
          site_{site},
          warnings_{warnings},
          parts_{OutputFolder::parts_of(out)},
          ranks_{ranks},
          frame_{site.map_frame_on_terrain()},
          rocks_{site.rocks()},
          path_rocks_{path_rocks_of(scenario, rocks_)},
          falls_{scenario, site, frame_},
          falling_{scenario, site, falls_, settings_hash(scenario, site.inputs),
                   request.threads > 0 ? request.threads : ranks.usual_threads()},
          all_{falling_.none()} {
        falls_.assessment.path_rocks = path_rocks_;
        falls_.assessment.repeats = static_cast<std::uint32_t>(scenario.output.repeats);
        falls_.assessment.spread = scenario.output.spread_maps && falls_.draws.has_spread();
        if (!scenario.hazard.blocks.empty()) {
            release_weights_ = rockfall::release_weights(site.sources);
            falls_.assessment.release_weights = release_weights_;
            falls_.assessment.release_reach =
                rockfall::reach_of_width(scenario.hazard.counted_width_m(), frame_);
        }
        if (scenario.output.sample_paths > 0) {
            falls_.assessment.path_every = std::max<std::uint64_t>(1, rocks_ / scenario.output.sample_paths);
        }
    }

    void simulate(const OutputFolder* folder) override;
    std::vector<WrittenFile> write(const std::filesystem::path& folder, const WriteWatch& watch) override;
    void print_figures() const override { print_summary(*results_); }
    [[nodiscard]] std::string after_interruption(const std::filesystem::path& out) const override {
        return is_there(OutputFolder::checkpoint_of(OutputFolder::parts_of(out)))
                   ? "the rocks fallen so far are kept, run the same command again to go on"
                   : "nothing is kept of work this short";
    }

private:
    [[nodiscard]] Departures departures_on(rockfall::Cover cover) const {
        const rockfall::RunTally& run = all_.total.runs[static_cast<std::size_t>(cover)];
        return departures_of(run.rocks, run.left_over, site_.slope.terrain);
    }
    [[nodiscard]] std::uint32_t pieces(const OutputFolder* folder);
    void fall_in_pieces(std::span<const rockfall::Chunk> chunks, std::uint32_t count,
                        const OutputFolder* folder);
    void keep_paths(const std::filesystem::path& file);
    [[nodiscard]] std::vector<rockfall::RockImpacts> kept_impacts() const;
    [[nodiscard]] std::vector<observed::EventComparison> observed_events(
        const StreamedTables& streamed) const;

    const RunRequest& request_;
    const Scenario& scenario_;
    const Site& site_;
    config::Warnings& warnings_;
    std::filesystem::path parts_;
    RankGroup& ranks_;
    config::GridFrame frame_;
    std::uint64_t rocks_;
    std::vector<std::uint64_t> path_rocks_;
    std::vector<std::uint64_t> release_weights_;
    SiteFalls falls_;
    FallingRocks falling_;
    Fallen all_;
    std::vector<WrittenFile> streamed_;
    std::optional<RunResults> results_;
};

void AssessmentRun::simulate(const OutputFolder* folder) {
    const std::vector<rockfall::Chunk> chunks =
        rockfall::plan_chunks(site_.sources, rockfall::rocks_of_chunk(scenario_.rockfall.fall.motion.model));
    if (!request_.shards.empty()) {
        std::vector<std::filesystem::path> of_shards;
        for (const std::filesystem::path& shard : request_.shards) {
            of_shards.push_back(OutputFolder::parts_of(shard));
        }
        all_ = falling_.joined(all_pieces(of_shards), chunks, parts_ / joined_folder);
    } else if (const std::uint32_t count = pieces(folder); count > 1) {
        fall_in_pieces(chunks, count, folder);
    } else {
        all_ = falling_.kept_in(parts_);
        const std::uint64_t done_before =
            all_.state.chunks_done < chunks.size() ? chunks[all_.state.chunks_done].first_rock : rocks_;
        Progress progress{"falling", rocks_, done_before, request_.quiet};
        falling_.fall(chunks, parts_, all_, {.fell = [&](std::uint64_t rocks) { progress.add(rocks); }});
        progress.finish();
    }
}

/// In how many pieces the run falls, the same on all ranks: as what is kept of it.
std::uint32_t AssessmentRun::pieces(const OutputFolder* folder) {
    std::uint64_t count = std::uint64_t{request_.shard.count} * static_cast<std::uint64_t>(ranks_.count());
    if (folder != nullptr) {
        const std::optional<std::uint32_t> kept = pieces_in(parts_);
        if (kept && request_.shard.count > 1 && *kept != count) {
            config::fail(config::ExitCode::settings, {folder->path().string()},
                         joined("shards and processes for ", std::to_string(count), " pieces"),
                         joined("those of the parts in this folder: ", std::to_string(*kept),
                                " pieces, with as many shards and processes as before"));
        }
        if (!kept && count > 1 && folder->has_parts()) {
            config::fail(config::ExitCode::settings, {folder->path().string()},
                         "parts of a run without shards or other processes",
                         "the same call as before, or --overwrite to start from the beginning");
        }
        count = kept.value_or(static_cast<std::uint32_t>(count));
    }
    count = ranks_.from_first({count}).front();
    if (count > 1 && !all_.state.gone.empty()) {
        config::fail(config::ExitCode::settings, scenario_.options->place_of("tree_impact.remove_broken"),
                     "trees that broken ones leave free, in a run that is shared out",
                     "one process without shards: each rock has to know what the ones before it broke");
    }
    return static_cast<std::uint32_t>(count);
}

/// Those of this shard, shared with other ranks; without shards the whole run is put together then.
void AssessmentRun::fall_in_pieces(std::span<const rockfall::Chunk> chunks, std::uint32_t count,
                                   const OutputFolder* folder) {
    if (folder != nullptr) {
        make_folder(parts_);
    }
    ranks_.meet();
    if (!is_folder(parts_)) {
        config::fail(config::ExitCode::file, {parts_.string()},
                     "a process does not see the output folder of the first one",
                     "a folder that all machines share");
    }
    const std::uint32_t of_shard = count / request_.shard.count;
    const std::uint32_t first = (request_.shard.number - 1) * of_shard;
    std::uint64_t of_pieces = 0;
    for (std::uint32_t k = 0; k < of_shard; ++k) {
        for (const rockfall::Chunk& chunk : chunks_of(chunks, {first + k, count})) {
            of_pieces += chunk.last_rock - chunk.first_rock;
        }
    }
    Progress progress{"falling", of_pieces, 0, request_.quiet};
    const FallingRocks::Watch watch{.fell = [&](std::uint64_t rocks) { progress.add(ranks_.report(rocks)); },
                                    .kept =
                                        [&] {
                                            if (folder != nullptr && !is_there(folder->checkpoint())) {
                                                write_marker(folder->checkpoint(), all_.state.settings_hash);
                                            }
                                        },
                                    .stopped = [&] { return ranks_.stopped(); },
                                    .keep_whole = true};
    const auto next = [&] { return ranks_.next(RankGroup::Work::members); };
    for (std::uint64_t k = next(); k < of_shard; k = next()) {
        const Piece piece{first + static_cast<std::uint32_t>(k), count};
        const std::filesystem::path own = folder_of(parts_, piece);
        make_folder(own);
        Fallen fallen = falling_.kept_in(own);
        falling_.fall(chunks_of(chunks, piece), own, fallen, watch);
    }
    ranks_.meet([&] { progress.add(ranks_.report(0)); });
    progress.finish();
    if (request_.shard.count > 1) {
        if (ranks_.first()) {
            std::printf("Shard %u of %u is done; its parts lie in %s\n", request_.shard.number,
                        request_.shard.count, parts_.string().c_str());
        }
    } else if (folder != nullptr) {
        all_ = falling_.joined(all_pieces({&parts_, 1}), chunks, parts_ / joined_folder);
    }
}

/// All rocks fall once more, past no nets.
void AssessmentRun::keep_paths(const std::filesystem::path& file) {
    std::vector<std::pair<std::string, std::string>> settings;
    for (const config::ParameterRow& row : scenario_.shown_settings()) {
        settings.emplace_back(row.key, row.value_text);
    }
    const PathsHead head{.version = config::version(),
                         .inputs = site_.inputs,
                         .settings = std::move(settings),
                         .seed = scenario_.run.seed,
                         .strata = falls_.draws.strata(scenario_.run.seed),
                         .wanted_share = scenario_.nets.wanted_share,
                         .design = scenario_.design,
                         .with_forest = !falls_.assessment.only_bare(),
                         .rocks = {all_.total.runs[0].rocks, all_.total.runs[1].rocks}};
    const int threads = request_.threads > 0 ? request_.threads : ranks_.usual_threads();
    if (write_net_paths(file, head, falls_.assessment, threads) == Ended::interrupted) {
        throw Interrupted{};
    }
}

/// Of the rocks whose paths are kept, which fall once more.
std::vector<rockfall::RockImpacts> AssessmentRun::kept_impacts() const {
    std::vector<std::uint64_t> rocks;
    if (scenario_.output.impact_table) {
        for (const rockfall::PathRecord& path : all_.state.paths) {
            rocks.push_back(path.rock);
        }
    }
    std::sort(rocks.begin(), rocks.end());
    rocks.erase(std::unique(rocks.begin(), rocks.end()), rocks.end());
    return impacts_of(falls_.assessment, rocks);
}

std::vector<observed::EventComparison> AssessmentRun::observed_events(const StreamedTables& streamed) const {
    const rockfall::Cover cover =
        falls_.assessment.only_bare() ? rockfall::Cover::bare : rockfall::Cover::forest;
    std::vector<observed::SimulatedPassage> passages;
    if (!site_.observed_events.passages.empty()) {
        OwnRows arrivals{streamed.folder / "arrivals.csv", streamed.end_of("arrivals.csv")};
        passages = simulated_passages(arrivals, site_, cover);
    }
    std::vector<observed::SimulatedImpact> impacts;
    if (!site_.observed_events.impacts.empty()) {
        impacts = observed::simulated_impacts(
            impacts_of(falls_.assessment, observed::rocks_for_impacts(rocks_)), cover);
    }
    return observed::compare_events(site_, passages, impacts,
                                    all_.total.runs[static_cast<std::size_t>(cover)].rocks);
}

std::vector<WrittenFile> AssessmentRun::write(const std::filesystem::path& folder, const WriteWatch& watch) {
    if (all_.state.not_started > 0) {
        warnings_.add(std::to_string(all_.state.not_started) +
                      " rocks were not released: their place in the source lies outside the terrain");
    }
    warn_of_departures(departures_on(rockfall::Cover::bare), departures_on(rockfall::Cover::forest),
                       warnings_);
    warn_of_falls(
        scenario_.rockfall.fall.motion,
        fall_figures_of(figures_of(all_.total.runs[static_cast<std::size_t>(rockfall::Cover::bare)])),
        warnings_);
    constexpr std::uint64_t rocks_enough = 100;  // of a few none need meet a tree in open forest [choice]
    const rockfall::RunTally& through_forest =
        all_.total.runs[static_cast<std::size_t>(rockfall::Cover::forest)];
    if (!falls_.assessment.only_bare() && through_forest.rocks >= rocks_enough &&
        met_no_tree(through_forest)) {
        warnings_.add(
            "no rock meets a tree or a log: the forest lies beside the paths of the rocks and changes "
            "nothing",
            config::Effect::answer);
    }
    std::vector<NetRow> work_rows = take_work_rows(all_.state.net_rows, site_.nets.size());
    std::optional<ForestBounds> bounds =
        bounds_of_forest(scenario_, site_, falls_, all_.total,
                         request_.threads > 0 ? request_.threads : ranks_.usual_threads());
    if (bounds) {
        warn_of_bounds(*bounds, site_, all_.total, warnings_);
    }
    // Chunks hand over the slope with forest before the bare one; tables go rock by rock.
    for (std::vector<NetRow>* rows : {&all_.state.net_rows, &work_rows}) {
        std::stable_sort(rows->begin(), rows->end(), [](const NetRow& a, const NetRow& b) {
            return std::tie(a.rock, a.cover) < std::tie(b.rock, b.cover);
        });
    }
    warn_of_unreached(site_, all_.total, all_.state.net_rows, work_rows, warnings_);
    streamed_ = all_.tables->close();
    if (scenario_.nets.keep_paths) {
        keep_paths(folder / paths_name);
        streamed_.push_back({paths_name, "Paths of all rocks without nets, for `bannwald net try`."});
    }
    const StreamedTables tables{streamed_, all_.tables->folder()};
    const std::uint64_t released = all_.total.runs[static_cast<std::size_t>(rockfall::Cover::bare)].rocks;
    results_.emplace(RunResults{
        scenario_,
        site_,
        all_.total,
        {all_.pointers()[0], all_.pointers()[1]},
        all_.state.paths,
        all_.state.net_rows,
        warnings_,
        released,
        !falls_.assessment.only_bare(),
        config::version(),
        compare_stops(site_, falls_.assessment.only_bare() ? rockfall::Cover::bare : rockfall::Cover::forest,
                      tables),
        observed_events(tables),
        kept_impacts(),
        breakdown_of(tables, scenario_, site_),
        falls_.draws.has_spread() ? &falls_.draws : nullptr,
        std::move(bounds),
        std::move(work_rows),
        scenario_.nets.keep_paths ? folder / paths_name : std::filesystem::path{}});
    std::vector<WrittenFile> written = write_results(*results_, folder, tables, watch);
    watch("streamed tables");
    all_.tables->link_to(folder / "tables");
    return written;
}

}  // namespace

int assess_today(const RunRequest& request, const Scenario& scenario, const Site& site,
                 config::Warnings& warnings, const std::filesystem::path& out, RankGroup& ranks) {
    AssessmentRun run{request, scenario, site, warnings, out, ranks};
    return complete_run(run, {request, scenario, out, settings_hash(scenario, site.inputs)}, ranks);
}

int assess_today(const RunRequest& request, const Scenario& scenario, const Site& site,
                 config::Warnings& warnings, const std::filesystem::path& out) {
    RankGroup alone{RankGroup::Alone{}};
    return assess_today(request, scenario, site, warnings, out, alone);
}

}  // namespace coupling
