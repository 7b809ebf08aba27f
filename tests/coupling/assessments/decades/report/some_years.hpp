#pragma once

#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/decades/members/record_forest.hpp"
#include "coupling/assessments/decades/report/decade_page.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/forest/small_forest.hpp"

namespace coupling::decades {

/// What a page needs, with members as a test adds them.
struct SomeYears {
    explicit SomeYears(forest::PatchGrid grid_in = forest::square_of_forest(2)) : grid{std::move(grid_in)} {
        scenario->file = "forest.ini";
        scenario->options = std::make_shared<config::Options>();
        declare(*scenario->options, *scenario);
        warnings.add("2 trees stand beside the forest & were left out");
    }

    std::unique_ptr<Scenario> scenario = std::make_unique<Scenario>();  ///< its options refer to it
    std::vector<std::string> regimes{"none <at all>"};
    forest::SpeciesTable species = forest::SpeciesTable::shipped();
    forest::PatchGrid grid;
    std::vector<MemberYears> members;
    config::Warnings warnings;
    std::vector<InputFile> inputs{{"trees", "trees.csv", "0123456789abcdef", 12}};
    std::vector<WrittenFile> files{{"tables/stands.csv", "What stands."}};
    std::vector<Section> first;

    /// A row of each regime.
    [[nodiscard]] std::vector<std::vector<std::pair<std::string, std::string>>> interventions() const {
        return {regimes.size(), {{"thinning", "thin_below"}}};
    }

    [[nodiscard]] std::string page() const {
        std::ostringstream out;
        write_decade_page(out, {.scenario = *scenario,
                                .names = {regimes, interventions(), species},
                                .grid = grid,
                                .members = members,
                                .warnings = warnings,
                                .inputs = inputs,
                                .files = files,
                                .version = "0.1.0",
                                .climate = "observed & repeated",
                                .first = first});
        return out.str();
    }

    /// A member of one species (the first of the table) whose volume is given year by year. Basal area is a
    /// tenth of it, leaf area a hundredth; 100 stems in the class from 12 cm; dead wood, felling and
    /// increment as stated.
    void add_member(std::uint32_t regime, std::uint32_t replicate, const std::vector<double>& volumes_m3pha) {
        MemberYears member;
        member.member = {regime, replicate};
        for (std::size_t i = 0; i < volumes_m3pha.size(); ++i) {
            const auto year = static_cast<std::int32_t>(i);
            forest::StandFigures figures;
            figures.stems_pha = 150.0;
            figures.volume_m3pha = volumes_m3pha[i];
            figures.basal_area_m2pha = volumes_m3pha[i] / 10.0;
            figures.leaf_area_index = volumes_m3pha[i] / 100.0;
            figures.stems_pha_by_class[2] = 50.0;
            figures.stems_pha_by_class[3] = 100.0;
            member.stands.push_back({year, all, all, figures, 0.1});
            member.stands.push_back({year, all, 0, figures, 0.1});
            YearRow row;
            row.year = year;
            row.calendar_year = 2020 + year;
            row.volume_increment_m3pha = i == 0 ? 0.0 : 7.0 + replicate;
            row.snags_m3pha = 11.0;
            row.logs_m3pha = 22.0;
            member.years.push_back(row);
            if (i > 0) {
                member.losses.push_back({year, 0, forest::Cause::wind, {1.0, 2.5, 1.0}});
                member.losses.push_back({year, 0, forest::Cause::felled, {1.0, 1.5, 1.0}});
                HarvestRow work;
                work.year = year;
                work.taken_m3 = 1.2 * grid.area_ha();
                work.left_m3 = 0.3 * grid.area_ha();
                member.harvest.push_back(work);
            }
        }
        members.push_back(std::move(member));
    }

    /// Lets spruce, fir and beech grow on the grid for some years; every second regime fells each tenth tree
    /// in every tenth year.
    void grow(std::uint32_t regime_count, std::uint32_t replicates, int years) {
        const forest::SmallForest small{grid};
        forest::StandRecord record;
        for (std::uint32_t p = 0; p < grid.size(); ++p) {
            record.patches.push_back(forest::PatchId{p});
        }
        record.species = {{.species = *species.find("piab"), .stems_pha = 500.0, .mean_dbh_cm = 26.0},
                          {.species = *species.find("abal"), .stems_pha = 200.0, .mean_dbh_cm = 20.0},
                          {.species = *species.find("acps"), .stems_pha = 40.0, .mean_dbh_cm = 22.0},
                          {.species = *species.find("fasy"), .stems_pha = 300.0, .mean_dbh_cm = 14.0}};
        record.structure = forest::Structure::plenter;
        record.degree_days = 1300.0;
        for (std::uint32_t regime = 0; regime < regime_count; ++regime) {
            for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
                MemberYears member;
                member.member = {regime, replicate};
                forest::Stand stand{grid, species.size(),
                                    forest::trees_from_record(record, grid, species, 1, 0, 0), 2020};
                record_year(stand, species, 0, {}, 6.0, member);
                record_trees(stand, 0, member);
                for (int year = 1; year <= years; ++year) {
                    const forest::YearReport report =
                        forest::grow_year(stand, small.site, species, {small.weather, 380.0, false},
                                          small.parameters, {1, replicate});
                    if (regime % 2 == 1 && year % 10 == 0) {
                        std::vector<forest::Removal> felled;
                        for (const forest::Tree& tree : stand.trees()) {
                            if (forest::number_of(tree.id) % 10 == 0) {
                                felled.push_back({tree.id, forest::Cause::felled, 0});
                            }
                        }
                        stand.remove_trees(felled);
                    }
                    record_year(stand, species, year, report, 6.0, member);
                }
                record_trees(stand, years, member);
                members.push_back(std::move(member));
            }
        }
    }
};

}  // namespace coupling::decades
