#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "coupling/assessments/today/figures/forest_today.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "forest/stand/species.hpp"

namespace coupling::report {
namespace {

std::string species_name(const std::string& code) {
    static const forest::SpeciesTable known = forest::SpeciesTable::shipped();
    const auto found = known.find(code);
    return found ? known[*found].latin_name : code;
}

std::string share_text(std::uint64_t part, std::uint64_t whole) {
    const double share = static_cast<double>(part) / static_cast<double>(whole);
    return whole == 0 ? "–" : percent(share);
}

/// Nothing for blocks larger than any that the profiles speak of.
std::optional<PageFields> profile_of(const ForestToday& found) {
    if (!found.profile) {
        return std::nullopt;
    }
    const forest::TargetProfile& profile = *found.profile;
    return PageFields{{"dbh_cm", fixed(profile.dbh_from_cm, 0)},
                      {"least_stems", fixed(profile.least_stems_pha, 0)},
                      {"ideal_stems", fixed(profile.ideal_stems_pha, 0)},
                      {"stems", fixed(found.check.stems_pha, 0)},
                      {"has_stems", found.check.has_stems},
                      {"gap_allowed", fixed(profile.longest_gap_m, 0)},
                      {"gap", fixed(found.check.gap_m, 0)},
                      {"has_short_gaps", found.check.has_short_gaps},
                      {"profile_source", in_page_language(profile.source)}};
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

std::vector<PageFields> species_rows(const ForestToday& found) {
    constexpr std::size_t most_species = 8;
    std::vector<PageFields> rows;
    for (std::size_t i = 0; i < std::min(most_species, found.species.size()); ++i) {
        const ForestToday::Species& species = found.species[i];
        rows.push_back({{"name", species_name(species.code)},
                        {"species_stems", fixed(species.stems_pha, 0)},
                        {"species_area", fixed(species.basal_area_m2pha, 1)},
                        {"species_share", percent(species.basal_area_m2pha / found.basal_area_m2pha)}});
    }
    return rows;
}

PageFields crossed_forest(const ForestToday& found) {
    return {{"area_ha", hectares(found.area_ha)},
            {"stems_pha", fixed(found.stems_pha, 0)},
            {"stems_from_12_cm_pha", fixed(found.stems_from_12_cm_pha, 0)},
            {"basal_area_m2pha", fixed(found.basal_area_m2pha, 1)},
            {"mean_dbh_cm", fixed(found.mean_dbh_cm, 1)},
            {"longest_gap_m", found.gaps.gaps == 0 ? "–" : fixed(found.gaps.max_m, 0)},
            {"open_share", share_text(found.gaps.open_patches, found.gaps.patches)},
            {"mean_block_m", fixed(found.mean_block_m, 2)},
            {"profile", profile_of(found)},
            {"diameters", diameters_of(found)},
            {"species", species_rows(found)}};
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

std::vector<PageFields> trees_by_diameter(const RunResults& results) {
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
    std::vector<PageFields> rows;
    const auto add = [&](const DiameterClass& c) {
        rows.push_back({{"class", c.name},
                        {"trees", grouped(c.trees)},
                        {"hit_trees", grouped(c.hit)},
                        {"hits", grouped(c.hits)},
                        {"breaking", share_text(c.broken, c.hits)},
                        {"energy_share", share_text(c.energy_j, all.energy_j)}});
    };
    for (const DiameterClass& c : classes) {
        if (c.trees > 0) {
            add(c);
        }
    }
    add(all);
    return rows;
}

}  // namespace

std::optional<PageFields> forest_of_today(const RunResults& results) {
    if (!results.with_forest || results.site.trees.empty()) {
        return std::nullopt;
    }
    const std::optional<ForestToday> found = forest_today(results);
    return PageFields{{"crossed", found ? std::optional{crossed_forest(*found)} : std::nullopt},
                      {"diameter_classes", trees_by_diameter(results)}};
}

}  // namespace coupling::report
