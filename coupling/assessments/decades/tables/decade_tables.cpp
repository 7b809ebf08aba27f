#include "coupling/assessments/decades/tables/decade_tables.hpp"

#include <functional>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/decades/tables/yearly_layouts.hpp"

namespace coupling::decades {
namespace {

using config::joined;

std::string_view species_of(const Names& names, std::uint32_t species) {
    return species == all ? std::string_view{"all"} : names.species.all()[species].code;
}

void write_stands(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "stands.csv"};
    for (const MemberYears& member : members) {
        for (const StandRow& stand : member.stands) {
            begin_row(row, names, member.member, stand.year);
            add_unit(row, stand.unit);
            row.text(species_of(names, stand.species));
            const forest::StandFigures& f = stand.figures;
            row.number<1>(f.stems_pha).number<3>(f.basal_area_m2pha).number<2>(f.volume_m3pha);
            row.number<3>(f.above_ground_tpha).number<2>(f.mean_dbh_cm).number<2>(f.lorey_height_m);
            row.number<2>(f.dominant_height_m).number<3>(f.leaf_area_index);
            for (const forest::ThickTrees& from : f.from) {
                row.number<1>(from.stems_pha).number<3>(from.basal_area_m2pha).number<2>(from.volume_m3pha);
            }
            row.number<3>(stand.drought_index);
            row.end();
        }
    }
}

/// Of the whole forest; classes without stems are left out.
void write_dbh_classes(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "dbh_classes.csv"};
    for (const MemberYears& member : members) {
        for (const StandRow& stand : member.stands) {
            for (std::size_t c = 0; stand.unit == all && c < forest::dbh_classes; ++c) {
                const double stems_pha = stand.figures.stems_pha_by_class[c];
                if (stems_pha <= 0.0) {
                    continue;
                }
                begin_row(row, names, member.member, stand.year);
                row.text(species_of(names, stand.species));
                add_dbh_class(row, c);
                row.number<2>(stems_pha);
                row.end();
            }
        }
    }
}

void write_years(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "forest_years.csv"};
    for (const MemberYears& member : members) {
        for (const YearRow& y : member.years) {
            begin_row(row, names, member.member, y.year);
            row.whole(static_cast<std::uint32_t>(y.calendar_year));
            if (y.year == 0) {
                row.empty().empty().empty();
            } else {
                row.number<3>(y.volume_increment_m3pha).number<3>(y.production_tpha);
                row.number<1>(y.ingrowth_stems_pha);
            }
            row.number<1>(y.saplings_pha).number<2>(y.snags_pha).number<3>(y.snags_m3pha);
            row.number<2>(y.logs_pha).number<3>(y.logs_m3pha).number<3>(y.dead_stems_tpha);
            for (const double m3pha : y.dead_wood_m3pha) {
                row.number<3>(m3pha);
            }
            if (y.year == 0) {
                row.empty().empty().empty().empty().empty();
            } else {
                row.number<1>(y.precipitation_mm).number<1>(y.evapotranspiration_mm).number<1>(y.runoff_mm);
                row.number<1>(y.storage_gain_mm).number<2>(y.mean_temperature_degc);
            }
            for (const double tpha :
                 {y.stem_wood_tpha, y.stem_growth_tpha, y.stem_ingrowth_tpha, y.stem_losses_tpha,
                  y.stem_hauled_tpha, y.stem_litter_tpha, y.dead_wood_in_tpha, y.dead_wood_decayed_tpha,
                  y.dead_wood_to_soil_tpha, y.dead_wood_taken_tpha}) {
                row.number<4>(tpha);
            }
            row.end();
        }
    }
}

void write_losses(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "mortality.csv"};
    for (const MemberYears& member : members) {
        for (const LossRow& loss : member.losses) {
            begin_row(row, names, member.member, loss.year);
            row.text(forest::name_of(loss.cause)).text(species_of(names, loss.species));
            row.number<3>(loss.loss.stems_pha).number<4>(loss.loss.volume_m3pha);
            row.number<4>(loss.loss.above_ground_tpha);
            row.end();
        }
    }
}

void write_trees(std::ostream& out, const Names& names, std::span<const MemberYears> members,
                 std::int32_t year) {
    TableRows row{out, yearly_layouts(), "trees_0.csv"};
    for (const MemberYears& member : members) {
        for (const TreeRow& tree : member.trees) {
            if (tree.year != year) {
                continue;
            }
            begin_row(row, names, member.member, year);
            row.whole(tree.tree).number<2>(tree.x_m).number<2>(tree.y_m);
            row.text(species_of(names, tree.species)).number<2>(tree.dbh_cm).number<2>(tree.height_m);
            row.number<2>(tree.crown_base_m).number<2>(tree.crown_radius_m).number<1>(tree.age_years);
            row.number<3>(tree.light_ratio).number<3>(tree.vitality).whole(tree.stems);
            row.whole(tree.rock_hits).number<2>(tree.rock_energy_kj);
            row.end();
        }
    }
}

}  // namespace

std::string Names::course_name(std::size_t course) const {
    const std::string& regime = regimes[regime_of(course)];
    return climates.size() > 1 ? joined(regime, ", ", climates[climate_of(course)]) : regime;
}

std::string Names::course_folder(std::size_t course) const {
    const std::string& regime = regimes[regime_of(course)];
    return climates.size() > 1 ? joined(regime, "/", climates[climate_of(course)]) : regime;
}

void begin_row(CsvRow& row, const Names& names, const Member& member, std::int32_t year) {
    row.text(names.regimes[member.regime])
        .text(names.climates[member.climate])
        .whole(member.replicate + 1)
        .whole(static_cast<std::uint32_t>(year));
}

void add_unit(CsvRow& row, std::uint32_t unit) {
    unit == all ? row.text("all") : row.whole(unit);
}

void add_dbh_class(CsvRow& row, std::size_t dbh_class) {
    row.number<0>(forest::dbh_class_cm * static_cast<double>(dbh_class));
    if (dbh_class + 1 == forest::dbh_classes) {
        row.empty();
    } else {
        row.number<0>(forest::dbh_class_cm * static_cast<double>(dbh_class + 1));
    }
}

std::vector<WrittenFile> write_forest_tables(const std::filesystem::path& folder, const Names& names,
                                             std::span<const MemberYears> members,
                                             std::span<const int> tree_list_years) {
    std::vector<WrittenFile> written;
    const auto write = [&](const std::string& name, const std::string& sentence,
                           const std::function<void(std::ostream&)>& fill) {
        written.push_back(write_table(folder, name, sentence, fill));
    };
    write("stands.csv", "What stands each year, by species and stand: stems, basal area, volume, heights.",
          [&](std::ostream& out) { write_stands(out, names, members); });
    write("dbh_classes.csv", "Stems by species and diameter class of 4 cm each year.",
          [&](std::ostream& out) { write_dbh_classes(out, names, members); });
    write("forest_years.csv",
          "Growth, ingrowth, saplings, dead wood, water, weather and the budget of wood of each year.",
          [&](std::ostream& out) { write_years(out, names, members); });
    write("mortality.csv", "Trees that left the forest each year, by cause.",
          [&](std::ostream& out) { write_losses(out, names, members); });
    for (const int year : tree_list_years) {
        const std::string number = std::to_string(year);
        write(joined("trees_", number, ".csv"),
              joined("Every tree in year ", number, year == 0 ? ", the start." : ", at its end."),
              [&](std::ostream& out) { write_trees(out, names, members, year); });
    }
    return written;
}

}  // namespace coupling::decades
