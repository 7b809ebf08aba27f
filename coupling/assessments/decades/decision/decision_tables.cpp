#include "coupling/assessments/decades/decision/decision_tables.hpp"

#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {
namespace {

constexpr const char* of_replicates = "over the replicates";
constexpr const char* students_t = "over the replicates, Student's t, 90 %";
constexpr const char* exact = "Clopper & Pearson 1934, 90 %";
constexpr const char* paired = "pairs of replicates, Student's t, 95 %";

std::vector<Column> where_columns() {
    return {{"regime", "text", "name of the regime", "input regimes.list"},
            {"climate", "text", "name of the climate", "input climate.variants"},
            {"target_id", "text", "what is protected", "input targets.file"}};
}

/// A mean with its interval.
void add_mean(std::vector<Column>& columns, const std::string& name, const char* unit, const char* meaning) {
    columns.push_back({name, unit, meaning, of_replicates});
    columns.push_back({name + "_low_90", unit, "lower end of its 90 % interval", students_t});
    columns.push_back({name + "_high_90", unit, "upper end of its 90 % interval", students_t});
}

CsvRow& begin(CsvRow& row, const Names& names, std::size_t course, const std::string& target) {
    return row.text(names.regimes[names.regime_of(course)])
        .text(names.climates[names.climate_of(course)])
        .text(target);
}

template <int decimals>
void add(CsvRow& row, const Band& band) {
    row.number<decimals>(band.mean).template number<decimals>(band.low).template number<decimals>(band.high);
}

void add_whole(CsvRow& row, const std::optional<std::size_t>& value) {
    value ? row.whole(*value) : row.empty();
}

template <int decimals>
void add(CsvRow& row, const std::optional<PairedDifference>& difference) {
    if (!difference) {
        row.empty().empty().empty().empty();
        return;
    }
    row.number<decimals>(difference->mean).template number<decimals>(difference->low);
    row.number<decimals>(difference->high);
    add_whole(row, replicates_needed(difference->mean, difference->deviation));
}

void add(CsvRow& row, const KeptShare& share) {
    row.whole(share.replicates).whole(share.kept);
    if (share.replicates == 0) {
        row.empty().empty().empty();
    } else {
        row.number<4>(share.value()).number<4>(share.low).number<4>(share.high);
    }
}

void write_rows(std::ostream& out, const Names& names, const Decision& decision) {
    TableRows row{out, decision_layout()};
    const std::size_t targets = decision.at_targets.size() / decision.money.size();
    for (std::size_t i = 0; i < decision.at_targets.size(); ++i) {
        const CourseAtTarget& at = decision.at_targets[i];
        begin(row, names, at.course, at.target).number<2>(decision.settings.protection_at_least_percent);
        row.number<4>(decision.settings.probability);
        row.whole(static_cast<std::uint32_t>(decision.first_year));
        row.whole(static_cast<std::uint32_t>(decision.last_year));
        add(row, at.kept);
        if (at.is_known()) {
            row.number<4>(at.kept.verdict_low).number<4>(at.kept.verdict_high);
        } else {
            row.empty().empty();
        }
        const Keeps keeps = judge(at.kept, decision.settings.probability);
        row.text(word_of(keeps));
        add_whole(row, replicates_to_judge(at.kept, decision.settings.probability, decision.chances));
        add<2>(row, at.years_below);
        add<2>(row, at.percent_years_lost);
        if (at.lowest) {
            row.whole(static_cast<std::uint32_t>(at.lowest->year));
            add<2>(row, at.lowest->value.band);
        } else {
            row.empty().empty().empty().empty();
        }
        row.number<2>(at.rock_error_percent);
        const CourseMoney& money = decision.money[at.course];
        add<3>(row, money.removed_m3pha_a_year);
        add<2>(row, money.net_eur_pha_a_year);
        add<1>(row, money.present_value_eur_pha);
        row.text(names.regimes.front());
        if (names.regime_of(at.course) == 0) {
            for (int field = 0; field < 9; ++field) {
                row.empty();
            }
        } else {
            const std::size_t reference = names.course(0, names.climate_of(at.course));
            const CourseAtTarget& other = decision.at_targets[reference * targets + i % targets];
            add<2>(row, difference_in_percent_years(at, other));
            add<1>(row, difference_in_value(money, decision.money[reference]));
            const auto cost = cost_of_a_percent_year(at, other, money, decision.money[reference]);
            cost ? row.number<2>(*cost) : row.empty();
        }
        row.end();
    }
}

void write_years(std::ostream& out, const Names& names, const Decision& decision,
                 std::span<const Series> series) {
    TableRows row{out, decision_by_year_layout()};
    for (std::size_t course = 0; course < names.courses(); ++course) {
        for (const Series& each : series) {
            if (each.quantity != "protection_percent") {
                continue;
            }
            for (const std::int32_t year : years_of(each)) {
                std::size_t known = 0;
                std::size_t kept = 0;
                for (const auto& replicate : each.values[course]) {
                    const auto found = replicate.find(year);
                    known += found != replicate.end() ? 1 : 0;
                    kept += found != replicate.end() &&
                                    found->second >= decision.settings.protection_at_least_percent
                                ? 1
                                : 0;
                }
                if (known > 0) {
                    begin(row, names, course, each.target).whole(static_cast<std::uint32_t>(year));
                    add(row, kept_share(kept, known));
                    row.end();
                }
            }
        }
    }
}

}  // namespace

TableLayout decision_layout() {
    std::vector<Column> columns = where_columns();
    const std::vector<Column> head{
        {"protection_at_least_percent", "%", "what is asked for", "input decision.protection_at_least"},
        {"probability", "-", "with which it must hold", "input decision.probability"},
        {"first_year", "-", "first year with rocks after the start", "definition"},
        {"last_year", "-", "last year with rocks", "definition"},
        {"replicates", "-", "replicates with protection figures", of_replicates},
        {"replicates_kept", "-", "of these, protection is at least as asked for in all years", of_replicates},
        {"p_kept", "-", "their share", of_replicates},
        {"p_kept_low_90", "-", "lower end of its 90 % interval", exact},
        {"p_kept_high_90", "-", "upper end of its 90 % interval", exact},
        {"verdict_low", "-",
         "lower bound of the verdict: as p_kept_low_90, but so that the verdicts on all regimes hold "
         "together "
         "with 95 %",
         exact},
        {"verdict_high", "-", "upper bound of the verdict", exact},
        {"keeps", "text",
         "yes: verdict_low is not below the probability asked for; no: verdict_high is below it; else "
         "undecided",
         exact},
        {"replicates_to_decide", "-",
         "replicates after which a share of this size would be yes or no; empty: more than 5000", exact}};
    columns.insert(columns.end(), head.begin(), head.end());
    add_mean(columns, "below_years", "years",
             "years with less protection, each year with rocks for those up to the next");
    add_mean(columns, "lost_percent_years", "% years",
             "what is missing to the protection asked for, summed over years");
    columns.push_back({"lowest_year", "-", "year after the start with the lowest mean", of_replicates});
    add_mean(columns, "lowest_percent", "%", "protection in that year");
    columns.push_back(
        {"rock_error_percent", "%",
         "half of the 95 % interval that the rocks alone leave to a year of one replicate: more "
         "rocks narrow it",
         "as in protection.csv; median"});
    add_mean(columns, "removed_m3pha_yr", "m3/ha/yr", "stem wood that left the forest");
    add_mean(columns, "net_eur_pha_yr", "EUR/ha/yr", "contribution margin");
    add_mean(columns, "present_value_eur_pha", "EUR/ha",
             "contribution margins of all years, discounted to the start by decision.discount_percent");
    const std::vector<Column> tail{
        {"reference", "text", "regime of the differences: the first of the list", "input regimes.list"},
        {"difference_percent_years", "% years", "percent-years lost minus those of the reference", paired},
        {"difference_percent_years_low_95", "% years", "lower end of its 95 % interval", paired},
        {"difference_percent_years_high_95", "% years", "upper end of its 95 % interval", paired},
        {"percent_years_replicates_needed", "-", "replicates to tell the two apart; empty: not known",
         paired},
        {"present_value_difference_eur_pha", "EUR/ha", "present value minus that of the reference", paired},
        {"present_value_difference_eur_pha_low_95", "EUR/ha", "lower end of its 95 % interval", paired},
        {"present_value_difference_eur_pha_high_95", "EUR/ha", "upper end of its 95 % interval", paired},
        {"present_value_replicates_needed", "-", "replicates to tell the two apart; empty: not known",
         paired},
        {"eur_per_percent_year", "EUR/ha/(% yr)",
         "present value given up for a percent-year kept, against the reference; empty where the gain is not "
         "known to differ from 0",
         "ratio of the two means"}};
    columns.insert(columns.end(), tail.begin(), tail.end());
    return {"decision.csv", "a regime in a climate at a target", columns};
}

TableLayout decision_by_year_layout() {
    std::vector<Column> columns = where_columns();
    const std::vector<Column> rest{
        {"year", "-", "simulated year; 0 is the start", "definition"},
        {"replicates", "-", "replicates with a protection figure", of_replicates},
        {"replicates_kept", "-", "of these, protection is at least as asked for", of_replicates},
        {"p_kept", "-", "their share", of_replicates},
        {"p_kept_low_90", "-", "lower end of its 90 % interval", exact},
        {"p_kept_high_90", "-", "upper end of its 90 % interval", exact}};
    columns.insert(columns.end(), rest.begin(), rest.end());
    return {"decision_by_year.csv", "a regime in a climate at a target in a year with rocks", columns};
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
                                        const Decision& decision, std::span<const Series> series) {
    return {write_table(folder, "decision.csv",
                        "Whether each regime keeps the protection asked for, in each climate, with timber, "
                        "money and differences.",
                        [&](std::ostream& out) { write_rows(out, names, decision); }),
            write_table(folder, "decision_by_year.csv",
                        "The share of replicates that keep the protection asked for, year by year.",
                        [&](std::ostream& out) { write_years(out, names, decision, series); })};
}

}  // namespace coupling::decades
