#include "coupling/assessments/decades/risk/risk_years_table.hpp"

#include "config/text/joined.hpp"
#include "coupling/assessments/consequences/quantity_columns.hpp"
#include "coupling/assessments/decades/tables/member_columns.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::decades {
namespace {

using config::joined;

/// A place on a slope in a year of a course.
struct RiskOfYear {
    const Names& names;
    std::size_t course;
    const RiskOverYears& risk;
    const std::string& place;
    Cover cover;
    std::int32_t year;
    RiskBands found;
};

ColumnsOf<RiskOfYear> band_columns_of(const consequences::QuantityColumn& column) {
    constexpr const char* mean_of = "mean over the replicates, coupling/assessments/consequences/README.md";
    constexpr const char* interval = "over the replicates, Student's t; from five on Hall (1992)";
    const auto part = [&](const char* infix, const std::string& meaning, const char* source,
                          double Band::*of) {
        return ColumnsOf<RiskOfYear>{
            Column{joined(column.name, "_per_year", infix), column.unit, meaning, source}, as_given,
            [quantity = column.quantity, of](const RiskOfYear& row) {
                return consequences::six_digits(row.found.at(quantity).*of);
            }};
    };
    return {
        part("", column.meaning, mean_of, &Band::mean),
        part("_low_90",
             "lower end of the 90 % interval of the mean; empty for one replicate and where all are equal",
             interval, &Band::low),
        part("_high_90", "upper end of the same", interval, &Band::high)};
}

ColumnsOf<RiskOfYear> all_band_columns() {
    ColumnsOf<RiskOfYear> columns;
    for (const consequences::QuantityColumn& column : consequences::counted_columns) {
        columns += band_columns_of(column);
    }
    columns += band_columns_of(consequences::individual_column);
    return columns;
}

TableOf<RiskOfYear> risk_by_year() {
    return {
        "risk_by_year.csv",
        "The risk of each exposed target and of all together under each regime, year by year, with forest "
        "and on the bare slope.",
        "a place on a slope under a regime in a year with rocks",
        {course_columns<RiskOfYear>(),
         {"target_id", "exposed target, or all: the sum over them", "input targets.file",
          [](const RiskOfYear& row) { return &row.place; }},
         {cover_column(), [](const RiskOfYear& row) { return name_of(row.cover); }},
         {year_column(), [](const RiskOfYear& row) { return row.year; }},
         {"replicates", "replicates that know the figures", "over the replicates",
          [](const RiskOfYear& row) { return row.found.replicates; }},
         all_band_columns(),
         {Column{"rocks_per_year", "-", "rocks that really start in a year on the whole slope",
                 "input risk.rocks_per_year or feedback.rocks_per_year"},
          as_given, [](const RiskOfYear& row) { return row.risk.rocks_per_year; }},
         {"currency", "of all amounts", "input risk.currency",
          [](const RiskOfYear& row) { return &row.risk.plan.settings.currency; }}}};
}

}  // namespace

TableLayout risk_by_year_layout() {
    return risk_by_year();
}

WrittenFile write_risk_by_year(const std::filesystem::path& folder, const Names& names,
                               const RiskOverYears& risk) {
    return risk_by_year().write(folder, [&](auto& rows) {
        const auto add_place = [&](std::size_t course, const RiskAtPlace& place) {
            for (const Cover cover : {Cover::forest, Cover::bare}) {
                for (const std::int32_t year : years_of(place)) {
                    if (const auto found = risk_in_year(place, cover, course, year)) {
                        rows.add({names, course, risk, place.id, cover, year, *found});
                    }
                }
            }
        };
        for (std::size_t course = 0; course < names.courses(); ++course) {
            for (const RiskAtPlace& place : risk.targets) {
                add_place(course, place);
            }
            add_place(course, risk.all);
        }
    });
}

}  // namespace coupling::decades
