#include "coupling/program/actions/check.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "config/text/numbers.hpp"
#include "coupling/assessments/collapse/collapse_run.hpp"
#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/decades/report/plan_page.hpp"
#include "coupling/assessments/decades/risk/read_risk.hpp"
#include "coupling/assessments/decades/whole_run.hpp"
#include "coupling/assessments/hazard/hazard_plan.hpp"
#include "coupling/assessments/hazard/risk/avoided_risk.hpp"
#include "coupling/assessments/hazard/shared_warnings.hpp"
#include "coupling/assessments/profile/profile_run.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/forest/listed_density.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/rock_count.hpp"
#include "coupling/inputs/scenario/map_size.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/program/actions/describe_barriers.hpp"
#include "coupling/program/actions/describe_forest.hpp"
#include "coupling/program/actions/estimate.hpp"
#include "coupling/program/actions/listing.hpp"
#include "coupling/program/actions/period_blocks.hpp"
#include "coupling/program/actions/pilot.hpp"
#include "coupling/program/actions/run_models.hpp"
#include "coupling/program/actions/study_left.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/model_verdicts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/run/output_folder.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {

namespace {

PilotFalls measured_pilot(const Scenario& scenario, const Site& site) {
    return pilot_falls(scenario, site);
}

std::size_t zones_of(const Site& site) {
    std::set<std::uint32_t> zones;
    for (const rockfall::ReleaseSource& source : site.sources) {
        zones.insert(source.zone);
    }
    return zones.size();
}

std::string trees_in_words(const Site& site) {
    if (site.trees.empty()) {
        return site.logs.empty() ? "none: only the bare slope is assessed" : "none";
    }
    std::set<std::string> species;
    double basal_area_m2 = 0.0;
    for (const TreeRecord& tree : site.trees) {
        species.insert(tree.species);
        basal_area_m2 += 0.25 * M_PI * tree.stem.dbh_cm * tree.stem.dbh_cm * 1e-4;
    }
    std::ostringstream text;
    text << site.trees.size() << " of " << species.size() << " species, basal area " << std::fixed
         << std::setprecision(0) << basal_area_m2 << " m2";
    return text.str();
}

std::string stand_in_words(const Site& site) {
    const ListedDensity density = listed_density(site.trees);
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << density.stems_pha << " stems/ha, " << std::setprecision(1)
         << density.basal_area_m2pha << " m2/ha basal area on the " << report::hectares(density.wooded_ha)
         << " ha of cells of 20 m with a tree";
    return text.str();
}

std::string ground_in_words(const Site& site) {
    std::string text;
    for (const rockfall::SurfaceType& type : site.slope.types) {
        text += (text.empty() ? "" : "; ") + type.label;
    }
    return text;
}

void describe_site(const Scenario& scenario, const Site& site, std::ostream& out) {
    say(out, "scenario", scenario.file.string());
    const report::NamesOfScenario names{scenario};
    for (const InputFile& input : site.inputs) {
        say(out, input.role,
            report::with_scenario_names(input.name) + ", " + size_in_words(input.bytes) + ", hash " +
                input.hash);
    }
    out << '\n';
    say(out, "terrain",
        std::to_string(site.slope.terrain.vertices().size()) + " points, " +
            std::to_string(site.slope.terrain.triangles().size()) + " triangles");
    say(out, "maps", to_string(site.map_frame));
    say(out, "projection",
        site.projection.empty() ? "none"
                                : site.projection.substr(0, site.projection.find('"', 8) + 1) + ", ...");
}

std::string to_mm(double value_m) {
    return config::to_text(std::round(1000.0 * value_m) / 1000.0);
}

void describe_falls(const Scenario& scenario, const Site& site, std::ostream& out) {
    say(out, "motion", std::string{rockfall::description_of(scenario.rockfall.fall.motion.model).name});
    say(out, "field cases",
        verdicts_in_words(rockfall::description_of(scenario.rockfall.fall.motion.model).name));
    say(out, "ground", ground_in_words(site));
    const auto own = static_cast<std::size_t>(
        std::count_if(site.sources.begin(), site.sources.end(),
                      [](const auto& source) { return source.own_start != nullptr; }));
    say(out, "sources",
        std::to_string(site.sources.size()) + " in " + counted(zones_of(site), "zone") +
            (own > 0 ? ", " + std::to_string(own) + " with rocks of their own" : ""));
    const rockfall::DiameterRange sizes = rockfall::diameter_range(start_law(scenario.release), site.sources);
    say(out, "diameters",
        to_mm(sizes.smallest_m) +
            (sizes.largest_m > sizes.smallest_m ? " to " + to_mm(sizes.largest_m) : "") + " m");
    constexpr std::size_t most_named = 10;
    std::string targets;
    for (std::size_t i = 0; i < std::min(most_named, site.targets.size()); ++i) {
        targets += (targets.empty() ? "" : ", ") + site.targets[i].name;
    }
    if (site.targets.size() > most_named) {
        targets += " and " + std::to_string(site.targets.size() - most_named) + " more";
    }
    say(out, "targets", targets.empty() ? "none" : targets);
    describe_barriers(site.nets.size(), site.works, out);
}

/// A run may come to need more than there is, or less than the estimate: nothing to refuse it for.
void doubt_memory(const Estimate& estimate, config::Warnings& warnings) {
    const std::uint64_t has_bytes = physical_memory_bytes();
    if (has_bytes > 0 && estimate.bytes() > has_bytes) {
        warnings.add("memory up to " + size_in_words(estimate.bytes()) + ", of which this machine has " +
                         size_in_words(has_bytes) +
                         ": larger output.cell_size_m, fewer --threads or output.percentiles = no take less",
                     config::Effect::detail);
    }
}

/// "about" for assessments of today, "up to" for runs over years.
void say_memory(const Estimate& estimate, const char* about, std::ostream& out) {
    std::string parts = "inputs " + size_in_words(estimate.input_bytes);
    for (const auto& [name, bytes] :
         {std::pair{"maps ", estimate.map_bytes}, std::pair{"percentiles ", estimate.percentile_bytes},
          std::pair{"forest ", estimate.forest_bytes}, std::pair{"results ", estimate.result_bytes}}) {
        parts += bytes > 0 ? std::string{", "} + name + size_in_words(bytes) : "";
    }
    say(out, "memory", about + (" " + size_in_words(estimate.bytes())) + ": " + parts);
}

/// What several runs one after the other take.
struct CostOfRuns {
    double seconds = 0.0;
    std::uint64_t bytes = 0;  ///< of the largest one
    double started_s = 0.0;   ///< CPU time of this process when the run at hand was begun

    void begin() { started_s = process_cpu_s(); }
    void add(const Estimate& estimate) {
        seconds += estimate.seconds();
        bytes = std::max(bytes, estimate.bytes());
    }
};

std::string on_threads(int threads) {
    return " on " + counted(static_cast<std::size_t>(threads), "thread");
}

void say_cost_today(const Estimate& estimate, int threads, std::ostream& out) {
    say_memory(estimate, "about", out);
    const std::string parts = durations_of({{"reading", estimate.read_seconds},
                                            {"falls", estimate.fall_seconds},
                                            {"writing", estimate.write_seconds}});
    say(out, "time",
        duration(estimate.seconds()) + on_threads(threads) + ", within a factor of two" +
            (parts.empty() ? "" : ": " + parts));
}

void say_cost_of_years(const Estimate& estimate, int threads, std::ostream& out) {
    say_memory(estimate, "up to", out);
    say(out, "time", duration(estimate.seconds()) + on_threads(threads) + ", within a factor of three");
}

void describe_today(const Scenario& scenario, const Site& site, int threads, config::Warnings& warnings,
                    std::ostream& out, CostOfRuns& cost) {
    describe_site(scenario, site, out);
    say(out, "trees", trees_in_words(site));
    if (!site.trees.empty()) {
        say(out, "stand", stand_in_words(site));
    }
    if (!site.logs.empty()) {
        say(out, "logs", counted(site.logs.size(), "log"));
    }
    describe_falls(scenario, site, out);
    const Estimate estimate =
        estimate_of(scenario, site, threads, process_cpu_s() - cost.started_s, measured_pilot);
    say(out, "rocks",
        std::to_string(estimate.rocks) +
            (estimate.covers == 2 ? ", each with forest and on the bare slope" : ""));
    say_cost_today(estimate, threads, out);
    cost.add(estimate);
    plausible::warn_of_rocks(scenario, site, warnings);
    say(out, "disk",
        "about " + size_in_words(estimate.raster_bytes) +
            (scenario.hazard.blocks.empty() ? "" : " for each return period") +
            " for grids (.asc), within a factor of two");
    if (estimate.path_bytes > 0) {
        say(out, "disk",
            "about " + size_in_words(estimate.path_bytes) +
                " for net_paths.bin (nets.keep_paths), within a factor of three");
    }
    doubt_memory(estimate, warnings);
}

/// What a verdict on the regimes takes, and what it costs to come there.
void say_decision(const Scenario& scenario, const Site& site, std::size_t regimes, int threads,
                  std::ostream& out) {
    const decades::VerdictChances chances =
        decades::verdict_chances(regimes, site.forest->climates.size() * site.targets.size());
    const std::size_t least = decades::least_for_yes(scenario.forest.decision.probability, chances);
    const std::size_t here = scenario.forest.replicates;
    std::string lacking;
    if (here < least) {
        const std::size_t more = least - here;
        const std::size_t members = more * regimes * site.forest->climates.size();
        const Estimate cost = estimate_of_years(scenario, site,
                                                {.members = members,
                                                 .missing = members,
                                                 .missing_replicates = more,
                                                 .missing_years = members * scenario.run.years},
                                                threads, measured_pilot);
        lacking = ": a yes needs a clear margin, or " + std::to_string(more) + " more, which take " +
                  duration(cost.seconds());
    }
    say(out, "decision",
        "a yes by counting takes " + counted(least, "replicate") +
            " that all keep the protection; here are " + std::to_string(here) + lacking);
}

void describe_years(const CheckRequest& request, const Scenario& scenario, Site site, int threads,
                    config::Warnings& warnings, std::ostream& out, CostOfRuns& cost) {
    const decades::Management management =
        decades::read_management(scenario, *site.forest, warnings, decades::mean_block_m(scenario, site));
    const StudySize study = study_left(request.out, scenario, site, management);
    site.inputs.insert(site.inputs.end(), management.inputs.begin(), management.inputs.end());
    const std::optional<consequences::RiskPlan> risk = decades::read_risk(scenario, site, warnings);
    describe_site(scenario, site, out);
    describe_forest(scenario, site, management, out);
    const Estimate estimate = estimate_of_years(scenario, site, study, threads, measured_pilot);
    say_what_is_left(scenario, study, out);
    if (has_rocks(scenario)) {
        describe_falls(scenario, site, out);
        say(out, "rocks",
            std::to_string(estimate.rocks) + " a year, in " + counted(estimate.rock_years, "year") +
                " of each member, each with forest and on the bare slope");
        if (risk) {
            const std::string rocks = config::to_text(decades::real_rocks_per_year(scenario));
            say(out, "risk",
                "of " + counted(risk->targets.size(), "exposed target") + ", of " + rocks +
                    " rocks that really start in a year");
        }
        plausible::warn_of_rocks(scenario, site, warnings);
        if (!site.targets.empty()) {
            say_decision(scenario, site, management.regimes.size(), threads, out);
        }
    } else {
        say(out, "rocks", "none fall: run.rockfall_every is 0");
    }
    say_cost_of_years(estimate, threads, out);
    cost.add(estimate);
    doubt_memory(estimate, warnings);
    if (!request.page.empty()) {
        OutFile page{request.page};
        decades::write_plan_page(page.stream(), scenario, site, management, warnings);
        page.close();
        say(out, "page", request.page.string());
    }
}

void add_all(const config::Warnings& more, config::Warnings& warnings) {
    for (std::size_t i = 0; i < more.warnings().size(); ++i) {
        warnings.add(more.warnings()[i], more.effects()[i]);
    }
    std::for_each(more.notes().begin(), more.notes().end(),
                  [&](const std::string& note) { warnings.add_note(note); });
}

/// Each return period as the run that it will be.
void check_return_periods(const CheckRequest& request, const Scenario& scenario, int threads,
                          config::Warnings& warnings, std::ostream& out, CostOfRuns& cost,
                          std::shared_ptr<const InputNames>* names) {
    const hazard::HazardPlan plan = hazard::read_plan(scenario);
    std::vector<PeriodBlock> blocks;
    hazard::SharedWarnings shared;
    for (const double years : plan.return_periods_years) {
        cost.begin();
        const auto one = hazard::scenario_of(request.scenario, request.overrides, years);
        if (names != nullptr) {
            *names = one->names;
        }
        config::Warnings of_period;
        std::ostringstream text;
        try {
            Site site = open_site(*one, of_period);
            if (plan.risk) {
                consequences::on_site(*plan.risk, site.targets);  // refused here as by the run
            }
            if (const auto without = hazard::risk::run_without(*one); !without.empty()) {
                hazard::risk::check_same_rocks(without / hazard::period_folder(years), *one, site);
            }
            describe_today(*one, std::move(site), threads, of_period, text, cost);
        } catch (...) {
            shared.add_to(warnings);
            add_all(of_period, warnings);
            throw;
        }
        blocks.push_back({years, text.str()});
        shared.add(years, of_period);
    }
    shared.add_to(warnings);
    print_blocks(blocks, out);
}

/// A page shows where regimes act: only runs over years have such.
void refuse_page(const CheckRequest& request, const Scenario& scenario) {
    if (request.page.empty()) {
        return;
    }
    if (scenario.run.years == 0) {
        config::fail(config::ExitCode::settings, {scenario.file.string()},
                     "--page for a scenario without run.years",
                     "a run over years: the page shows where its regimes act", "leave --page out");
    }
    if (!request.overwrite && path_exists(request.page)) {
        config::fail(config::ExitCode::settings, {request.page.string()}, "a file that is there",
                     "a new file", "name another one, or add --overwrite");
    }
}

void print_settings(const config::Options& options, std::ostream& out) {
    out << "\nSettings (* differs from the default)\n";
    for (const config::ParameterRow& row : options.rows()) {
        out << (row.changed ? "* " : "  ") << std::left << std::setw(38) << row.key << ' '
            << (row.value_text.empty() ? "(none)" : row.value_text);
        if (row.unit != "-" && !row.unit.empty()) {
            out << ' ' << row.unit;
        }
        out << "    default " << (row.default_text.empty() ? "(none)" : row.default_text);
        if (!row.source.empty()) {
            out << "; " << row.source;
        }
        out << '\n';
    }
}

void check_collapse(const CheckRequest& request, config::Warnings& warnings, std::ostream& out) {
    if (!request.models.empty()) {
        config::fail(config::ExitCode::settings, {request.scenario.string()},
                     "section [collapse] with --motion: a rock mass that breaks up has no motion model",
                     "a scenario of `bannwald run`", "leave --motion out");
    }
    const auto collapse_scenario = collapse::read_collapse(request.scenario, request.overrides);
    refuse_page(request, collapse_scenario->scenario);
    collapse::describe(*collapse_scenario, request.threads, warnings, out);
    if (request.print_settings) {
        print_settings(*collapse_scenario->scenario.options, out);
    }
}

/// A scenario with the motion model that its settings name.
void check_one(const CheckRequest& request, int threads, config::Warnings& warnings, std::ostream& out,
               CostOfRuns& cost, std::shared_ptr<const InputNames>* names) {
    const auto scenario = read_scenario(request.scenario, request.overrides);
    if (names != nullptr) {
        *names = scenario->names;
    }
    refuse_page(request, *scenario);
    if (wants_hazard_map(*scenario)) {
        check_return_periods(request, *scenario, threads, warnings, out, cost, names);
    } else if (scenario->terrain.profile.empty()) {
        Site site = open_site(*scenario, warnings);
        if (site.forest) {
            describe_years(request, *scenario, std::move(site), threads, warnings, out, cost);
        } else {
            describe_today(*scenario, site, threads, warnings, out, cost);
        }
    } else {
        profile::describe(*scenario, profile::open_profile(*scenario, warnings), out);
        plausible::warn_of_few_rocks(profile::rocks_of(*scenario), warnings);
    }
    if (request.print_settings) {
        print_settings(*scenario->options, out);
    }
}

}  // namespace

void check_scenario(const CheckRequest& request, config::Warnings& warnings, std::ostream& out,
                    std::shared_ptr<const InputNames>* names) {
    const int threads = request.threads > 0 ? request.threads : omp_get_max_threads();
    if (collapse::is_collapse(request.scenario)) {
        check_collapse(request, warnings, out);
        return;
    }
    CostOfRuns cost;
    if (request.models.size() < 2) {
        CheckRequest one = request;
        for (const std::string& model : request.models) {
            one.overrides.push_back(setting_of_model(model));
        }
        check_one(one, threads, warnings, out, cost, names);
        return;
    }
    const auto scenario = read_scenario(request.scenario, request.overrides);
    const std::filesystem::path base =
        output_folder_of({.scenario = request.scenario, .overrides = {}, .out = request.out}, *scenario);
    for (const std::string& model : request.models) {
        out << "Motion model " << model << '\n';
        CheckRequest one = request;
        one.overrides.push_back(setting_of_model(model));
        one.out = base / model;
        one.page = &model == &request.models.front() ? request.page : "";  // the same under each
        cost.begin();
        check_one(one, threads, warnings, out, cost, names);
        out << '\n';
    }
    out << "All motion models, one after the other\n";
    if (!scenario->terrain.profile.empty()) {
        say(out, "time", "seconds: a profile");
        return;
    }
    say(out, "memory", "up to " + size_in_words(cost.bytes));
    say(out, "time", duration(cost.seconds) + on_threads(threads));
}

}  // namespace coupling
