#include "coupling/assessments/decades/members/management.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <span>
#include <sstream>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/members/judged_cuts.hpp"
#include "coupling/exchange/regimes/shipped.hpp"
#include "coupling/inputs/formats/layer_name.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/reading/result_name.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "forest/protection/target_profile.hpp"

namespace coupling::decades {
namespace {

using config::joined;

/// Names and files, split at commas, blanks around them left out.
std::vector<std::string> entries_of(const std::string& list) {
    std::vector<std::string> entries;
    std::stringstream words{list};
    for (std::string word; std::getline(words, word, ',');) {
        const auto first = word.find_first_not_of(" \t");
        if (first != std::string::npos) {
            entries.push_back(word.substr(first, word.find_last_not_of(" \t") + 1 - first));
        }
    }
    return entries;
}

bool is_file(const std::string& entry) {
    return entry.find('.') != std::string::npos;
}

/// A shipped regime is named as it is, a file without folder and ending.
std::string regime_name(const std::string& entry) {
    return is_file(entry) ? std::filesystem::path{entry}.stem().string() : entry;
}

config::Table table_of(const std::string& entry, Reading& reading) {
    if (is_file(entry)) {
        return reading.table("regimes.list", "regime", entry);
    }
    std::istringstream text{std::string{shipped_regime(entry)}};
    return config::Table::read(text, joined("regime ", entry));
}

Regime read_regime(const std::string& entry, const ForestSite& forest, Reading& reading) {
    const ShapesOf shapes_of = [&](const std::string& file, config::Shape::Kind kind) {
        const bool is_line = kind == config::Shape::Kind::line;
        return shapes_in(reading.table("regimes.list", is_line ? "regime lines" : "regime polygons", file),
                         kind);
    };
    // Shipped regimes also serve runs that are shorter than their turns.
    const RunYears run = is_file(entry)
                             ? RunYears{forest.first_year() - 1, static_cast<int>(reading.run().years)}
                             : RunYears{};
    return Regime::read(table_of(entry, reading), regime_name(entry), forest.species.table, forest.grid,
                        shapes_of, run, [&](const std::string& role, const std::string& file) {
                            return reading.table("regimes.list", role, file);
                        });
}

/// What a regime was read from: all that it depends on but the forest.
std::string read_for(const std::string& entry, std::span<const InputFile> files) {
    // A package may hold several plans.
    std::string text = is_file(entry) ? formats::split_layer_name(entry).layer : entry;
    for (const InputFile& file : files) {
        text += joined(";", file.role, " ", file.hash);
    }
    return text;
}

/// Numbers of the trees that the forest starts with.
std::set<std::uint64_t> numbers_of_listed_trees(const ForestSite& forest) {
    std::set<std::uint64_t> numbers;
    for (const forest::Tree& tree : forest.listed) {
        numbers.insert(forest::number_of(tree.id));
    }
    return numbers;
}

/// A recorded cut names trees of the list that the forest starts with.
void check_listed_trees(const Regime& regime, const ForestSite& forest, Reading& reading) {
    for (const Intervention& row : regime.interventions()) {
        if (row.treatment != Treatment::fell_list) {
            continue;
        }
        const std::set<std::uint64_t> known = numbers_of_listed_trees(forest);
        std::string first;
        std::size_t missing = 0;
        for (const ListedTree& tree : row.listed) {
            if (!known.contains(tree.tree)) {
                first = missing == 0 ? std::to_string(tree.tree) : first;
                ++missing;
            }
        }
        if (missing > 0) {
            reading.problems().add(
                config::ExitCode::data, {reading.shown(row.trees)},
                joined(counted(missing, "tree"), " that the forest does not start with, such as ", first),
                "tree_id of trees in the list (trees.file) that stand in the forest of stands.map",
                "correct tree_id, or leave the rows out");
        }
    }
}

/// Trees of a recorded cut whose year the run does not reach stay: said, as a run that was shortened would
/// otherwise look like a lighter cut.
void warn_of_cuts_after_the_run(const Regime& regime, const ForestSite& forest, Reading& reading) {
    const auto last_year = static_cast<int>(reading.run().years);
    for (const Intervention& row : regime.interventions()) {
        const auto late = std::count_if(row.listed.begin(), row.listed.end(),
                                        [&](const ListedTree& tree) { return tree.year > last_year; });
        if (late > 0) {
            reading.warn(joined(reading.shown(row.trees), ": ",
                                counted(static_cast<std::size_t>(late), "tree"),
                                " to be felled after the last year of the run, ", std::to_string(last_year),
                                " (", std::to_string(forest.first_year() - 1 + last_year),
                                "); extend the run (run.years) to fell all"));
        }
    }
}

/// With fewer areas than turns some turns find nothing, and the rotation of what there is becomes shorter.
void warn_of_short_turns(const Regime& regime, Reading& reading) {
    for (std::size_t i = 0; i < regime.interventions().size(); ++i) {
        const Intervention& row = regime.interventions()[i];
        const bool in_turns = row.ground.where == Where::strips || row.ground.where == Where::slits;
        const std::size_t areas = regime.areas_of(i).size();
        if (in_turns && areas < static_cast<std::size_t>(std::max(1, row.ground.entries))) {
            reading.note(joined(
                "regime ", regime.name(), ": ", row.name, " takes turns over ",
                std::to_string(row.ground.entries), " entries, but the forest has ", counted(areas, "area"),
                " for it: its rotation is shorter than the regime means; harvest is not comparable"));
        }
    }
}

void refuse_entry(const std::string& entry, const std::string& expected, Reading& reading) {
    reading.problems().add(config::ExitCode::settings, reading.settings().options->place_of("regimes.list"),
                           joined("regime '", entry, "'"), expected);
}

std::string shipped_in_words() {
    std::string text;
    for (const std::string& name : shipped_regime_names()) {
        text += joined(text.empty() ? "" : ", ", name);
    }
    return text;
}

}  // namespace

double mean_block_m(const Scenario& scenario, const Site& site) {
    return site.sources.empty() ? 0.0
                                : rockfall::diameter_range(start_law(scenario.release), site.sources).mean_m;
}

namespace {

Management management_of(const ForestSite& forest, double mean_block_m, Reading& reading) {
    Management management;
    std::set<std::string> names{"bare"};  // a folder of the rasters has this name
    for (const std::string& entry : entries_of(reading.forest().regimes)) {
        if (is_file(entry) && !is_result_name(regime_name(entry))) {
            refuse_entry(entry, joined("a file whose name without ending is ", result_name_in_words),
                         reading);
            continue;
        }
        if (!is_file(entry) && shipped_regime(entry).empty()) {
            refuse_entry(entry, joined("one of ", shipped_in_words(), ", or the name of a CSV file"),
                         reading);
            continue;
        }
        const std::size_t files_before = reading.inputs().size();
        auto regime = reading.attempt([&] { return read_regime(entry, forest, reading); });
        if (!regime) {
            continue;
        }
        management.read_for.push_back(read_for(entry, std::span{reading.inputs()}.subspan(files_before)));
        if (!names.insert(regime->name()).second) {
            refuse_entry(entry, "regimes of different names, none of them 'bare'", reading);
        }
        warn_of_short_turns(*regime, reading);
        warn_of_cuts_after_the_run(*regime, forest, reading);
        check_listed_trees(*regime, forest, reading);
        management.regimes.push_back(std::move(*regime));
    }
    const std::size_t files_of_regimes = reading.inputs().size();
    const std::string& prices = reading.forest().timber_prices;
    const std::string& work = reading.forest().work_costs;
    auto read = reading.attempt([&] {
        return prices.empty() ? shipped_prices(forest.species.table)
                              : read_prices(reading.table("regimes.timber_prices", "timber_prices", prices),
                                            reading.table("regimes.work_costs", "work_costs", work),
                                            forest.species.table);
    });
    if (read && !read->guarded_tree_eur) {
        for (const Regime& regime : management.regimes) {
            for (const Intervention& row : regime.interventions()) {
                if (row.guard_years > 0) {
                    reading.refuse(
                        {reading.shown(work)},
                        joined("no row guarded_tree, but ", regime.name(), ", ", row.name, " sets guards"),
                        "its cost in EUR");
                }
            }
        }
    }
    if (reading.problems().empty() && management.regimes.empty()) {
        refuse_entry(reading.forest().regimes, "at least one regime, such as none", reading);
    }
    if (reading.forest().target_profile.empty()) {
        management.target_profile =
            mean_block_m > 0.0 ? shipped_nais_profile(mean_block_m) : std::vector<NaisRow>{};
    } else {
        const auto known = forest::target_profile(mean_block_m);
        auto rows = read_nais_profile(forest.species.table, forest.grid,
                                      mean_block_m > 0.0 && known ? known->dbh_from_cm : 0.0, reading);
        management.target_profile = rows ? std::move(*rows) : std::vector<NaisRow>{};
    }
    for (std::string& sentence : unjudged_plans(management.regimes, reading.scenario())) {
        reading.warn(std::move(sentence), config::Effect::answer);
    }
    reading.finish();
    management.prices = std::move(*read);
    management.inputs = reading.inputs();
    management.shared_inputs.assign(management.inputs.begin() + static_cast<std::ptrdiff_t>(files_of_regimes),
                                    management.inputs.end());
    return management;
}

}  // namespace

Management read_management(const Scenario& scenario, const ForestSite& forest, config::Warnings& warnings,
                           double mean_block_m) {
    Reading reading{scenario, warnings};
    return scenario.with_paths([&] { return management_of(forest, mean_block_m, reading); });
}

}  // namespace coupling::decades
