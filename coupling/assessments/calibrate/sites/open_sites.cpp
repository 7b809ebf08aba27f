#include "coupling/assessments/calibrate/sites/open_sites.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/calibrate/sites/observation_checks.hpp"
#include "coupling/assessments/calibrate/sites/run_kind.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario_file.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

/// Only letters that any file system takes.
std::string plain(const std::string& name) {
    std::string plain;
    for (const char letter : name) {
        const auto byte = static_cast<unsigned char>(letter);
        plain += (byte < 128 && std::isalnum(byte) != 0) || letter == '-' || letter == '_' ? letter : '_';
    }
    return plain.empty() ? "site" : plain;
}

/// Whether a setting is of the laws of the fall, which all sites share.
bool is_of_laws(const std::string& key) {
    std::set<std::string> sections{"rockfall", "tree_impact", "log_impact"};
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        sections.emplace(rockfall::description_of(model).name);
    }
    return sections.contains(key.substr(0, key.find('.')));
}

void compare_laws(const Scenario& lead, const Scenario& other) {
    const std::vector<config::ParameterRow> rows = lead.options->rows();
    for (const config::ParameterRow& row : other.options->rows()) {
        const auto same = std::find_if(rows.begin(), rows.end(),
                                       [&](const config::ParameterRow& one) { return one.key == row.key; });
        if (is_of_laws(row.key) && same != rows.end() && same->value_text != row.value_text) {
            config::fail(config::ExitCode::settings, {other.file.string()},
                         joined(row.key, " = ", row.value_text, ", but ", same->value_text, " in ",
                                lead.file.string()),
                         "the same laws of the fall at all sites: their parameters are shared",
                         "write the same in both; --set concerns the first one alone");
        }
    }
}

/// The same file of observations at two sites would count twice.
void refuse_same_observations(const OpenedSite& one, const OpenedSite& other) {
    for (const InputFile& mine : other.site.inputs) {
        for (const InputFile& theirs : one.site.inputs) {
            if (mine.role.starts_with("observed") && mine.role == theirs.role && mine.hash == theirs.hash) {
                config::fail(
                    config::ExitCode::settings, {other.scenario->file.string()},
                    joined("the observations of site ", config::in_quotes(one.name), " (", mine.name, ")"),
                    "observations of each site for itself: the same ones count once",
                    "name other files, or take the site out of calibrate.sites");
            }
        }
    }
}

/// What is wrong at a site says which one.
template <class Work>
void saying_where(const std::string& name, const Work& work) {
    try {
        work();
    } catch (const config::InputError& error) {
        std::vector<config::Problem> problems = error.problems();
        for (config::Problem& problem : problems) {
            problem.place.file = joined("site ", name, ": ", problem.place.file);
        }
        throw config::InputError{std::move(problems)};
    }
}

OpenedSite opened_site(const std::string& name, std::unique_ptr<Scenario> scenario,
                       const CalibrateSettings& lead, config::Warnings& warnings) {
    refuse_other_runs(*scenario);
    Site site = open_site(*scenario, warnings);
    refuse_samples(*scenario, site);
    // So many rocks fall at each site.
    scenario->calibrate.rocks = lead.rocks;
    check_observations(*scenario, site, warnings);
    return {name, std::move(scenario), std::move(site)};
}

}  // namespace

std::vector<std::string> names_of_sites(const std::vector<std::filesystem::path>& scenarios) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const std::filesystem::path& scenario : scenarios) {
        const bool is_plain = scenarios.size() > 1 && scenario.stem() == "scenario";
        const std::string own =
            plain((is_plain ? std::filesystem::weakly_canonical(scenario).parent_path().filename()
                            : scenario.stem())
                      .string());
        std::string name = own;
        for (int number = 2; !taken.insert(name).second; ++number) {
            name = joined(own, "_", std::to_string(number));
        }
        names.push_back(name);
    }
    return names;
}

std::uint64_t seed_of_site(std::uint64_t seed, std::size_t site) {
    return site == 0 ? seed : fnv1a(joined("site ", std::to_string(site), " of ", std::to_string(seed)));
}

std::vector<OpenedSite> open_sites(std::unique_ptr<Scenario> lead, config::Warnings& warnings) {
    const CalibrateSettings settings = lead->calibrate;
    const config::Place place =
        settings.sites.empty() ? config::Place{} : lead->options->place_of("calibrate.sites");
    std::vector<std::filesystem::path> files{lead->file};
    for (const std::string& entry : list_of_files(settings.sites)) {
        const std::filesystem::path file = lead->resolve(entry);
        for (const std::filesystem::path& before : files) {
            if (std::filesystem::weakly_canonical(before) == std::filesystem::weakly_canonical(file)) {
                config::fail(config::ExitCode::settings, place, joined(config::in_quotes(entry), " twice"),
                             "each site once; that of the command is the first one",
                             "take it out of calibrate.sites");
            }
        }
        if (!path_exists(file)) {
            config::fail(config::ExitCode::file, place,
                         joined("calibrate.sites, which names no file: ", config::in_quotes(entry)),
                         "a scenario that is there, as this setting names it", "correct the name");
        }
        files.push_back(file);
    }
    if (files.size() > most_sites) {
        config::fail(config::ExitCode::settings, place,
                     joined(std::to_string(files.size()), " sites with that of the command"),
                     joined("at most ", std::to_string(most_sites)),
                     "fit fewer together: of more, no site could be too far away");
    }
    const std::vector<std::string> names = names_of_sites(files);
    std::vector<OpenedSite> sites;
    const std::filesystem::path within = lead->inputs_within;
    sites.push_back(opened_site(names.front(), std::move(lead), settings, warnings));
    for (std::size_t i = 1; i < files.size(); ++i) {
        saying_where(names[i], [&] {
            std::unique_ptr<Scenario> scenario = read_scenario(files[i], {}, within);
            compare_laws(*sites.front().scenario, *scenario);
            config::Warnings of_site;
            OpenedSite site = opened_site(names[i], std::move(scenario), settings, of_site);
            if (!site.scenario->calibrate.sites.empty()) {
                of_site.add_note("calibrate.sites counts in the scenario of the command alone");
            }
            // Each site has folders of its own elsewhere.
            const auto of_this = [&](const std::string& sentence) {
                return joined("site ", names[i], ": ",
                              with_folder_names(sentence, report::scenario_names(*site.scenario)));
            };
            for (std::size_t k = 0; k < of_site.warnings().size(); ++k) {
                warnings.add(of_this(of_site.warnings()[k]), of_site.effects()[k]);
            }
            for (const std::string& note : of_site.notes()) {
                warnings.add_note(of_this(note));
            }
            for (const OpenedSite& before : sites) {
                refuse_same_observations(before, site);
            }
            sites.push_back(std::move(site));
        });
    }
    return sites;
}

std::vector<InputFile> inputs_of(const std::vector<OpenedSite>& sites) {
    std::vector<InputFile> all = sites.front().site.inputs;
    const Scenario& lead = *sites.front().scenario;
    for (std::size_t i = 1; i < sites.size(); ++i) {
        const Scenario& scenario = *sites[i].scenario;
        const FileBytes bytes = open_file(scenario.file, {scenario.file.string()}, "a scenario file");
        all.push_back({"site", lead.shown(std::filesystem::absolute(scenario.file).string()), bytes.hash(),
                       bytes.stored_bytes()});
        for (InputFile input : sites[i].site.inputs) {
            const std::filesystem::path path = scenario.names->path_of(input.name);
            input.name = lead.shown(
                std::filesystem::absolute(path == input.name ? scenario.file.parent_path() / path : path)
                    .string());
            all.push_back(std::move(input));
        }
    }
    return all;
}

}  // namespace coupling::calibrate
