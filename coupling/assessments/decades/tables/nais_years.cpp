#include "coupling/assessments/decades/tables/nais_years.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "coupling/assessments/decades/tables/member_columns.hpp"

namespace coupling::decades {
namespace {

using YearOfUnit = std::pair<std::int32_t, std::uint32_t>;

/// The rows of a member by year and unit.
struct UnitYears {
    std::map<YearOfUnit, const forest::StandFigures*> stands;
    std::map<std::pair<YearOfUnit, std::uint32_t>, double> basal_area_of_species;
    std::map<YearOfUnit, const forest::GapFigures*> gaps;
    std::map<YearOfUnit, const forest::StandIndicators*> indicators;
};

UnitYears unit_years_of(const MemberYears& member) {
    UnitYears years;
    for (const StandRow& row : member.stands) {
        if (row.species == all) {
            years.stands[{row.year, row.unit}] = &row.figures;
        } else {
            years.basal_area_of_species[{{row.year, row.unit}, row.species}] = row.figures.basal_area_m2pha;
        }
    }
    for (const GapRow& row : member.gaps) {
        years.gaps[{row.year, row.unit}] = &row.figures;
    }
    for (const IndicatorRow& row : member.indicators) {
        years.indicators[{row.year, row.unit}] = &row.figures;
    }
    return years;
}

/// Basal area of the species that a criterion of mixture is about.
double basal_area_for(const UnitYears& years, const YearOfUnit& at, const forest::NaisCriterion& criterion,
                      const forest::SpeciesTable& species) {
    double sum_m2pha = 0.0;
    for (std::uint32_t s = 0; s < species.size(); ++s) {
        const bool conifer = species.all()[s].conifer;
        const bool counts = criterion.quantity == forest::NaisQuantity::mixture_species
                                ? s == forest::index_of(criterion.species)
                            : criterion.quantity == forest::NaisQuantity::mixture_conifers ? conifer
                                                                                           : !conifer;
        const auto found = years.basal_area_of_species.find({at, s});
        sum_m2pha += counts && found != years.basal_area_of_species.end() ? found->second : 0.0;
    }
    return sum_m2pha;
}

/// The rows that hold for a stand: its own before those of all stands.
std::vector<const NaisRow*> rows_for(std::uint32_t stand, std::span<const NaisRow> profile) {
    std::vector<const NaisRow*> rows;
    for (const NaisRow& row : profile) {
        const bool is_replaced =
            row.stand == 0 && std::any_of(profile.begin(), profile.end(), [&](const NaisRow& other) {
                return other.stand == stand && other.hazard == row.hazard &&
                       other.criterion.name == row.criterion.name;
            });
        if ((row.stand == 0 && !is_replaced) || row.stand == stand) {
            rows.push_back(&row);
        }
    }
    return rows;
}

NaisCell cell_of(std::size_t course, std::uint32_t stand, std::int32_t year, double area_ha,
                 const NaisRow& row) {
    NaisCell cell;
    cell.course = course;
    cell.stand = stand;
    cell.year = year;
    cell.area_ha = area_ha;
    cell.site_type = row.site_type;
    cell.hazard = row.hazard;
    cell.criterion = row.criterion.name;
    cell.minimal = row.minimal_text;
    cell.ideal = row.ideal_text;
    cell.source = row.source;
    return cell;
}

/// A stand in a year: its criteria and, by hazard, the worst of them in each replicate.
void add_cells(std::vector<NaisCell>& cells, const NaisCell& frame, const YearOfUnit& at,
               std::span<const UnitYears> replicates, std::span<const NaisRow* const> rows,
               const forest::SpeciesTable& species) {
    std::map<std::string, std::vector<forest::NaisStatus>> worst;
    std::map<std::string, const NaisRow*> first_of;
    for (const NaisRow* row : rows) {
        NaisCell cell = cell_of(frame.course, frame.stand, frame.year, frame.area_ha, *row);
        auto& whole = worst[row->hazard];
        whole.resize(replicates.size(), forest::NaisStatus::ideal);
        first_of.try_emplace(row->hazard, row);
        double sum = 0.0;
        double known = 0.0;
        for (std::size_t r = 0; r < replicates.size(); ++r) {
            const UnitYears& years = replicates[r];
            const double value = forest::nais_value(
                row->criterion, {years.stands.at(at), years.gaps.at(at), years.indicators.at(at),
                                 basal_area_for(years, at, row->criterion, species)});
            const forest::NaisStatus status = forest::status_of(value, row->minimal, row->ideal);
            ++cell.replicates[static_cast<std::size_t>(status)];
            // Without an ideal a criterion that is met does not keep the whole profile from being ideal.
            const bool holds_back = row->ideal || status == forest::NaisStatus::below;
            whole[r] = holds_back ? std::min(whole[r], status) : whole[r];
            sum += std::isnan(value) ? 0.0 : value;
            known += std::isnan(value) ? 0.0 : 1.0;
        }
        cell.mean_value = known > 0.0 ? sum / known : std::numeric_limits<double>::quiet_NaN();
        cells.push_back(std::move(cell));
    }
    for (const auto& [hazard, statuses] : worst) {
        NaisCell cell = cell_of(frame.course, frame.stand, frame.year, frame.area_ha, *first_of.at(hazard));
        cell.criterion = whole_profile;
        cell.minimal.clear();
        cell.ideal.clear();
        cell.mean_value = std::numeric_limits<double>::quiet_NaN();
        for (const forest::NaisStatus status : statuses) {
            ++cell.replicates[static_cast<std::size_t>(status)];
        }
        cells.push_back(std::move(cell));
    }
}

}  // namespace

std::size_t NaisCell::all_replicates() const {
    return std::accumulate(replicates.begin(), replicates.end(), std::size_t{0});
}

std::vector<NaisCell> nais_over_years(const Names& names, const forest::PatchGrid& grid,
                                      std::span<const MemberYears> members,
                                      std::span<const NaisRow> profile) {
    std::map<std::uint32_t, double> area_ha;
    for (const forest::Patch& patch : grid.patches()) {
        area_ha[patch.management_unit] += forest::patch_area_m2 / 10'000.0;
    }
    std::vector<NaisCell> cells;
    for (std::size_t course = 0; course < names.courses() && !profile.empty(); ++course) {
        std::vector<UnitYears> replicates;
        std::vector<std::int32_t> years;
        for (const MemberYears& member : members) {
            if (names.course_of(member.member) == course) {
                replicates.push_back(unit_years_of(member));
                if (years.empty()) {
                    for (const YearRow& row : member.years) {
                        years.push_back(row.year);
                    }
                }
            }
        }
        for (const auto& [stand, stand_ha] : area_ha) {
            const std::vector<const NaisRow*> rows = rows_for(stand, profile);
            for (const std::int32_t year : years) {
                NaisCell frame;
                frame.course = course;
                frame.stand = stand;
                frame.year = year;
                frame.area_ha = stand_ha;
                // A forest of one stand is recorded as a whole.
                add_cells(cells, frame, {year, area_ha.size() > 1 ? stand : all}, replicates, rows,
                          names.species);
            }
        }
    }
    return cells;
}

namespace {

/// A status of a criterion.
struct StatusRow : NaisCell {
    const Names& names;
    forest::NaisStatus status;
};

TableOf<StatusRow> table_of_statuses() {
    constexpr const char* given = "input stands.target_profile, or shipped";
    constexpr const char* over_replicates = "over the replicates";
    return {
        "nais.csv",
        "Each stand in each year against its target profile: share of replicates below, at "
        "the minimum and ideal.",
        "a status of a criterion for a stand at the end of a year",
        {course_columns<StatusRow>(),

         {"stand", "number of the stand", "input stands.map", &NaisCell::stand},
         {year_column(), &NaisCell::year},
         {"site_type", "site type that the profile is for", given, &NaisCell::site_type},
         {"hazard", "hazard that the profile is for", given, &NaisCell::hazard},
         {"criterion", "what is judged; all: the worst of them", given, &NaisCell::criterion},
         {"status", "below, minimal or ideal", [](const auto& row) { return forest::name_of(row.status); }},
         {"share_of_replicates", 4, "of the replicates that have this status", over_replicates,
          [](const auto& row) {
              return static_cast<double>(row.replicates[static_cast<std::size_t>(row.status)]) /
                     static_cast<double>(row.all_replicates());
          }},

         {"mean_value", "as the criterion says", 2, "mean of the replicates; empty for all", over_replicates,
          &NaisCell::mean_value},
         {Column{"minimal", "as the criterion says", "what is asked for at least", given},
          &NaisCell::minimal},
         {Column{"ideal", "as the criterion says", "what is best; empty: nothing is said", given},
          &NaisCell::ideal},
         {"profile", "the file, or where the shipped profile comes from", given, &NaisCell::source}}};
}

}  // namespace

TableLayout nais_layout() {
    return table_of_statuses();
}

std::vector<WrittenFile> write_nais(const std::filesystem::path& folder, const Names& names,
                                    std::span<const NaisCell> cells) {
    if (cells.empty()) {
        return {};
    }
    return {table_of_statuses().write(folder, [&](auto& rows) {
        for (const NaisCell& cell : cells) {
            for (std::size_t s = 0; s < forest::nais_statuses; ++s) {
                rows.add({cell, names, static_cast<forest::NaisStatus>(s)});
            }
        }
    })};
}

}  // namespace coupling::decades
