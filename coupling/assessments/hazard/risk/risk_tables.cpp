#include <limits>
#include <optional>
#include <string>

#include "config/text/joined.hpp"
#include "coupling/assessments/consequences/quantity_columns.hpp"
#include "coupling/assessments/hazard/risk/risk_results.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::hazard::risk {
namespace {

using config::joined;
using consequences::counted_columns;
using consequences::individual_column;
using consequences::QuantityColumn;
using consequences::six_digits;

constexpr const char* how = "coupling/assessments/hazard/risk/README.md";
constexpr const char* from_targets = "input targets.file";
constexpr const char* from_risk = "input risk";
constexpr const char* from_curves = "risk_curves.csv or risk.curves";
constexpr const char* count = "-";
constexpr const char* amount = "as the currency says";
constexpr const char* of_rocks = " end of its 95 % interval by the chance of rocks";

/// A place or all of them on a slope.
struct PlaceRow {
    const RiskResults& results;
    const PlaceRisk& risk;
    Cover cover;

    [[nodiscard]] const SlopeRisk& slope() const { return risk.slopes[coupling::index_of(cover)]; }
};

struct ExposedRow : PlaceRow {
    const Site& site;
    const TargetRisk& target;
};

struct ClassOfTarget : ExposedRow {
    std::size_t number;

    [[nodiscard]] const CurveClass& energy() const { return results.curves.classes()[number]; }
};

template <class Row>
ColumnsOf<Row> estimate_columns(const QuantityColumn& column) {
    const auto part = [&](const char* infix, const std::string& meaning, double Estimate::*of) {
        return ColumnsOf<Row>{Column{joined(column.name, infix, "_per_year"), column.unit, meaning, how},
                              as_given, [quantity = column.quantity, of](const Row& row) {
                                  return six_digits(row.slope().at(quantity).*of);
                              }};
    };
    return {part("", column.meaning, &Estimate::value),
            part("_low", joined("lower", of_rocks), &Estimate::low),
            part("_high", joined("upper", of_rocks), &Estimate::high)};
}

template <class Row>
ColumnsOf<Row> spared_columns(const char* name, const char* unit, const char* meaning,
                              Estimate PlaceRisk::*spared) {
    const auto part = [&](const char* infix, const std::string& says, double Estimate::*of) {
        return ColumnsOf<Row>{
            Column{joined(name, infix, "_per_year"), unit, says, how}, as_given,
            [spared, of](const Row& row) {
                const bool is_known = row.results.with_forest() && row.cover == Cover::forest;
                return is_known ? six_digits(row.risk.*spared.*of) : std::numeric_limits<double>::quiet_NaN();
            }};
    };
    return {part("", meaning, &Estimate::value), part("_low", joined("lower", of_rocks), &Estimate::low),
            part("_high", joined("upper", of_rocks), &Estimate::high)};
}

template <class Row>
ColumnsOf<Row> rate_columns() {
    ColumnsOf<Row> all;
    for (const QuantityColumn& column : counted_columns) {
        all += estimate_columns<Row>(column);
    }
    const auto end_of_all = [](const char* name, const char* meaning, double Interval::*end) {
        return ColumnsOf<Row>{Column{name, amount, meaning, how}, as_given, [end](const Row& row) {
                                  const std::optional<Interval>& money = row.slope().all_money;
                                  return money ? six_digits((*money).*end)
                                               : std::numeric_limits<double>::quiet_NaN();
                              }};
    };
    all +=
        end_of_all("money_all_low_per_year",
                   "lower end of its 95 % interval by all that is not known of ground and trees, too; empty: "
                   "no parameters were drawn, or too few rocks hit",
                   &Interval::low);
    all += end_of_all("money_all_high_per_year", "upper end of that interval", &Interval::high);
    all += spared_columns<Row>("spared_deaths", count, "deaths that the forest prevents; in rows with forest",
                               &PlaceRisk::spared_deaths);
    all += spared_columns<Row>("spared_money", amount, "money that the forest spares; in rows with forest",
                               &PlaceRisk::spared_money);
    return all;
}

template <class Row>
ColumnsOf<Row> setting_columns() {
    const auto setting = [](const char* name, const char* unit, const char* meaning,
                            double RiskSettings::*of) {
        return ColumnsOf<Row>{Column{name, unit, meaning, from_risk}, as_given,
                              [of](const Row& row) { return row.results.settings.*of; }};
    };
    return {setting("passages_per_day", count, "of the person of the individual risk on a road",
                    &RiskSettings::passages_per_day),
            setting("prevented_death", amount, "worth of preventing a death", &RiskSettings::prevented_death),
            setting("closure_days", count, "closure after each block that hits a road",
                    &RiskSettings::closure_days),
            setting("closure_cost_per_day", amount, "what a day of it costs",
                    &RiskSettings::closure_cost_per_day),
            {"currency", "of all amounts", from_risk,
             [](const Row& row) { return row.results.settings.currency; }}};
}

ColumnsOf<ExposedRow> exposure_columns() {
    const auto given = [](const char* name, const char* unit, const char* meaning,
                          std::optional<double> TargetExposure::*of) {
        return ColumnsOf<ExposedRow>{Column{name, unit, meaning, from_targets}, as_given,
                                     [of](const ExposedRow& row) { return row.target.exposure.*of; }};
    };
    return {{"use", "road or house", from_targets,
             [](const ExposedRow& row) { return row.target.exposure.is_road() ? "road" : "house"; }},
            given("vehicles_per_day", count, "of a road", &TargetExposure::vehicles_per_day),
            given("speed_kmph", "km/h", "of them", &TargetExposure::speed_kmph),
            given("persons_per_vehicle", "-", "on average", &TargetExposure::persons_per_vehicle),
            {Column{"vehicle_length_m", "m", "of a vehicle", "input targets.file or risk.vehicle_length_m"},
             as_given,
             [](const ExposedRow& row) {
                 const TargetExposure& of = row.target.exposure;
                 return of.is_road() ? of.vehicle_length_m.value_or(row.results.settings.vehicle_length_m)
                                     : std::numeric_limits<double>::quiet_NaN();
             }},
            given("persons", "-", "of a house", &TargetExposure::persons),
            given("hours_per_day", count, "that each of them is there", &TargetExposure::hours_per_day),
            given("house_value", amount, "of the house", &TargetExposure::house_value)};
}

constexpr auto cover_of_row = [](const auto& row) { return name_of(row.cover); };

template <class Row>
ColumnsOf<Row> names_of_target() {
    return {{target_columns(),
             [](const Row& row) {
                 const auto& target = row.site.targets[row.target.target];
                 return TargetName{target.id, target.name};
             }},
            {cover_column(), cover_of_row}};
}

TableOf<ExposedRow> target_risk_table() {
    return {"risk.csv",
            "The risk of each exposed target, a year, with all that it was computed with.",
            "an exposed target on a slope",
            {names_of_target<ExposedRow>(), estimate_columns<ExposedRow>(individual_column),
             rate_columns<ExposedRow>(), exposure_columns(), setting_columns<ExposedRow>()}};
}

TableOf<PlaceRow> total_risk_table() {
    return {"risk_total.csv",
            "The risk of all exposed targets together, a year.",
            "a slope",
            {{cover_column(), cover_of_row}, rate_columns<PlaceRow>(), setting_columns<PlaceRow>()}};
}

TableOf<ClassOfTarget> class_risk_table() {
    const auto curve = [](const char* name, const char* unit, const char* meaning, double CurveClass::*of) {
        return ColumnsOf<ClassOfTarget>{Column{name, unit, meaning, from_curves}, as_given,
                                        [of](const ClassOfTarget& row) { return row.energy().*of; }};
    };
    ColumnsOf<ClassOfTarget> columns{
        names_of_target<ClassOfTarget>(),
        curve("energy_from_kj", "kJ", "lower end of the class of energy, which ends with the next one",
              &CurveClass::energy_from_kj),
        curve("lethality_in_vehicle", "-", "chance of dying in a vehicle that is hit",
              &CurveClass::lethality_in_vehicle),
        curve("lethality_in_house", "-", "chance of dying in a house that is hit",
              &CurveClass::lethality_in_house),
        curve("damage_to_house", "-", "share of its value that is lost", &CurveClass::damage_to_house)};
    for (const QuantityColumn& column : counted_columns) {
        columns += {Column{joined(column.name, "_per_year"), column.unit, column.meaning, how}, as_given,
                    [quantity = column.quantity](const ClassOfTarget& row) {
                        return six_digits(row.slope().by_class[row.number][index_of(quantity)]);
                    }};
    }
    return {"risk_classes.csv", "The risk of each exposed target by class of energy, a year.",
            "a class of energy at an exposed target on a slope", columns};
}

}  // namespace

const std::vector<TableLayout>& risk_layouts() {
    static const std::vector<TableLayout> layouts{target_risk_table(), total_risk_table(),
                                                  class_risk_table()};
    return layouts;
}

std::vector<WrittenFile> write_tables(const RiskResults& results, const Site& site,
                                      const std::filesystem::path& folder) {
    return {target_risk_table().write(folder,
                                      [&](auto& rows) {
                                          for (const TargetRisk& target : results.targets) {
                                              for (const Cover cover : results.slopes) {
                                                  rows.add({{results, target.risk, cover}, site, target});
                                              }
                                          }
                                      }),
            total_risk_table().write(folder,
                                     [&](auto& rows) {
                                         for (const Cover cover : results.slopes) {
                                             rows.add({results, results.all, cover});
                                         }
                                     }),
            class_risk_table().write(folder, [&](auto& rows) {
                for (const TargetRisk& target : results.targets) {
                    for (const Cover cover : results.slopes) {
                        for (std::size_t i = 0; i < results.curves.classes().size(); ++i) {
                            rows.add({{{results, target.risk, cover}, site, target}, i});
                        }
                    }
                }
            })};
}

}  // namespace coupling::hazard::risk
