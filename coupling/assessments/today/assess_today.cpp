#include "coupling/assessments/today/assess_today.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <tuple>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/language.hpp"
#include "config/version.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/assessments/today/arrival_breakdown.hpp"
#include "coupling/assessments/today/closing_summary.hpp"
#include "coupling/assessments/today/observed_events.hpp"
#include "coupling/assessments/today/observed_stops.hpp"
#include "coupling/assessments/today/row_tables.hpp"
#include "coupling/assessments/today/unreached_today.hpp"
#include "coupling/assessments/today/write_results.hpp"
#include "coupling/inputs/events_of_rocks.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_falls.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/figures/fall_doubts.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/fall_rocks.hpp"
#include "coupling/run/impacts_of_rocks.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/progress.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling {
namespace {

using config::joined;

/// Less work is kept between parts only: whoever stops a run at once wants other settings in the same folder.
constexpr std::chrono::seconds worth_keeping{20};

/// The chunks of the next part: it is finished, and kept, after about this many rocks.
std::span<const rockfall::Chunk> next_part(std::span<const rockfall::Chunk> chunks, std::size_t done,
                                           std::uint64_t rocks_per_part) {
    std::size_t end = done;
    while (end < chunks.size() &&
           (end == done || chunks[end - 1].last_rock - chunks[done].first_rock < rocks_per_part)) {
        ++end;
    }
    return chunks.subspan(done, end - done);
}

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

/// Distributions for the maps, where wanted.
struct Histograms {
    std::array<std::unique_ptr<rockfall::CellHistograms>, rockfall::covers> owned;

    Histograms(const Scenario& scenario, const config::GridFrame& frame, bool with_forest) {
        for (const rockfall::Cover cover : {rockfall::Cover::forest, rockfall::Cover::bare}) {
            if (scenario.output.percentiles && (with_forest || cover == rockfall::Cover::bare)) {
                owned[static_cast<std::size_t>(cover)] = std::make_unique<rockfall::CellHistograms>(frame);
            }
        }
    }
    [[nodiscard]] std::array<rockfall::CellHistograms*, rockfall::covers> pointers() const {
        return {owned[0].get(), owned[1].get()};
    }
};

/// Rock by rock, first those of the slope with forest.
void keep_crossings(const rockfall::ChunkRows& rows, std::vector<NetRow>& kept) {
    for (const rockfall::Cover cover : {rockfall::Cover::forest, rockfall::Cover::bare}) {
        for (const auto& [rock, crossing] : rows.net_crossings[static_cast<std::size_t>(cover)]) {
            kept.push_back({rock, cover, crossing});
        }
    }
}

/// Everything that a run holds while its rocks fall.
class AssessmentRun : public RunSteps {
public:
    AssessmentRun(const RunRequest& request, const Scenario& scenario, const Site& site,
                  config::Warnings& warnings)
        : request_{request},
          scenario_{scenario},
          site_{site},
          warnings_{warnings},
          frame_{site.map_frame_on_terrain()},
          rocks_{site.rocks()},
          path_rocks_{path_rocks_of(scenario, rocks_)},
          falls_{scenario, site, frame_},
          histograms_{scenario, frame_, !falls_.stems.empty() || !falls_.logs.empty()},
          total_{frame_, site.targets.size(), falls_.stems.placed().size(), falls_.logs.count()} {
        falls_.assessment.path_rocks = path_rocks_;
        falls_.assessment.repeats = static_cast<std::uint32_t>(scenario.output.repeats);
        if (scenario.output.sample_paths > 0) {
            falls_.assessment.path_every = std::max<std::uint64_t>(1, rocks_ / scenario.output.sample_paths);
        }
        if (scenario.rockfall.fall.tree.remove_broken && !falls_.assessment.only_bare()) {
            state_.gone.assign(falls_.stems.placed().size() + falls_.logs.count(), 0);
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
        const rockfall::RunTally& run = total_.runs[static_cast<std::size_t>(cover)];
        return departures_of(run.rocks, run.left_over, site_.slope.terrain);
    }
    void keep_paths(const std::filesystem::path& file);
    [[nodiscard]] std::vector<rockfall::RockImpacts> kept_impacts() const;
    [[nodiscard]] std::vector<observed::EventComparison> observed_events(
        const StreamedTables& streamed) const;

    const RunRequest& request_;
    const Scenario& scenario_;
    const Site& site_;
    config::Warnings& warnings_;
    config::GridFrame frame_;
    std::uint64_t rocks_;
    std::vector<std::uint64_t> path_rocks_;
    SiteFalls falls_;
    Histograms histograms_;
    rockfall::EnsembleTally total_;
    Checkpoint state_;
    std::unique_ptr<RowTables> tables_;
    std::vector<WrittenFile> streamed_;
    std::optional<RunResults> results_;
};

void AssessmentRun::simulate(const OutputFolder* kept_in) {
    const OutputFolder& folder = *kept_in;
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<rockfall::Chunk> chunks =
        rockfall::plan_chunks(site_.sources, rockfall::rocks_of_chunk(scenario_.rockfall.fall.motion.model));
    SourcesUnderWay under_way{frame_.size()};
    if (folder.has_parts()) {
        state_ = read_checkpoint(folder.checkpoint(), total_, histograms_.pointers());
        under_way.take_up(state_.begun);
    }
    state_.settings_hash = settings_hash(scenario_, site_.inputs);
    tables_ = std::make_unique<RowTables>(scenario_, site_, folder.parts(), state_.tables);
    const std::uint64_t done_before =
        state_.chunks_done < chunks.size() ? chunks[state_.chunks_done].first_rock : rocks_;
    Progress progress{"falling", rocks_, done_before, request_.quiet};
    const int threads = request_.threads > 0 ? request_.threads : omp_get_max_threads();
    const auto keep_rows = [&](const rockfall::ChunkRows& rows) {
        tables_->add(rows);
        state_.paths.insert(state_.paths.end(), rows.paths.begin(), rows.paths.end());
        keep_crossings(rows, state_.net_rows);
        state_.not_started += rows.not_started;
        progress.add(rows.rocks[static_cast<std::size_t>(rockfall::Cover::bare)].size() + rows.not_started);
    };
    bool kept = folder.has_parts();
    while (state_.chunks_done < chunks.size()) {
        const auto part = next_part(chunks, state_.chunks_done, scenario_.run.rocks_per_part);
        const std::size_t fallen = fall_rocks(falls_.assessment, part, under_way, histograms_.pointers(),
                                              state_.gone, threads, total_, keep_rows);
        const bool interrupted = fallen < part.size();
        const bool last = part.size() == chunks.size() - state_.chunks_done;
        state_.chunks_done += fallen;
        const bool long_enough = std::chrono::steady_clock::now() - begin >= worth_keeping;
        // An interruption that finds nothing new leaves the checkpoint as it is: it may hold gigabytes.
        if (fallen > 0 && (kept || long_enough || !(interrupted || last))) {
            state_.begun = under_way.begun();
            state_.tables = tables_->sync();  // on the disk before the checkpoint that counts on them
            write_checkpoint(folder.checkpoint(), state_, total_, histograms_.pointers());
            kept = true;
        }
        if (interrupted) {
            progress.finish();
            throw Interrupted{};
        }
    }
    progress.finish();
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
                         .wanted_share = scenario_.nets.wanted_share,
                         .with_forest = !falls_.assessment.only_bare(),
                         .rocks = {total_.runs[0].rocks, total_.runs[1].rocks}};
    const int threads = request_.threads > 0 ? request_.threads : omp_get_max_threads();
    if (write_net_paths(file, head, falls_.assessment, threads) == Ended::interrupted) {
        throw Interrupted{};
    }
}

/// Of the rocks whose paths are kept, which fall once more.
std::vector<rockfall::RockImpacts> AssessmentRun::kept_impacts() const {
    std::vector<std::uint64_t> rocks;
    if (scenario_.output.impact_table) {
        for (const rockfall::PathRecord& path : state_.paths) {
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
                                    total_.runs[static_cast<std::size_t>(cover)].rocks);
}

std::vector<WrittenFile> AssessmentRun::write(const std::filesystem::path& folder, const WriteWatch& watch) {
    if (state_.not_started > 0) {
        warnings_.add(std::to_string(state_.not_started) +
                      " rocks were not released: their place in the source lies outside the terrain");
    }
    warn_of_departures(departures_on(rockfall::Cover::bare), departures_on(rockfall::Cover::forest),
                       warnings_);
    warn_of_falls(scenario_.rockfall.fall.motion,
                  fall_figures_of(figures_of(total_.runs[static_cast<std::size_t>(rockfall::Cover::bare)])),
                  warnings_);
    warn_of_unreached(site_, total_, state_.net_rows, warnings_);
    // Chunks hand over the slope with forest before the bare one; tables go rock by rock.
    std::stable_sort(state_.net_rows.begin(), state_.net_rows.end(), [](const NetRow& a, const NetRow& b) {
        return std::tie(a.rock, a.cover) < std::tie(b.rock, b.cover);
    });
    streamed_ = tables_->close();
    if (scenario_.nets.keep_paths) {
        keep_paths(folder / "net_paths.bin");
        streamed_.push_back({"net_paths.bin", "Paths of all rocks without nets, for `bannwald net try`."});
    }
    const StreamedTables tables{streamed_, tables_->folder()};
    const std::uint64_t released = total_.runs[static_cast<std::size_t>(rockfall::Cover::bare)].rocks;
    results_.emplace(RunResults{
        scenario_,
        site_,
        total_,
        {histograms_.pointers()[0], histograms_.pointers()[1]},
        state_.paths,
        state_.net_rows,
        warnings_,
        released,
        !falls_.assessment.only_bare(),
        config::version(),
        compare_stops(site_, falls_.assessment.only_bare() ? rockfall::Cover::bare : rockfall::Cover::forest,
                      tables),
        observed_events(tables),
        kept_impacts(),
        breakdown_of(tables, scenario_, site_),
        falls_.draws.has_spread() ? &falls_.draws : nullptr});
    std::vector<WrittenFile> written = write_results(*results_, folder, tables, watch);
    watch("streamed tables");
    tables_->link_to(folder / "tables");
    return written;
}

}  // namespace

int assess_today(const RunRequest& request, const Scenario& scenario, const Site& site,
                 config::Warnings& warnings, const std::filesystem::path& out) {
    AssessmentRun run{request, scenario, site, warnings};
    RankGroup alone{RankGroup::Alone{}};
    return complete_run(run, {request, scenario, out, settings_hash(scenario, site.inputs)}, alone);
}

}  // namespace coupling
