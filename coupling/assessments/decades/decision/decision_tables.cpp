#include "coupling/assessments/decades/decision/decision_tables.hpp"

#include "coupling/assessments/decades/tables/member_columns.hpp"

namespace coupling::decades {
namespace {

constexpr const char* over_replicates = "over the replicates";
constexpr const char* students_t = "over the replicates, Student's t, 90 %";
constexpr const char* by_model = "state-space model of the years (decision/course_law)";
constexpr const char* of_courses = "tables/decision_courses.csv: sum over years, mean of the replicates";
constexpr const char* exact = "Clopper & Pearson 1934, 90 %";
constexpr const char* paired = "pairs of replicates, Student's t, 95 %";

/// Nothing where no replicate has a figure.
constexpr auto if_known = [](const KeptShare& share) { return share.replicates > 0 ? &share : nullptr; };

/// A course at a target, with its differences to the first regime in the same climate where it is another.
struct DecisionRow {
    const Names& names;
    std::size_t course;
    const std::string& target;
    const Decision& decision;
    const CourseAtTarget& at;
    const CourseMoney& money;
    std::optional<PairedDifference> in_percent_years{};
    std::optional<PairedDifference> in_value{};
    std::optional<double> cost{};
    const CourseRisk* risk = nullptr;
};

/// A course at a target in a year.
struct KeptInYear {
    const Names& names;
    std::size_t course;
    const std::string& target;
    std::int32_t year;
    KeptShare kept;
};

template <class Row>
ColumnsOf<Row> where_columns() {
    return {
        course_columns<Row>(),
        {"target_id", "what is protected", "input targets.file", [](const Row& row) { return &row.target; }}};
}

/// In how many replicates protection was kept.
ColumnsOf<KeptShare> kept_columns(const char* known, const char* kept) {
    return {{"replicates", known, over_replicates, &KeptShare::replicates},
            {"replicates_kept", kept, over_replicates, &KeptShare::kept},
            {ColumnsOf<KeptShare>{
                 {"p_kept", 4, "their share", over_replicates, [](const auto& k) { return k.value(); }},
                 {"p_kept_low_90", 4, "lower end of its 90 % interval", exact, &KeptShare::low},
                 {"p_kept_high_90", 4, "upper end of its 90 % interval", exact, &KeptShare::high}},
             if_known}};
}

/// A mean with its interval.
ColumnsOf<Band> mean_columns(const std::string& name, int decimals, const char* meaning,
                             const char* source = over_replicates, const char* of_interval = students_t) {
    return {{name, decimals, meaning, source, &Band::mean},
            {name + "_low_90", decimals, "lower end of its 90 % interval", of_interval, &Band::low},
            {name + "_high_90", decimals, "upper end of its 90 % interval", of_interval, &Band::high}};
}

/// The same without the noise of the rocks.
ColumnsOf<Band> drawn_columns(const std::string& name, int decimals, const char* meaning) {
    return mean_columns(name, decimals, meaning, of_courses, by_model);
}

ColumnsOf<PairedDifference> difference_columns(const std::string& name, int decimals, const char* meaning,
                                               const char* needed) {
    return {{name, decimals, meaning, paired, &PairedDifference::mean},
            {name + "_low_95", decimals, "lower end of its 95 % interval", paired, &PairedDifference::low},
            {name + "_high_95", decimals, "upper end of its 95 % interval", paired, &PairedDifference::high},
            {needed, "replicates to tell the two apart; empty: not known", paired,
             [](const auto& d) { return replicates_needed(d.mean, d.deviation); }}};
}

/// The probability of the worst year.
ColumnsOf<WorstYear> worst_columns() {
    return {
        {"p_keeps", 4,
         "probability that the worst year keeps it, without the noise of the rocks; empty: fewer than six "
         "replicates",
         by_model, [](const auto& worst) { return worst.median(); }},
        {"p_keeps_low_90", 4, "lower end of its 90 % interval", by_model,
         [](const auto& worst) { return worst.at(0.05); }},
        {"p_keeps_high_90", 4, "upper end of its 90 % interval", by_model,
         [](const auto& worst) { return worst.at(0.95); }}};
}

/// What is asked for, and whether it is kept.
ColumnsOf<DecisionRow> verdict_columns() {
    const auto of_kept = [](const DecisionRow& row) -> const KeptShare& { return row.at.kept; };
    const auto of_worst = [](const DecisionRow& row) { return row.at.worst(); };
    return {{"protection_at_least_percent", 2, "what is asked for", "input decision.protection_at_least",
             [](const auto& row) { return row.decision.settings.protection_at_least_percent; }},
            {"probability", 4, "with which it must hold", "input decision.probability",
             [](const auto& row) { return row.decision.settings.probability; }},
            {"first_year", "first year with rocks after the start", "definition",
             [](const auto& row) { return row.decision.first_year; }},
            {"last_year", "last year with rocks", "definition",
             [](const auto& row) { return row.decision.last_year; }},
            {kept_columns("replicates with protection figures",
                          "of these, protection is at least as asked for in all years"),
             of_kept},
            {ColumnsOf<KeptShare>{ColumnsOf<KeptShare>{{"verdict_low", 4,
                                                        "lower bound of the verdict: as p_kept_low_90, but "
                                                        "so that the verdicts on all regimes hold "
                                                        "together with 95 %",
                                                        exact, &KeptShare::verdict_low},
                                                       {"verdict_high", 4, "upper bound of the verdict",
                                                        exact, &KeptShare::verdict_high}},
                                  if_known},
             of_kept},
            {worst_columns(), of_worst},
            {"keeps",
             "yes: protection is kept with the probability asked for; no: it is not; undecided: more "
             "replicates would tell; the verdicts on all regimes hold together with 95 %",
             "verdict_low, verdict_high, the margin of the replicates and p_keeps; undecided too where no "
             "rocks fall after a cut",
             [](const auto& row) { return word_of(row.decision.at_target(row.names, row.at)); }},
            {"replicates_to_decide",
             "replicates after which a share of this size would be yes or no; empty: more than 5000", exact,
             [](const auto& row) {
                 return replicates_to_judge(row.at.kept, row.decision.settings.probability,
                                            row.decision.chances);
             }}};
}

ColumnsOf<Extreme> lowest_columns() {
    return {{"lowest_year", "year after the start with the lowest mean", of_courses, &Extreme::year},
            {drawn_columns("lowest_percent", 2,
                           "protection in that year without the noise of the rocks; replicates count by the "
                           "rocks that arrive over the bare slope"),
             [](const Extreme& lowest) -> const Band& { return lowest.value.band; }}};
}

TableOf<DecisionRow> decisions() {
    constexpr const char* net = "contribution margin";
    return {
        "decision.csv",
        "Whether each regime keeps the protection asked for, in each climate, with timber, money and "
        "differences.",
        "a regime in a climate at a target",
        {where_columns<DecisionRow>(),
         verdict_columns(),
         {drawn_columns("below_years", 2,
                        "years with less protection, each year with rocks for those since the one before, "
                        "without the noise of the rocks"),
          [](const auto& row) -> const Band& { return row.at.forest.years_below; }},
         {drawn_columns(
              "lost_percent_years", 2,
              "what is missing to the protection asked for, summed over years; the last one stands for "
              "decision.years_beyond more; without the noise of the rocks"),
          [](const auto& row) -> const Band& { return row.at.forest.percent_years_lost; }},
         {lowest_columns(), [](const auto& row) { return row.at.forest.lowest; }},
         {"rock_error_percent", 2,
          "half of the 95 % interval that the rocks alone leave to a year of one replicate: more rocks "
          "narrow "
          "it",
          "as in protection.csv; median", [](const auto& row) { return row.at.rock_error_percent; }},
         {mean_columns("removed_m3pha_yr", 3, "stem wood that left the forest"),
          [](const auto& row) -> const Band& { return row.money.removed_m3pha_a_year; }},
         {mean_columns("net_eur_pha_yr", 2, net),
          [](const auto& row) -> const Band& { return row.money.net_eur_pha_a_year; }},
         {mean_columns("present_value_eur_pha", 1,
                       "contribution margins of all years, and the standing trees of the end less those of "
                       "the start, discounted to the start by decision.discount_percent"),
          [](const auto& row) -> const Band& { return row.money.present_value_eur_pha; }},
         {mean_columns("work_value_eur_pha", 1, "of the present value, contribution margins"),
          [](const auto& row) -> const Band& { return row.money.work_value_eur_pha; }},
         {mean_columns("stock_value_eur_pha", 1,
                       "of the present value, standing trees: standing_value_eur_pha of the last year, "
                       "discounted, less that of the start"),
          [](const auto& row) -> const Band& { return row.money.stock_value_eur_pha; }},
         {"reference", "regime of the differences: the first of the list", "input regimes.list",
          [](const auto& row) { return &row.names.regimes.front(); }},
         {difference_columns("difference_percent_years", 2, "percent-years lost minus those of the reference",
                             "percent_years_replicates_needed"),
          &DecisionRow::in_percent_years},
         {difference_columns("present_value_difference_eur_pha", 1,
                             "present value minus that of the reference", "present_value_replicates_needed"),
          &DecisionRow::in_value},
         {"eur_per_percent_year", "EUR/ha/(% yr)", 2,
          "present value given up for a percent-year kept, against the reference; empty where the gain is "
          "not "
          "known to differ from 0",
          "ratio of the two means", &DecisionRow::cost},
         {course_risk_columns(), &DecisionRow::risk}}};
}

TableOf<KeptInYear> decisions_by_year() {
    return {"decision_by_year.csv",
            "The share of replicates that keep the protection asked for, year by year.",
            "a regime in a climate at a target in a year with rocks",
            {where_columns<KeptInYear>(),
             {"year", "simulated year; 0 is the start", "definition", &KeptInYear::year},
             {kept_columns("replicates with a protection figure",
                           "of these, protection is at least as asked for"),
              &KeptInYear::kept}}};
}

/// A replicate of a course at a target in a year, behind its rocks.
struct ForestYearRow {
    const Names& names;
    std::size_t course;
    const std::string& target;
    std::size_t replicate;
    double weight;
    const ForestYear& at;
};

TableOf<ForestYearRow> decision_courses() {
    return {
        "decision_courses.csv",
        "What the protection of each replicate is without the noise of its rocks, year by year: the sums "
        "over years are the figures of decision.csv.",
        "a replicate of a regime in a climate at a target in a year with rocks after the start",
        {where_columns<ForestYearRow>(),
         {"replicate", "number of the replicate, from 1", "run.replicates",
          [](const ForestYearRow& row) { return row.replicate + 1; }},
         {"rocks_bare", 1,
          "rocks that arrive over the bare slope in a year on average: what the replicate counts in the "
          "mean of lowest_percent of decision.csv",
          by_model, &ForestYearRow::weight},
         {ColumnsOf<ForestYear>{
              {"year", "simulated year", "definition", &ForestYear::year},
              {"stands_for_years", 0, "years since the year with rocks before", "definition",
               &ForestYear::stands_for_years},
              {"beyond_years", 1, "years beyond the run that the last year stands for",
               "input decision.years_beyond", &ForestYear::beyond_years},
              {"forest_percent", 3, "protection without the noise of the rocks: mean of the drawn courses",
               by_model, &ForestYear::protection_percent},
              {"p_below", 4, "probability that it is below what is asked for", by_model,
               &ForestYear::p_below},
              {"missing_percent", 4,
               "what is missing to what is asked for on average, 0 where nothing is: times years the "
               "percent-years lost",
               by_model, &ForestYear::missing_percent}},
          [](const ForestYearRow& row) -> const ForestYear& { return row.at; }}}};
}

void add_courses(auto& rows, const Names& names, const Decision& decision) {
    for (const CourseAtTarget& at : decision.at_targets) {
        for (std::size_t replicate = 0; replicate < at.forest.records.size(); ++replicate) {
            if (const auto& record = at.forest.records[replicate]) {
                for (const ForestYear& year : record->years) {
                    rows.add({names, at.course, at.target, replicate, record->weight, year});
                }
            }
        }
    }
}

void add_decisions(auto& rows, const Names& names, const Decision& decision,
                   std::span<const CourseRisk> risks) {
    const std::size_t targets = decision.at_targets.size() / decision.money.size();
    for (std::size_t i = 0; i < decision.at_targets.size(); ++i) {
        const CourseAtTarget& at = decision.at_targets[i];
        const CourseMoney& money = decision.money[at.course];
        DecisionRow row{names, at.course, at.target, decision, at, money};
        row.risk = risks.empty() ? nullptr : &risks[at.course];
        if (names.regime_of(at.course) > 0) {
            const std::size_t reference = names.course(0, names.climate_of(at.course));
            const CourseAtTarget& other = decision.at_targets[reference * targets + i % targets];
            row.in_percent_years = difference_in_percent_years(at, other);
            row.in_value = difference_in_value(money, decision.money[reference]);
            row.cost = cost_of_a_percent_year(at, other, money, decision.money[reference]);
        }
        rows.add(row);
    }
}

/// In how many replicates a course keeps what is asked for in a year.
KeptShare kept_in_year(const Series& series, std::size_t course, std::int32_t year, double at_least_percent) {
    std::size_t known = 0;
    std::size_t kept = 0;
    for (const auto& replicate : series.values[course]) {
        const auto found = replicate.find(year);
        known += found != replicate.end() ? 1 : 0;
        kept += found != replicate.end() && found->second >= at_least_percent ? 1 : 0;
    }
    return known > 0 ? kept_share(kept, known) : KeptShare{};
}

void add_years(auto& rows, const Names& names, const Decision& decision, std::span<const Series> series) {
    for (std::size_t course = 0; course < names.courses(); ++course) {
        for (const Series& each : series) {
            if (each.quantity != "protection_percent") {
                continue;
            }
            for (const std::int32_t year : years_of(each)) {
                const KeptShare kept =
                    kept_in_year(each, course, year, decision.settings.protection_at_least_percent);
                if (kept.replicates > 0) {
                    rows.add({names, course, each.target, year, kept});
                }
            }
        }
    }
}

}  // namespace

std::vector<TableLayout> decision_layouts() {
    return {decisions(), decisions_by_year(), decision_courses()};
}

const char* word_of(Keeps keeps) {
    return keeps == Keeps::yes ? "yes" : keeps == Keeps::no ? "no" : "undecided";
}

std::optional<double> cost_of_a_percent_year(const CourseAtTarget& at, const CourseAtTarget& reference,
                                             const CourseMoney& money, const CourseMoney& reference_money) {
    const auto lost = difference_in_percent_years(at, reference);
    const auto value = difference_in_value(money, reference_money);
    // Fewer percent-years lost are kept.
    if (!lost || !value || !(lost->high < 0.0)) {
        return std::nullopt;
    }
    return value->mean / lost->mean;
}

std::vector<WrittenFile> write_decision(const std::filesystem::path& folder, const Names& names,
                                        const Decision& decision, std::span<const Series> series,
                                        std::span<const CourseRisk> risks) {
    return {decisions().write(folder, [&](auto& rows) { add_decisions(rows, names, decision, risks); }),
            decisions_by_year().write(folder, [&](auto& rows) { add_years(rows, names, decision, series); }),
            decision_courses().write(folder, [&](auto& rows) { add_courses(rows, names, decision); })};
}

}  // namespace coupling::decades
