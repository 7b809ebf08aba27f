#include "validation/engine/forest_cases/belts/tables.hpp"

#include <algorithm>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::validation::forest_cases::belts {
namespace {

using config::joined;
using report::fixed;
using succession_trial::SuccessionRun;
using succession_trial::SuccessionSite;

PlainTable biomass_table(const BeltData& data, const Found& found, const Palette& palette) {
    PlainTable table{
        .caption = joined("Biomass above ground, t/ha, and its share in %: mean over the years ",
                          std::to_string(data.judged.first), " to ", std::to_string(data.judged.last)),
        .head = {"place", "all, t/ha"},
        .rows = {}};
    for (std::size_t layer = 0; layer < palette.layers(); ++layer) {
        table.head.push_back(joined(palette.name(layer), ", t/ha (%)"));
    }
    for (std::size_t site = 0; site < data.tables.sites.size(); ++site) {
        const double all_tpha = sum_of(found.judged_tpha[site]);
        std::vector<std::string> row{site_words(data.tables.sites[site]), fixed(all_tpha, 0)};
        for (const double tpha : palette.layered(found.judged_tpha[site])) {
            row.push_back(
                joined(fixed(tpha, 0), " (", fixed(all_tpha > 0.0 ? 100.0 * tpha / all_tpha : 0.0, 0), ")"));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// Structure of the stands in the judged years.
PlainTable structure_table(const BeltData& data, const std::map<std::string, double>& values) {
    PlainTable table{.caption = "Structure, and deaths in % of the trees of a diameter class a year",
                     .head = {"place", "stem wood, m3/ha", "basal area, m2/ha", "stems above 60 cm, 1/ha",
                              "top height, m", "dead wood, m3/ha", "drought index", "deaths from 10 cm",
                              "from 20 cm", "from 40 cm", "from 60 cm"},
                     .rows = {}};
    for (const SuccessionSite& site : data.tables.sites) {
        const auto figure = [&](const char* name, double factor, int decimals) {
            return fixed(factor * values.at(joined(name, ":", site.name)), decimals);
        };
        table.rows.push_back(
            {site_words(site), figure("volume_m3pha", 1.0, 0), figure("basal_area_m2pha", 1.0, 1),
             figure("stems_60cm_pha", 1.0, 0), figure("top_height_m", 1.0, 1),
             figure("dead_wood_m3pha", 1.0, 0), figure("drought_index", 1.0, 2),
             figure("death_rate_from_10cm", 100.0, 2), figure("death_rate_from_20cm", 100.0, 2),
             figure("death_rate_from_40cm", 100.0, 2), figure("death_rate_from_60cm", 100.0, 2)});
    }
    return table;
}

/// Figures of a site in some columns, by the name before ":SITE".
PlainTable table_by_site(const BeltData& data, const std::map<std::string, double>& values,
                         std::string caption, const std::vector<std::pair<std::string, std::string>>& columns,
                         int decimals) {
    PlainTable table{.caption = std::move(caption), .head = {"place"}, .rows = {}};
    for (const auto& [name, words] : columns) {
        table.head.push_back(words);
    }
    for (const SuccessionSite& site : data.tables.sites) {
        std::vector<std::string> row{site_words(site)};
        for (const auto& [name, words] : columns) {
            row.push_back(fixed(values.at(joined(name, ":", site.name)), decimals));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

PlainTable dead_wood_table(const BeltData& data, const std::map<std::string, double>& values) {
    std::vector<std::pair<std::string, std::string>> columns{{"dead_wood_m3pha", "all, m3/ha"}};
    for (std::size_t i = 1; i <= forest::decay_class_count; ++i) {
        const std::string number = std::to_string(i);
        columns.emplace_back(joined("dead_wood_class", number, "_m3pha"), joined("class ", number));
    }
    return table_by_site(data, values, "Dead wood by decay class, 1 fresh to 5 falling to pieces", columns,
                         0);
}

PlainTable disturbance_table(const BeltData& data, const std::map<std::string, double>& values) {
    return table_by_site(data, values,
                         joined("Stem wood taken a year, m3/ha, from year ",
                                std::to_string(data.settings.disturbed_from_year), " on"),
                         {{"lost_to_wind_m3pha", "storms"},
                          {"lost_to_snow_m3pha", "wet snow"},
                          {"lost_to_beetle_m3pha", "bark beetles"}},
                         2);
}

/// Smallest and largest share of a group among the replicates of its site.
std::string spread_of(const BeltData& data, const Found& found, const succession_trial::SpeciesGroup& group) {
    double least = 1.0;
    double most = 0.0;
    const auto value = joined("share:", group.name, ":", group.site);
    for (const SuccessionRun& run : found.runs) {
        if (run.site == group.site) {
            for (const auto& [name, share] : succession_figures(data.tables, {&run, 1}, data.judged)) {
                least = name == value ? std::min(least, share) : least;
                most = name == value ? std::max(most, share) : most;
            }
        }
    }
    return joined(fixed(least, 2), " to ", fixed(most, 2));
}

PlainTable group_table(const BeltData& data, const Found& found,
                       const std::map<std::string, double>& values) {
    PlainTable table{.caption = "What grows there by the literature, and what grew here",
                     .head = {"place", "group", "share of the biomass [-]", "by replicate [-]",
                              "lead over the greatest other species [-]", "the literature"},
                     .rows = {}};
    for (std::size_t g = 0; g < data.tables.groups.size(); ++g) {
        const succession_trial::SpeciesGroup& group = data.tables.groups[g];
        for (const SuccessionSite& site : data.tables.sites) {
            if (site.name == group.site) {
                const std::string of = joined(":", group.name, ":", site.name);
                table.rows.push_back({site_words(site), group_words(group.name),
                                      fixed(values.at(joined("share", of)), 2), spread_of(data, found, group),
                                      fixed(values.at(joined("margin", of)), 2),
                                      joined(data.published[g], " (", data.sources[g], ")")});
            }
        }
    }
    return table;
}

}  // namespace

std::vector<PlainTable> tables_of(const BeltData& data, const Found& found, const Palette& palette,
                                  const std::map<std::string, double>& values) {
    std::vector<PlainTable> tables{biomass_table(data, found, palette), structure_table(data, values),
                                   dead_wood_table(data, values), group_table(data, found, values)};
    const forest::DisturbanceLaw& law = data.tables.parameters.disturbance;
    if (law.wind || law.snow || law.beetle) {
        tables.push_back(disturbance_table(data, values));
    }
    return tables;
}

}  // namespace coupling::validation::forest_cases::belts
