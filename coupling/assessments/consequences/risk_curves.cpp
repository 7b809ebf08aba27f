#include "coupling/assessments/consequences/risk_curves.hpp"

#include <algorithm>

#include "config/data/shipped_tables.hpp"
#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::consequences {

const config::Schema<CurveClass>& curve_columns() {
    using R = CurveClass;
    // clang-format off
    static const config::Schema<CurveClass> columns{
        {.role = "risk_curves", .setting = "risk.curves", .row = "class of energy", .unique_together = {{"energy_from_kj"}}},
        {{"energy_from_kj", &R::energy_from_kj, "from here up to the next class", {.range = {0.0, 1e6}}},
         {"lethality_in_vehicle", &R::lethality_in_vehicle, "chance of dying in a vehicle that is hit", {.range = {0.0, 1.0}}},
         {"lethality_in_house", &R::lethality_in_house, "chance of dying somewhere in a house that is hit", {.range = {0.0, 1.0}}},
         {"damage_to_house", &R::damage_to_house, "share of its value that is lost", {.range = {0.0, 1.0}}}}};
    // clang-format on
    return columns;
}

Curves Curves::read(const config::Table& table) {
    std::vector<config::Read<CurveClass>> rows = curve_columns().all(table);
    std::stable_sort(rows.begin(), rows.end(),
                     [](const auto& a, const auto& b) { return a.energy_from_kj < b.energy_from_kj; });
    config::RowProblems wrong{table};
    if (rows.empty() || rows.front().energy_from_kj != 0.0) {
        wrong.refuse("no class of energy that begins with 0 kJ", "energy_from_kj 0 in a row");
    }
    Curves curves;
    for (const config::Read<CurveClass>& row : rows) {
        if (!curves.classes_.empty()) {
            const CurveClass& below = curves.classes_.back();
            const auto refuse_fall = [&](const char* column, double CurveClass::*share) {
                if (row.*share < below.*share) {
                    wrong.refuse(row.row, column,
                                 config::joined(column, " ", config::to_text(row.*share), " below the ",
                                                config::to_text(below.*share), " of the class from ",
                                                config::to_text(below.energy_from_kj), " kJ"),
                                 "shares that do not fall as the energy rises");
                }
            };
            refuse_fall("lethality_in_vehicle", &CurveClass::lethality_in_vehicle);
            refuse_fall("lethality_in_house", &CurveClass::lethality_in_house);
            refuse_fall("damage_to_house", &CurveClass::damage_to_house);
        }
        curves.classes_.push_back(row);
    }
    wrong.throw_first();
    return curves;
}

Curves Curves::shipped() {
    return read(config::read_shipped_table("risk_curves.csv"));
}

std::size_t Curves::class_of(double energy_kj) const {
    const auto above = std::upper_bound(
        classes_.begin(), classes_.end(), energy_kj,
        [](double energy, const CurveClass& other) { return energy < other.energy_from_kj; });
    return above == classes_.begin() ? 0 : static_cast<std::size_t>(above - classes_.begin()) - 1;
}

}  // namespace coupling::consequences
