#include <algorithm>
#include <array>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/figures/forest_today.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "forest/stand/species.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string species_name(const std::string& code) {
    static const forest::SpeciesTable known = forest::SpeciesTable::shipped();
    const auto found = known.find(code);
    return found ? known[*found].latin_name : code;
}

std::string facts_of(const ForestToday& found) {
    std::string html = "<dl class=\"facts\">";
    html += fact(page_text("Forest that rocks cross"),
                 joined(fixed(found.area_ha, found.area_ha < 10.0 ? 2 : 1), " ha"));
    html += fact(page_text("Stems per ha"), fixed(found.stems_pha, 0));
    html += fact(page_text("Stems from 12 cm on, per ha"), fixed(found.stems_from_12_cm_pha, 0));
    html += fact(page_text("Basal area, m²/ha"), fixed(found.basal_area_m2pha, 1));
    html += fact(page_text("Mean DBH (quadratic), cm"), fixed(found.mean_dbh_cm, 1));
    html += fact(page_text("Longest gap along the fall line, m"),
                 found.gaps.gaps == 0 ? "–" : fixed(found.gaps.max_m, 0));
    html += fact(page_text("Share without a stem of 12 cm"),
                 percent(static_cast<double>(found.gaps.open_patches) /
                         static_cast<double>(std::max<std::uint32_t>(1, found.gaps.patches))));
    return joined(html, "</dl>\n");
}

/// Whether something asked for is there.
std::string verdict(bool met) {
    return met ? page_text("met") : page_text("<b>not met</b>");
}

std::string profile_of(const ForestToday& found) {
    const std::string block = fixed(found.mean_block_m, 2);
    if (!found.profile) {
        return joined(
            "<p>",
            page_text(
                "Rocks of {mean_block_m} m on average are larger than any that the target profiles speak of.",
                {{"mean_block_m", block}}),
            "</p>\n");
    }
    const forest::TargetProfile& profile = *found.profile;
    HtmlTable table{
        page_text(
            "Target profile against rockfall for blocks of {mean_block_m} m on average, in the transit zone.",
            {{"mean_block_m", block}}),
        {page_text("Asked for"), page_text("minimum"), page_text("ideal"), page_text("today"), ""}};
    table.row({page_text("Stems per ha from {dbh_cm} cm on", {{"dbh_cm", fixed(profile.dbh_from_cm, 0)}}),
               fixed(profile.least_stems_pha, 0), fixed(profile.ideal_stems_pha, 0),
               fixed(found.check.stems_pha, 0), verdict(found.check.has_stems)});
    table.row({page_text("Longest gap along the fall line, m"), fixed(profile.longest_gap_m, 0), "–",
               fixed(found.check.gap_m, 0), verdict(found.check.has_short_gaps)});
    return joined("<section class=\"card\">", table.html(), "<p class=\"soft\">",
                  escaped(in_page_language(profile.source)), ".</p></section>\n");
}

std::string diameters_of(const ForestToday& found) {
    std::vector<double> edges{0.0};
    for (std::size_t i = 0; i < found.stems_pha_by_class.size(); ++i) {
        edges.push_back(static_cast<double>(i + 1) * forest::dbh_class_cm);
    }
    const double most = *std::max_element(found.stems_pha_by_class.begin(), found.stems_pha_by_class.end());
    Chart chart{page_text("Stems by diameter"),
                Axis::from_zero(page_text("Diameter at breast height, cm"), edges.back()),
                Axis::from_zero(page_text("Stems per ha in a class of 4 cm"), most)};
    chart.add_steps("forest", edges, found.stems_pha_by_class);
    return chart.figure("");
}

std::string species_of(const ForestToday& found) {
    constexpr std::size_t most_species = 8;
    HtmlTable table{"",
                    {page_text("Species"), page_text("Stems per ha"), page_text("Basal area, m²/ha"),
                     page_text("share of the basal area")}};
    for (std::size_t i = 0; i < std::min(most_species, found.species.size()); ++i) {
        const ForestToday::Species& species = found.species[i];
        table.row({joined("<i>", escaped(species_name(species.code)), "</i>"), fixed(species.stems_pha, 0),
                   fixed(species.basal_area_m2pha, 1),
                   percent(species.basal_area_m2pha / found.basal_area_m2pha)});
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

/// Sums over the trees of a diameter class.
struct DiameterClass {
    std::string name;
    double low_cm;
    std::uint64_t trees = 0;
    std::uint64_t hit = 0;
    std::uint64_t hits = 0;
    std::uint64_t broken = 0;
    std::uint64_t energy_j = 0;
};

std::string share_text(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? "–" : percent(static_cast<double>(part) / static_cast<double>(whole));
}

std::string trees_by_diameter(const RunResults& results) {
    std::array<DiameterClass, 6> classes{{{page_text("below 8 cm"), 0.0},
                                          {page_text("8 to 20 cm"), 8.0},
                                          {page_text("20 to 36 cm"), 20.0},
                                          {page_text("36 to 52 cm"), 36.0},
                                          {page_text("52 to 72 cm"), 52.0},
                                          {page_text("72 cm and more"), 72.0}}};
    DiameterClass all{page_text("all"), 0.0};
    for (std::size_t i = 0; i < results.site.trees.size(); ++i) {
        const rockfall::StemTally& tally = results.tally.stems[i];
        auto at = classes.begin();
        while (at + 1 != classes.end() && results.site.trees[i].stem.dbh_cm >= (at + 1)->low_cm) {
            ++at;
        }
        for (DiameterClass* sums : {&*at, &all}) {
            ++sums->trees;
            sums->hit += tally.hits > 0 ? 1U : 0U;
            sums->hits += tally.hits;
            sums->broken += tally.broken;
            sums->energy_j += tally.energy_j;
        }
    }
    HtmlTable table{
        page_text("Which trees take the energy: every tree is listed in tables/stems.csv. A hit counts as "
                  "breaking if it exceeds the strength of the stem."),
        {page_text("Diameter at breast height"), page_text("trees"), page_text("hit at least once"),
         page_text("hits"), page_text("of them breaking"), page_text("share of all energy taken")}};
    const auto add = [&](const DiameterClass& c) {
        table.row({c.name, grouped(c.trees), grouped(c.hit), grouped(c.hits), share_text(c.broken, c.hits),
                   share_text(c.energy_j, all.energy_j)});
    };
    for (const DiameterClass& c : classes) {
        if (c.trees > 0) {
            add(c);
        }
    }
    add(all);
    return table.html();
}

}  // namespace

std::string forest_of_today(const RunResults& results) {
    if (!results.with_forest || results.site.trees.empty()) {
        return "";
    }
    std::string html = joined("<h2>", page_text("The forest of today"), "</h2>\n");
    if (const auto found = forest_today(results)) {
        html += joined("<p class=\"soft\">",
                       page_text("Living stems of the tree list on cells of 10 m that rocks cross without "
                                 "forest and that have a stem of 12 cm within 30 m. A gap is a row of such "
                                 "cells without a stem of 12 cm; its length is that along the ground."),
                       "</p>\n", facts_of(*found), profile_of(*found), "<div class=\"halves\">",
                       diameters_of(*found), species_of(*found), "</div>\n");
    } else {
        html += joined("<p>", page_text("No living stem stands where rocks cross without forest."), "</p>\n");
    }
    return joined(html, "<section class=\"card\">", trees_by_diameter(results), "</section>\n");
}

}  // namespace coupling::report
