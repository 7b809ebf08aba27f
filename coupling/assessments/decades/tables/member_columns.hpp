#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <type_traits>

#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::decades {

/// A record of a member as a row of a table: its members are those of the record. What a `Record` says of the
/// year stands in its `year`.
template <class Record>
struct MemberRow : Record {
    const Names& names;
    std::size_t course;
    std::uint32_t replicate;  ///< from 0
};
template <class Record>
using MemberTable = TableOf<MemberRow<Record>>;

inline constexpr const char* any_climate = "name of the climate";
inline constexpr const char* climate_or_settings =
    "name of the climate; as_given: the only one, that of the settings";

/// Regime and climate of a row that has `names` and a `course`.
template <class Row>
ColumnsOf<Row> course_columns(const char* climate = any_climate) {
    using Text = const std::string&;
    return {{"regime", "name of the regime", "input regimes.list",
             [](const Row& row) -> Text { return row.names.regimes[row.names.regime_of(row.course)]; }},
            {"climate", climate, "input climate.variants",
             [](const Row& row) -> Text { return row.names.climates[row.names.climate_of(row.course)]; }}};
}

inline Column year_column() {
    return {"year", "-", "simulated years since the start; 0 is the start", from_simulation};
}

/// Which member and year a row speaks of: regime, climate, replicate (counted from 1, as people do) and year.
template <class Record>
ColumnsOf<MemberRow<Record>> member_columns() {
    return {course_columns<MemberRow<Record>>(climate_or_settings),
            {"replicate",
             "number of the replicate, from 1; regimes share weather and rocks of a replicate, climates its "
             "rocks and chance",
             "run.replicates", [](const auto& row) { return row.replicate + 1; }},
            {year_column(), [](const auto& row) { return row.year; }}};
}

/// A management unit or "all".
template <class Record>
ColumnsOf<MemberRow<Record>> unit_column() {
    return {"stand", "number of the management unit, or all for the whole forest", "input stands.map",
            [](const auto& row) { return row.unit == all ? std::string{"all"} : std::to_string(row.unit); }};
}

/// A species by its code, or "all".
template <class Record>
ColumnsOf<MemberRow<Record>> species_column(const char* meaning = "species code") {
    return {"species", meaning, "species table", [](const auto& row) {
                return row.species == all ? std::string_view{"all"}
                                          : row.names.species.all()[row.species].code;
            }};
}

/// Both ends of the `dbh_class` of a record; the last one is open.
template <class Record>
ColumnsOf<MemberRow<Record>> dbh_class_columns() {
    return {{"dbh_from_cm", 0, "lower end of the class of diameter at breast height", "classes of 4 cm",
             [](const auto& row) { return forest::dbh_class_cm * static_cast<double>(row.dbh_class); }},
            {"dbh_to_cm", 0, "upper end of the class; empty: everything thicker", "classes of 4 cm",
             [](const auto& row) {
                 const std::size_t next = row.dbh_class + 1;
                 return next == forest::dbh_classes
                            ? std::nullopt
                            : std::optional{forest::dbh_class_cm * static_cast<double>(next)};
             }}};
}

/// A tree: number, place, species and size.
template <class Record>
ColumnsOf<MemberRow<Record>> tree_columns() {
    constexpr const char* given = "input trees.file, or simulated";
    return {{"tree_id", "number of the tree, kept for its life", &Record::tree},
            {"x_m", 2, "easting of the stem", given, &Record::x_m},
            {"y_m", 2, "northing of the stem", given, &Record::y_m},
            species_column<Record>(),
            {"dbh_cm", 2, "diameter at breast height", &Record::dbh_cm},
            {"height_m", 2, "height of the tree", &Record::height_m}};
}

/// The rows of all members in their order: one for each record of a list of theirs (&MemberYears::stands), or
/// what `each(member, add)` adds.
template <class Each>
auto member_rows(const Names& names, std::span<const MemberYears> members, Each each) {
    return [&names, members, each](auto& rows) {
        for (const MemberYears& member : members) {
            const auto add = [&](const auto& record) {
                rows.add({record, names, names.course_of(member.member), member.member.replicate});
            };
            if constexpr (std::is_member_object_pointer_v<Each>) {
                std::ranges::for_each(member.*each, add);
            } else {
                each(member, add);
            }
        }
    };
}

/// A figure of a course at a target in a year, all replicates together, as a row of a table.
template <class Record>
struct TargetOfCourse : Record {
    const Names& names;
    std::size_t course;
    std::int32_t year;
    const std::string& target;  ///< its id
};

template <class Record>
ColumnsOf<TargetOfCourse<Record>> target_of_course_columns() {
    return {course_columns<TargetOfCourse<Record>>(),
            {year_column(), [](const auto& row) { return row.year; }},
            {"target_id", "target", "input targets.file", [](const auto& row) { return &row.target; }}};
}

/// What `find(names, members, course, target, year)` knows of every course, year with rocks and target.
template <class Find>
auto rows_at_targets(const Names& names, const Site& site, std::span<const MemberYears> members, Find find) {
    return [&names, &site, members, find](auto& rows) {
        std::set<std::int32_t> years;
        for (const MemberYears& member : members) {
            for (const TargetRow& row : member.targets) {
                years.insert(row.year);
            }
        }
        for (std::size_t course = 0; course < names.courses(); ++course) {
            for (const std::int32_t year : years) {
                for (std::uint32_t target = 0; target < site.targets.size(); ++target) {
                    if (const auto found = find(names, members, course, target, year)) {
                        rows.add({*found, names, course, year, site.targets[target].id});
                    }
                }
            }
        }
    };
}

}  // namespace coupling::decades
