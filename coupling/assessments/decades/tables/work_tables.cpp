#include "coupling/assessments/decades/tables/work_tables.hpp"

#include <algorithm>
#include <functional>

#include "coupling/assessments/decades/tables/yearly_layouts.hpp"
#include "coupling/assessments/decades/tables/yearly_work.hpp"
#include "coupling/inputs/tables/csv_row.hpp"

namespace coupling::decades {
namespace {

void write_interventions(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "interventions.csv"};
    for (const MemberYears& member : members) {
        for (const HarvestRow& work : member.harvest) {
            begin_row(row, names, member.member, work.year);
            const auto& [name, treatment] = names.interventions[member.member.regime][work.intervention];
            row.text(name).text(treatment).whole(work.areas).number<4>(work.area_ha);
            row.number<0>(work.stems).number<3>(work.taken_m3).number<3>(work.left_m3);
            row.whole(work.plants)
                .whole(work.guarded)
                .whole(work.tended)
                .number<4>(work.fenced_ha)
                .text(work.found_nothing ? "yes" : "no");
            row.end();
        }
    }
}

void write_timber(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "timber.csv"};
    for (const MemberYears& member : members) {
        for (const TimberRow& timber : member.timber) {
            begin_row(row, names, member.member, timber.year);
            row.text(names.species.all()[timber.species].code);
            add_dbh_class(row, timber.dbh_class);
            row.number<0>(timber.timber.stems).number<3>(timber.timber.taken_m3);
            row.number<3>(timber.timber.left_m3);
            row.end();
        }
    }
}

void write_margins(std::ostream& out, const Names& names, std::span<const MemberYears> members,
                   double area_ha) {
    TableRows row{out, yearly_layouts(), "margins.csv"};
    for (const MemberYears& member : members) {
        for (const MarginRow& year : member.margins) {
            begin_row(row, names, member.member, year.year);
            row.number<2>(year.margin.revenue_eur / area_ha).number<2>(year.margin.harvest_eur / area_ha);
            row.number<2>(year.margin.young_eur / area_ha);
            row.number<2>(year.margin.contribution_eur() / area_ha);
            row.end();
        }
    }
}

void write_work_by_year(std::ostream& out, const Names& names, std::span<const MemberYears> members,
                        double area_ha) {
    TableRows row{out, yearly_layouts(), "work_by_year.csv"};
    for (const MemberYears& member : members) {
        const std::vector<YearlyWork> years = work_by_year(names, member, area_ha);
        for (std::size_t year = 0; year < years.size(); ++year) {
            const YearlyWork& work = years[year];
            begin_row(row, names, member.member, static_cast<std::int32_t>(year));
            row.number<4>(work.felled_m3pha).number<4>(work.salvaged_m3pha);
            row.number<4>(work.removed_m3pha).number<4>(work.left_m3pha);
            row.number<2>(work.revenue_eur_pha).number<2>(work.harvest_cost_eur_pha);
            row.number<2>(work.young_cost_eur_pha).number<2>(work.margin_eur_pha());
            row.number<3>(work.machine_hours_pha).number<0>(work.cable_setups);
            row.end();
        }
    }
}

void write_removed(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "removed_trees.csv"};
    for (const MemberYears& member : members) {
        for (const RemovedRow& tree : member.removed) {
            begin_row(row, names, member.member, tree.year);
            row.whole(tree.tree).number<2>(tree.x_m).number<2>(tree.y_m);
            row.text(names.species.all()[tree.species].code).number<2>(tree.dbh_cm).number<2>(tree.height_m);
            row.text(forest::name_of(tree.cause));
            row.end();
        }
    }
}

template <class Row>
bool any(std::span<const MemberYears> members, std::vector<Row> MemberYears::*rows) {
    return std::any_of(members.begin(), members.end(),
                       [&](const MemberYears& member) { return !(member.*rows).empty(); });
}

}  // namespace

std::vector<WrittenFile> write_work_tables(const std::filesystem::path& folder, const Names& names,
                                           std::span<const MemberYears> members, double area_ha) {
    std::vector<WrittenFile> written;
    const auto write = [&](const std::string& name, const std::string& sentence,
                           const std::function<void(std::ostream&)>& fill) {
        written.push_back(write_table(folder, name, sentence, fill));
    };
    if (any(members, &MemberYears::harvest)) {
        write("interventions.csv", "What people did each year, and what was due but found nothing to do.",
              [&](std::ostream& out) { write_interventions(out, names, members); });
        write("timber.csv", "Felled wood by species and diameter class: taken and left.",
              [&](std::ostream& out) { write_timber(out, names, members); });
        write("margins.csv", "Revenue, costs and contribution margin of each year with work, per hectare.",
              [&](std::ostream& out) { write_margins(out, names, members, area_ha); });
    }
    write("work_by_year.csv",
          "Wood felled, salvaged, removed and left, revenue and costs of each year, per hectare.",
          [&](std::ostream& out) { write_work_by_year(out, names, members, area_ha); });
    if (any(members, &MemberYears::removed)) {
        write("removed_trees.csv",
              "Trees of 7 cm and more that left the forest, each with its cause: those that rocks broke or "
              "uprooted (rock) or that died of old wounds (wound); on demand all.",
              [&](std::ostream& out) { write_removed(out, names, members); });
    }
    return written;
}

}  // namespace coupling::decades
