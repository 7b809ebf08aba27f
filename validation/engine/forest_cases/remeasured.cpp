#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"
#include "validation/engine/forest_cases/remeasured/agreement.hpp"
#include "validation/engine/forest_cases/remeasured/trial.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using remeasured::EndStand;
using remeasured::groups_of;
using remeasured::means_of;
using remeasured::MeasuredStand;
using remeasured::MeasuredTree;
using remeasured::Observed;
using remeasured::observed_end;
using remeasured::observed_of;
using remeasured::Regrown;
using remeasured::RemeasuredData;
using remeasured::Simulated;
using remeasured::simulated_end;
using remeasured::simulated_of;
using remeasured::TreeGroup;
using remeasured::TreeMeans;
using report::fixed;

std::string code_of(const RemeasuredData& data, const std::optional<forest::SpeciesId>& species) {
    return species ? code_in_figures(data.species[*species]) : "all";
}

std::string name_of(const RemeasuredData& data, const TreeGroup& group) {
    return joined(
        code_of(data, group.species), ":",
        group.size ? joined(report::tick_text(data.settings.classes_cm[*group.size]), "cm") : "all");
}

std::string words_of(const RemeasuredData& data, const TreeGroup& group) {
    const std::string who =
        group.species ? data.species[*group.species].latin_name : std::string{"all species"};
    if (!group.size) {
        return who;
    }
    const std::string from = report::tick_text(data.settings.classes_cm[*group.size]);
    const bool is_last = *group.size + 1 == data.settings.classes_cm.size();
    return joined(who, is_last ? joined(" from ", from, " cm on")
                               : joined(" of ", from, " to ",
                                        report::tick_text(data.settings.classes_cm[*group.size + 1]), " cm"));
}

std::vector<std::optional<forest::SpeciesId>> all_and_each(const RemeasuredData& data) {
    std::vector<std::optional<forest::SpeciesId>> who{std::nullopt};
    who.insert(who.end(), data.kinds.begin(), data.kinds.end());
    return who;
}

void add_figures(Comparison& comparison, const RemeasuredData& data) {
    const auto add = [&comparison](std::string name, std::string label, const char* unit) {
        comparison.figures.push_back({std::move(name), std::move(label), unit});
    };
    for (const TreeGroup& group : groups_of(data)) {
        const std::string of = joined(":", name_of(data, group));
        const std::string words = joined(", ", words_of(data, group));
        const Observed observed = observed_of(data, group);
        add(joined("survivors", of), joined("share of trees that survive", words), "-");
        add(joined("survivors_difference", of), joined("share of survivors - observed", words), "-");
        comparison.references[joined("survivors", of)] = {observed.survival(), "trees_end.csv"};
        if (observed.survivors == 0) {
            continue;
        }
        add(joined("increment_cm", of), joined("diameter growth a year", words), "cm");
        comparison.references[joined("increment_cm", of)] = {observed.increment_cm, "trees_end.csv"};
        if (observed.increment_cm > 0.0) {
            add(joined("increment_ratio", of), joined("diameter growth / observed", words), "-");
        }
        add(joined("dbh_bias_cm", of), joined("diameters at the end - observed, mean", words), "cm");
        add(joined("dbh_rmse_cm", of), joined("diameters at the end, RMSE", words), "cm");
    }
    for (const auto& species : all_and_each(data)) {
        const std::string of = joined(":", code_of(data, species));
        const std::string words = joined(", ", words_of(data, {species, std::nullopt}));
        const EndStand observed = observed_end(data, species);
        add(joined("stems_pha", of), joined("stems at the end", words), "1/ha");
        add(joined("basal_area_m2pha", of), joined("basal area at the end", words), "m2/ha");
        add(joined("ingrowth_pha", of), joined("ingrowth", words), "1/ha");
        add(joined("ingrowth_difference_pha", of), joined("ingrowth - observed", words), "1/ha");
        comparison.references[joined("stems_pha", of)] = {observed.stems_pha, "trees_end.csv"};
        comparison.references[joined("basal_area_m2pha", of)] = {observed.basal_area_m2pha, "trees_end.csv"};
        comparison.references[joined("ingrowth_pha", of)] = {observed.ingrown_pha, "trees_end.csv"};
        if (observed.stems_pha > 0.0) {
            add(joined("stems_ratio", of), joined("stems at the end / observed", words), "-");
            add(joined("basal_area_ratio", of), joined("basal area at the end / observed", words), "-");
        }
    }
}

std::string beside(const std::optional<double>& ours, double theirs, int decimals) {
    return joined(ours ? fixed(*ours, decimals) : "", " / ", fixed(theirs, decimals));
}

void add_groups(Outcome& outcome, const RemeasuredData& data, const TreeMeans& means) {
    PlainTable table{.caption = "Trees of the first measurement: simulated / observed; felled ones left out",
                     .head = {"trees", "number", "survivors, %", "growth of survivors, cm a year",
                              "diameters at the end, bias, cm", "RMSE, cm"},
                     .rows = {}};
    for (const TreeGroup& group : groups_of(data)) {
        const std::string of = joined(":", name_of(data, group));
        const Observed observed = observed_of(data, group);
        const Simulated simulated = simulated_of(data, group, means);
        outcome.values[joined("survivors", of)] = simulated.survival;
        outcome.values[joined("survivors_difference", of)] = simulated.survival - observed.survival();
        if (simulated.increment_cm) {
            outcome.values[joined("increment_cm", of)] = *simulated.increment_cm;
            outcome.values[joined("dbh_bias_cm", of)] = *simulated.bias_cm;
            outcome.values[joined("dbh_rmse_cm", of)] = *simulated.rmse_cm;
            if (observed.increment_cm > 0.0) {
                outcome.values[joined("increment_ratio", of)] =
                    *simulated.increment_cm / observed.increment_cm;
            }
        }
        table.rows.push_back(
            {words_of(data, group), std::to_string(observed.trees),
             beside(100.0 * simulated.survival, 100.0 * observed.survival(), 0),
             observed.survivors > 0 ? beside(simulated.increment_cm, observed.increment_cm, 3) : "",
             simulated.bias_cm ? fixed(*simulated.bias_cm, 2) : "",
             simulated.rmse_cm ? fixed(*simulated.rmse_cm, 2) : ""});
    }
    outcome.tables.push_back(std::move(table));
}

void add_ends(Outcome& outcome, const RemeasuredData& data, const std::vector<Regrown>& runs) {
    PlainTable table{
        .caption = joined("The stand at the end, trees from ", report::tick_text(data.stand.least_dbh_cm),
                          " cm on: simulated / observed"),
        .head = {"species", "stems, 1/ha", "basal area, m2/ha", "ingrowth, 1/ha"},
        .rows = {}};
    for (const auto& species : all_and_each(data)) {
        const std::string of = joined(":", code_of(data, species));
        const EndStand observed = observed_end(data, species);
        const EndStand simulated = simulated_end(data, species, runs);
        outcome.values[joined("stems_pha", of)] = simulated.stems_pha;
        outcome.values[joined("basal_area_m2pha", of)] = simulated.basal_area_m2pha;
        outcome.values[joined("ingrowth_pha", of)] = simulated.ingrown_pha;
        outcome.values[joined("ingrowth_difference_pha", of)] = simulated.ingrown_pha - observed.ingrown_pha;
        if (observed.stems_pha > 0.0) {
            outcome.values[joined("stems_ratio", of)] = simulated.stems_pha / observed.stems_pha;
            outcome.values[joined("basal_area_ratio", of)] =
                simulated.basal_area_m2pha / observed.basal_area_m2pha;
        }
        table.rows.push_back({words_of(data, {species, std::nullopt}),
                              beside(simulated.stems_pha, observed.stems_pha, 0),
                              beside(simulated.basal_area_m2pha, observed.basal_area_m2pha, 1),
                              beside(simulated.ingrown_pha, observed.ingrown_pha, 0)});
    }
    outcome.tables.push_back(std::move(table));
}

/// Growth of each tree that survived in the plot, by species.
PlotGroup growth_plots(const RemeasuredData& data, const TreeMeans& means) {
    PlotGroup group{.title = "Diameter growth of each survivor", .plots = {}, .small = true};
    for (const forest::SpeciesId kind : data.kinds) {
        PlotSeries trees{"a tree", "tree", PlotSeries::Form::dots, {}, {}};
        double most = 0.1;
        for (std::size_t i = 0; i < data.stand.trees.size(); ++i) {
            const MeasuredTree& tree = data.stand.trees[i];
            if (tree.species == kind && tree.end_dbh_cm && means.survival[i] > 0.0) {
                const double theirs = (*tree.end_dbh_cm - tree.dbh_cm) / data.stand.years();
                const double ours = (means.end_dbh_cm[i] - tree.dbh_cm) / data.stand.years();
                trees.points.push_back({theirs, ours});
                most = std::max({most, theirs, ours});
            }
        }
        if (trees.points.empty()) {
            continue;
        }
        Plot plot{.title = data.species[kind].latin_name,
                  .x = report::Axis::from_zero("Observed, cm a year", most),
                  .y = report::Axis::from_zero("Bannwald, cm a year", most),
                  .series = {},
                  .labels = {},
                  .caption = "Mean of the replicates in which the tree stands."};
        plot.series = {{"equal", "equal", PlotSeries::Form::line, {{0.0, 0.0}, {most, most}}, {}},
                       std::move(trees)};
        group.plots.push_back(std::move(plot));
    }
    return group;
}

Outcome compare(const RemeasuredData& data, const Work& work) {
    std::vector<Regrown> runs(data.settings.replicates);
    each_piece(work, runs.size(), [&](std::size_t piece) {
        runs[piece] = regrow(data.stand, data.species, data.parameters,
                             {data.settings.seed, static_cast<std::uint32_t>(piece)});
    });
    const TreeMeans means = means_of(data, runs);
    Outcome outcome;
    add_groups(outcome, data, means);
    add_ends(outcome, data, runs);
    if (PlotGroup plots = growth_plots(data, means); !plots.plots.empty()) {
        outcome.plots.push_back(std::move(plots));
    }
    return outcome;
}

std::vector<forest::SpeciesId> kinds_of(const MeasuredStand& stand) {
    std::set<forest::SpeciesId> kinds;
    for (const MeasuredTree& tree : stand.trees) {
        kinds.insert(tree.species);
    }
    for (const remeasured::IngrownTree& tree : stand.ingrown) {
        kinds.insert(tree.species);
    }
    return {kinds.begin(), kinds.end()};
}

/// "73 survived, 4 died, 5 felled, 6 new": what a misread table would change.
std::string fates_in_words(const MeasuredStand& stand) {
    std::size_t survived = 0;
    std::size_t felled = 0;
    for (const MeasuredTree& tree : stand.trees) {
        survived += tree.end_dbh_cm ? 1 : 0;
        felled += tree.felled ? 1 : 0;
    }
    return joined(std::to_string(survived), " survived, ",
                  std::to_string(stand.trees.size() - survived - felled), " died, ", std::to_string(felled),
                  " felled, ", std::to_string(stand.ingrown.size()), " new");
}

void check_classes(const std::vector<double>& classes_cm) {
    if (!std::is_sorted(classes_cm.begin(), classes_cm.end(), std::less_equal<>{})) {
        config::fail(config::ExitCode::settings, {}, "remeasured.classes_cm that do not rise",
                     "lower ends of classes of diameter, each above the one before");
    }
}

}  // namespace

Comparison read_remeasured(const CaseFiles& files, const RemeasuredSettings& settings,
                           const forest::Parameters& parameters) {
    check_classes(settings.classes_cm);
    const auto if_there = [&files](const char* name) {
        return files.has(name) ? std::optional{table_of(files, name)} : std::nullopt;
    };
    auto data = std::make_shared<RemeasuredData>();
    data->species = species_of(files);
    config::Warnings warnings;
    data->stand = remeasured::read_measured_stand({.site = table_of(files, "site.csv"),
                                                   .trees = table_of(files, "trees.csv"),
                                                   .trees_end = table_of(files, "trees_end.csv"),
                                                   .climate = table_of(files, "climate.csv"),
                                                   .fell_list = if_there("fell_list.csv"),
                                                   .saplings = if_there("saplings.csv")},
                                                  data->species, warnings);
    data->parameters = parameters;
    data->settings = settings;
    data->kinds = kinds_of(data->stand);
    Comparison comparison;
    comparison.warnings = warnings.all();
    comparison.notes = remeasured::notes_on_start(data->stand, data->species);
    add_figures(comparison, *data);
    comparison.extent =
        joined(std::to_string(data->stand.trees.size()), " trees measured in ",
               std::to_string(data->stand.first_year), " and ", std::to_string(data->stand.last_year), ": ",
               fates_in_words(data->stand), ", ", std::to_string(settings.replicates), " replicates");
    comparison.pieces = settings.replicates;
    comparison.run = [data](const Work& work) { return compare(*data, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
