#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/assessments/decades/tables/member_columns.hpp"

namespace coupling::decades {
namespace {

/// The figure that a row speaks of, of a course in a year.
struct FigureOfCourse {
    const Names& names;
    std::size_t course;
    const Series& series;
    std::int32_t year;
};
struct FoundBandRow : FigureOfCourse {
    OverReplicates found;
};
struct DifferenceRow : FigureOfCourse {
    const std::string& reference;  ///< what the course is compared with
    PairedDifference found;
};

template <class Row>
ColumnsOf<Row> series_columns() {
    return {{"target_id", "target of the figure; empty for figures of the forest", "input targets.file",
             [](const auto& row) { return &row.series.target; }},
            {"quantity", "the figure, its unit at the end, such as protection_percent", "definition",
             [](const auto& row) { return &row.series.quantity; }}};
}

constexpr auto year_of_row = [](const auto& row) { return row.year; };

ColumnsOf<FoundBandRow> band_columns() {
    constexpr const char* over_replicates = "over the replicates";
    constexpr const char* students_t = "over the replicates, Student's t; from five on Hall (1992)";
    constexpr const char* unit = "as the quantity says";
    return {
        {"replicates", "replicates that know the figure", over_replicates,
         [](const auto& row) { return row.found.replicates; }},
        {ColumnsOf<Band>{
             {"mean", unit, 3,
              "mean of the replicates; of protection that of the rocks of all replicates together",
              over_replicates, &Band::mean},
             {"mean_low_90", unit, 3,
              "lower end of the 90 % interval of the mean; empty for one replicate and where all are equal",
              students_t, &Band::low},
             {"mean_high_90", unit, 3, "upper end of the same", students_t, &Band::high},
             {"low_5", unit, 3,
              "5th percentile of the replicates, linearly interpolated; empty for fewer than ten",
              over_replicates, &Band::p05},
             {"high_95", unit, 3, "95th percentile, likewise", over_replicates, &Band::p95},
             {"least", unit, 3, "lowest replicate", over_replicates, &Band::least},
             {"most", unit, 3, "highest replicate", over_replicates, &Band::most}},
         [](const FoundBandRow& row) -> const Band& { return row.found.band; }}};
}

TableOf<FoundBandRow> regimes_by_year() {
    return {"regimes_by_year.csv",
            "Each regime in each year: mean of the replicates, its 90 % interval and their range.",
            "a figure of a regime in a year",
            {course_columns<FoundBandRow>(climate_or_settings),
             series_columns<FoundBandRow>(),
             {year_column(), year_of_row},
             band_columns()}};
}

TableOf<FoundBandRow> regimes_worst_year() {
    return {
        "regimes_worst_year.csv",
        "The year in which each regime is worst, by the mean of its replicates.",
        "a figure of a regime in its worst year",
        {course_columns<FoundBandRow>(climate_or_settings),
         series_columns<FoundBandRow>(),
         {"worst", "lowest or highest: which extreme is bad", "definition",
          [](const auto& row) { return row.series.low_is_bad ? "lowest" : "highest"; }},
         {"year", "the year in which the mean of the replicates is worst; the first of several", year_of_row},
         band_columns()}};
}

ColumnsOf<DifferenceRow> difference_columns(const Column& reference, const char* known_in_both,
                                            const char* of_what) {
    constexpr const char* paired = "pairs of replicates, Student's t";
    constexpr const char* unit = "as the quantity says";
    return {
        course_columns<DifferenceRow>(climate_or_settings),
        {reference, [](const DifferenceRow& row) { return &row.reference; }},
        series_columns<DifferenceRow>(),
        {year_column(), year_of_row},
        {ColumnsOf<PairedDifference>{
             {"pairs", known_in_both, paired, &PairedDifference::pairs},
             {"mean_difference", unit, 3, of_what, paired, &PairedDifference::mean},
             {"low_95", unit, 3, "lower end of its 95 % interval; empty for one pair", paired,
              &PairedDifference::low},
             {"high_95", unit, 3, "upper end of its 95 % interval; empty for one pair", paired,
              &PairedDifference::high},
             {"replicates_needed",
              "replicates from which on the interval of such a difference leaves 0 out; empty: not known, "
              "or more than 100 000",
              paired, [](const auto& d) { return replicates_needed(d.mean, d.deviation); }}},
         &DifferenceRow::found}};
}

TableOf<DifferenceRow> regime_differences() {
    return {"regime_differences.csv",
            "Each regime minus the first one, replicate by replicate: mean and 95 % interval.",
            "a figure of a regime in a year, minus that of the first regime in the same climate",
            difference_columns({"reference", "text", "the regime it is compared with: the first of the list",
                                "input regimes.list"},
                               "replicates that know the figure in both regimes",
                               "mean over the pairs of regime minus reference")};
}

TableOf<DifferenceRow> climate_differences() {
    return {
        "climate_differences.csv",
        "Each climate minus the first one under the same regime, replicate by replicate: mean and 95 % "
        "interval.",
        "a figure of a regime in a climate and year, minus that of the same regime in the first climate",
        difference_columns({"reference", "text", "the climate it is compared with: the first of the table",
                            "input climate.variants"},
                           "replicates that know the figure in both climates",
                           "mean over the pairs of climate minus reference")};
}

/// A course and what it is held against, by the name of that.
struct Pair {
    std::size_t course;
    std::size_t reference;
    const std::string& reference_name;
};

void add_differences(auto& rows, const Names& names, std::span<const Pair> pairs,
                     std::span<const Series> all_series) {
    for (const Pair& pair : pairs) {
        for (const Series& series : all_series) {
            for (const std::int32_t year : years_of(series)) {
                if (const auto d = difference(series, pair.course, pair.reference, year)) {
                    rows.add({{names, pair.course, series, year}, pair.reference_name, *d});
                }
            }
        }
    }
}

}  // namespace

std::vector<TableLayout> comparison_layouts() {
    return {regimes_by_year(), regimes_worst_year(), regime_differences(), climate_differences()};
}

std::vector<WrittenFile> write_comparison(const std::filesystem::path& folder, const Names& names,
                                          std::span<const Series> all_series) {
    const auto each_course = [&](const auto& add) {
        for (std::size_t course = 0; course < names.courses(); ++course) {
            for (const Series& series : all_series) {
                add(course, series);
            }
        }
    };
    const auto by_year = [&](auto& rows) {
        each_course([&](std::size_t course, const Series& series) {
            for (const std::int32_t year : years_of(series)) {
                if (const auto found = over_replicates(series, course, year)) {
                    rows.add({{names, course, series, year}, *found});
                }
            }
        });
    };
    const auto worst = [&](auto& rows) {
        each_course([&](std::size_t course, const Series& series) {
            const auto found = series.has_worst ? worst_year(series, course) : std::nullopt;
            if (found) {
                rows.add({{names, course, series, found->year}, found->value});
            }
        });
    };
    std::vector<WrittenFile> written{regimes_by_year().write(folder, by_year),
                                     regimes_worst_year().write(folder, worst)};
    std::vector<Pair> regimes;
    std::vector<Pair> climates;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        const std::size_t regime = names.regime_of(course);
        const std::size_t climate = names.climate_of(course);
        if (regime > 0) {
            regimes.push_back({course, names.course(0, climate), names.regimes.front()});
        }
        if (climate > 0) {
            climates.push_back({course, names.course(regime, 0), names.climates.front()});
        }
    }
    if (!regimes.empty()) {
        written.push_back(regime_differences().write(
            folder, [&](auto& rows) { add_differences(rows, names, regimes, all_series); }));
    }
    if (!climates.empty()) {
        written.push_back(climate_differences().write(
            folder, [&](auto& rows) { add_differences(rows, names, climates, all_series); }));
    }
    return written;
}

}  // namespace coupling::decades
