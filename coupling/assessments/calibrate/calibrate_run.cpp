#include "coupling/assessments/calibrate/calibrate_run.hpp"

#include <cstdio>
#include <memory>
#include <optional>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/calibrate/calibration_results.hpp"
#include "coupling/assessments/calibrate/search/adjustment.hpp"
#include "coupling/assessments/calibrate/search/search_part.hpp"
#include "coupling/assessments/calibrate/sites/open_sites.hpp"
#include "coupling/assessments/calibrate/sites/shared_components.hpp"
#include "coupling/assessments/calibrate/sites/site_case.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/parameters/parameter_knowledge.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/progress.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

SiteParameters parameters_of(const SiteCase& of_site) {
    const std::vector<ParameterWidth>& widths = of_site.site.knowledge->widths;
    return {of_site.name,
            of_site.scenario.file.string(),
            of_site.components,
            &of_site.site.slope.types,
            of_site.drawn.occurs,
            width_of(widths, "ground_guess") > 0.0,
            width_of(widths, "tree_energy")};
}

std::vector<std::unique_ptr<SiteCase>> cases_of(const std::vector<OpenedSite>& sites) {
    const Scenario& lead = *sites.front().scenario;
    std::vector<std::unique_ptr<SiteCase>> cases;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        cases.push_back(std::make_unique<SiteCase>(sites[i].name, *sites[i].scenario, sites[i].site,
                                                   sites[i].scenario->calibrate,
                                                   seed_of_site(lead.run.seed, i)));
    }
    return cases;
}

SharedComponents shared_by(const std::vector<std::unique_ptr<SiteCase>>& cases) {
    std::vector<SiteParameters> parameters;
    for (const std::unique_ptr<SiteCase>& each : cases) {
        parameters.push_back(parameters_of(*each));
    }
    return share(parameters);
}

/// Of all sites, by their numbers.
std::vector<const SiteCase*> chosen(const std::vector<std::unique_ptr<SiteCase>>& cases,
                                    std::span<const std::size_t> numbers) {
    std::vector<const SiteCase*> sites;
    for (const std::size_t number : numbers) {
        sites.push_back(cases[number].get());
    }
    return sites;
}

std::vector<std::size_t> all_but(std::size_t count, std::size_t without) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        if (i != without) {
            numbers.push_back(i);
        }
    }
    return numbers;
}

/// Everything that the results depend on, at all sites.
std::string hash_of(const std::vector<OpenedSite>& sites) {
    if (sites.size() == 1) {
        return settings_hash(*sites.front().scenario, sites.front().site.inputs);
    }
    std::string text;
    for (const OpenedSite& each : sites) {
        text += joined("site ", each.name, "\n", text_of_settings(*each.scenario, each.site.inputs));
    }
    return hash_text(text);
}

/// The page is written with the sets: who wants another language finds out how.
void refuse_this_one_finished(const RunRequest& request, const std::string& hash) {
    if (!request.overwrite && OutputFolder::state_of(request.out, hash) == FolderState::finished) {
        config::fail(config::ExitCode::settings, {request.out.string()},
                     "the output folder holds this calibration, finished",
                     "another folder by --out, or --overwrite to replace it",
                     "a page in another report.language is written by another run: the same seed gives the "
                     "same sets");
    }
}

class CalibrationRun : public RunSteps {
public:
    CalibrationRun(const RunRequest& request, const std::vector<OpenedSite>& sites,
                   const config::Warnings& warnings, RankGroup& ranks, std::string hash)
        : request_{request},
          hash_{std::move(hash)},
          scenario_{*sites.front().scenario},
          warnings_{warnings},
          ranks_{ranks},
          inputs_{inputs_of(sites)},
          cases_{cases_of(sites)},
          shared_{shared_by(cases_)},
          plan_{.first_sets = scenario_.calibrate.first_sets,
                .sets = scenario_.calibrate.sets,
                .most_sets = scenario_.calibrate.most_sets,
                .rocks = scenario_.calibrate.rocks,
                .emulates = emulates(scenario_.calibrate.emulator, scenario_.rockfall.fall.motion.model)},
          threads_{request.threads > 0 ? request.threads : ranks.usual_threads()},
          simulator_{simulator_of(all_but(cases_.size(), cases_.size()))} {
        if (shared_.components.empty()) {
            config::fail(config::ExitCode::settings, {scenario_.file.string()}, "widths that are all 0",
                         "a parameter that is not known", "see `bannwald info parameter_widths`");
        }
        for (const std::unique_ptr<SiteCase>& each : cases_) {
            if (plan_.rocks > most_repeats * each->site.rocks()) {
                config::fail(config::ExitCode::settings, {each->scenario.file.string()},
                             joined(std::to_string(each->site.rocks()), " released rocks for sets of ",
                                    std::to_string(plan_.rocks)),
                             "more rocks of the release", "raise release.rocks or lower calibrate.rocks");
            }
        }
    }

    void simulate(const OutputFolder* folder) override {
        const bool transfers = cases_.size() > 1 && scenario_.calibrate.transfer;
        const std::uint64_t searches = transfers ? 1 + cases_.size() : 1;
        Progress progress{"parameter sets", searches * plan_.most_sets, 0, request_.quiet};
        state_ = searched(simulator_, "search.part", folder, progress);
        const Adjustment adjustment = adjust(state_.population, simulator_.observed_summary());
        std::vector<SearchState> without;
        for (std::size_t site = 0; transfers && site < cases_.size(); ++site) {
            const Simulator others = simulator_of(all_but(cases_.size(), site));
            without.push_back(
                searched(others, joined("without_", cases_[site]->name, ".part"), folder, progress));
            adjust(without.back().population, others.observed_summary());
        }
        progress.finish();
        if (folder == nullptr) {
            return;  // the first rank judges and writes
        }
        judgement_ = judge(simulator_, state_, adjustment, plan_.rocks);
        for (std::size_t site = 0; site < without.size(); ++site) {
            judgement_->transfers.push_back(judge_transfer(simulator_of(all_but(cases_.size(), site)),
                                                           without[site], simulator_of({site}), site,
                                                           plan_.rocks));
        }
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
        if (plan_.emulates) {
            std::printf("%.1f %% of what the widths allow was ruled out by emulators\n",
                        100.0 * (1.0 - state_.left()));
        }
        const Calibration found = calibration();
        print_far(far_alone(found), "");
        for (const Learned& learned : judgement_->parameters) {
            std::printf("  %s: factor %.2f (%.2f to %.2f), ", learned.component.parameter.c_str(),
                        learned.median, learned.low, learned.high);
            if (learned.is_beyond_chance()) {
                std::printf("%.0f %% learned\n", 100.0 * learned.learned);
            } else if (learned.has_too_few_sets()) {
                std::printf("too few sets to say what was learned\n");
            } else {
                std::printf("learned: not distinguishable from chance (up to %.0f %%)\n",
                            100.0 * learned.by_chance);
            }
        }
        for (const Transfer& transfer : judgement_->transfers) {
            std::printf("%s by the other sites: %s\n", cases_[transfer.site]->name.c_str(),
                        transfer_in_words(transfer));
            print_far(far_alone(found, transfer), "  ");
        }
        for (std::size_t site = 0; site < cases_.size(); ++site) {
            std::printf(
                "`bannwald run %s` uses the sets; in another scenario of this site\n"
                "run.parameters = %s\n",
                (request_.out / calibrated_file(found, site)).string().c_str(),
                std::filesystem::absolute(request_.out / "tables" / sample_file(found, site))
                    .string()
                    .c_str());
        }
    }

    [[nodiscard]] std::string after_interruption(const std::filesystem::path& out) const override {
        return is_there(part_in(out, "search.part"))
                   ? "the sets tried so far are kept, run the same command again to go on"
                   : "nothing is kept of work this short";
    }

private:
    static std::filesystem::path part_in(const std::filesystem::path& out, const std::string& name) {
        return OutputFolder::parts_of(out) / name;
    }
    /// Names what a verdict over all together hides.
    void print_far(const std::vector<FarAlone>& rows, const char* opening) const {
        for (const FarAlone& row : rows) {
            std::printf("%salone further away than 95 %% of samples of the model: %s%s%s%s (%.0f %%)\n",
                        opening,
                        cases_.size() > 1 ? joined(cases_[row.observation.site]->name, ", ").c_str() : "",
                        row.observation.name.c_str(), row.use.empty() ? "" : ", ", row.use.c_str(),
                        100.0 * row.as_far);
        }
    }
    static const char* transfer_in_words(const Transfer& transfer) {
        switch (transfer.verdict()) {
            case TransferVerdict::holds:
                return "taken together, what was observed agrees with what they predict";
            case TransferVerdict::too_far:
                return "what was observed is not what they predict";
            case TransferVerdict::too_few:
                return "they do not say it: their sets show too little of what was observed";
            case TransferVerdict::not_close:
                break;
        }
        return "they do not say it: their search did not come close";
    }

    [[nodiscard]] Simulator simulator_of(const std::vector<std::size_t>& sites) const {
        return {chosen(cases_, sites), shared_.of(sites), scenario_.run.seed, threads_, ranks_};
    }

    /// A search from where its part leaves it.
    SearchState searched(const Simulator& simulator, const std::string& part_name, const OutputFolder* folder,
                         Progress& progress) const {
        const std::filesystem::path part = part_in(request_.out, part_name);
        const bool goes_on = folder != nullptr && folder->has_parts() && is_there(part);
        SearchState state;
        if (ranks_.from_first({goes_on ? 1U : 0U}).front() == 1) {
            state = read_search(part);
        }
        ranks_.meet();  // before the first one writes it again
        progress.add(state.tried());
        search(
            simulator, plan_, state,
            [&](const SearchState& now) {
                if (folder != nullptr) {
                    make_folder(folder->parts());
                    write_search(part, now);
                    if (!is_there(folder->checkpoint())) {
                        write_marker(folder->checkpoint(), hash_);  // without it the folder counts as empty
                    }
                }
            },
            [&](std::uint64_t sets) { progress.add(sets); });
        return state;
    }

    [[nodiscard]] Calibration calibration() const {
        return {scenario_,
                inputs_,
                warnings_,
                simulator_.sites(),
                shared_,
                simulator_.space(),
                simulator_.observations(),
                simulator_.lines(),
                plan_,
                state_,
                *judgement_,
                config::version()};
    }

    const RunRequest& request_;
    const std::string hash_;  ///< of settings and inputs
    const Scenario& scenario_;
    const config::Warnings& warnings_;
    RankGroup& ranks_;
    std::vector<InputFile> inputs_;
    std::vector<std::unique_ptr<SiteCase>> cases_;
    SharedComponents shared_;
    SearchPlan plan_;
    int threads_;
    Simulator simulator_;
    SearchState state_;
    std::optional<Judgement> judgement_;
};

}  // namespace

int run_calibration(RunRequest request, RankGroup& ranks) {
    std::unique_ptr<Scenario> lead = read_scenario(request.scenario, request.overrides);
    if (request.out.empty()) {
        request.out = request.scenario.parent_path() / "calibration";
    }
    config::Warnings warnings;
    const std::vector<OpenedSite> sites = open_sites(std::move(lead), warnings);
    const std::string hash = hash_of(sites);
    if (ranks.first()) {
        refuse_this_one_finished(request, hash);
    }
    CalibrationRun run{request, sites, warnings, ranks, hash};
    return between_warnings(request, warnings, ranks, [&] {
        return complete_run(run, {request, *sites.front().scenario, request.out, hash}, ranks);
    });
}

}  // namespace coupling::calibrate
