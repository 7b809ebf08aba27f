#include "validation/engine/forest_cases/mapped_stand.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "config/errors/input_error.hpp"
#include "config/math/elementary.hpp"
#include "config/text/joined.hpp"
#include "validation/engine/forest_cases/shared/plot_checks.hpp"
#include "validation/engine/forest_cases/shared/unknown_columns.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using forest::CrownShape;
using forest::LightTree;
using forest::MonthlyRadiation;

/// Sides of stands are multiples of it: the width of the model's own columns.
constexpr double widest_column_m = 10.0;

double number(const config::Table& table, std::size_t row, const std::string& column, double low, double high,
              config::Problems& problems) {
    return table.number(row, column, {low, high}, problems).value_or(low);
}

/// What the leaves of a tree follow from.
struct LeavesOf {
    CrownShape shape = CrownShape::paraboloid;
    double foliage_a = 0.0;
    double foliage_b = 0.0;
    double sla_m2_per_kg = 0.0;
};

/// The table of leaves by species; each row is read once, however many trees it has.
std::map<std::string, LeavesOf> leaves_of(const config::Table& table, config::Problems& problems) {
    std::map<std::string, LeavesOf> leaves;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& crown = table.text(row, "crown");
        if (crown != "ellipsoid" && crown != "paraboloid") {
            problems.add(config::ExitCode::data, table.place(row, "crown"),
                         joined("crown ", config::in_quotes(crown)), "ellipsoid or paraboloid",
                         "take the one that is nearer: light is computed for these two alone");
        }
        const LeavesOf found{crown == "ellipsoid" ? CrownShape::ellipsoid : CrownShape::paraboloid,
                             number(table, row, "foliage_a", 0.0, 10.0, problems),
                             number(table, row, "foliage_b", 0.0, 5.0, problems),
                             number(table, row, "sla_m2_per_kg", 0.1, 100.0, problems)};
        if (!leaves.emplace(table.text(row, "species"), found).second) {
            problems.add(config::ExitCode::data, table.place(row, "species"),
                         joined("species ", config::in_quotes(table.text(row, "species")), " a second time"),
                         "one row for each species", "leave one of the rows out");
        }
    }
    return leaves;
}

LightTree tree_of(const config::Table& trees, std::size_t row, const std::map<std::string, LeavesOf>& leaves,
                  const std::string& leaves_file, config::Problems& problems) {
    const std::size_t problems_before = problems.list().size();
    LightTree tree;
    tree.x_m = number(trees, row, "x_m", -1e4, 1e4, problems);
    tree.y_m = number(trees, row, "y_m", -1e4, 1e4, problems);
    tree.height_m = number(trees, row, "height_m", 0.1, 80.0, problems);
    tree.crown_base_m = number(trees, row, "crown_base_m", 0.0, 80.0, problems);
    tree.crown_radius_m = number(trees, row, "crown_radius_m", 0.0, 20.0, problems);
    if (problems.list().size() == problems_before && tree.crown_base_m >= tree.height_m) {
        problems.add(config::ExitCode::data, trees.place(row, "crown_base_m"),
                     joined("crown_base_m ", trees.text(row, "crown_base_m"), " of a tree of ",
                            trees.text(row, "height_m"), " m"),
                     "a crown that begins below the top",
                     "correct crown_base_m or height_m: the two may be swapped");
    }
    const double dbh_cm = number(trees, row, "dbh_cm", 0.1, 300.0, problems);
    const auto of_species = leaves.find(trees.text(row, "species"));
    if (of_species == leaves.end()) {
        problems.add(config::ExitCode::data, trees.place(row, "species"),
                     joined("species ", config::in_quotes(trees.text(row, "species"))),
                     joined("a species of ", leaves_file), "add it there, or correct the name");
        return tree;
    }
    tree.shape = of_species->second.shape;
    tree.leaf_area_m2 = of_species->second.foliage_a * config::pow_of(dbh_cm, of_species->second.foliage_b) *
                        of_species->second.sla_m2_per_kg;
    return tree;
}

std::vector<double> column_of(const config::Table& table, const std::string& column,
                              config::Problems& problems) {
    std::vector<double> values;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        values.push_back(number(table, row, column, 0.0, 1.0, problems));
    }
    return values;
}

MappedSlope slope_of(const config::Table& slopes, std::size_t row, config::Problems& problems) {
    MappedSlope slope;
    slope.name = slopes.text(row, "slope");
    slope.slope = config::Angle::from_degrees(number(slopes, row, "slope_deg", 0.0, 60.0, problems));
    slope.aspect = config::Angle::from_degrees(number(slopes, row, "aspect_deg", 0.0, 360.0, problems));
    slope.y_axis_azimuth =
        config::Angle::from_degrees(number(slopes, row, "y_axis_azimuth_deg", 0.0, 360.0, problems));
    if (slopes.has("direct_mjpm2")) {
        slope.direct_mjpm2 = number(slopes, row, "direct_mjpm2", 1.0, 2e4, problems);
        slope.diffuse_mjpm2 = number(slopes, row, "diffuse_mjpm2", 1.0, 2e4, problems);
    }
    return slope;
}

MonthlyRadiation radiation_of(const config::Table& table, config::Problems& problems) {
    MonthlyRadiation radiation;
    if (table.rows() != radiation.direct_mjpm2.size()) {
        problems.add(config::ExitCode::data, {table.file()}, std::to_string(table.rows()) + " rows",
                     "one for each month, January first");
        return radiation;
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto in_order = static_cast<long long>(row + 1);
        if (table.has("month") &&
            table.whole(row, "month", {1.0, 12.0}, problems).value_or(in_order) != in_order) {
            problems.add(config::ExitCode::data, table.place(row, "month"),
                         joined("month ", table.text(row, "month"), " in row ", std::to_string(row + 1)),
                         "the months in order, January first", "sort the rows by month");
            return radiation;
        }
        const double global_mjpm2 = number(table, row, "global_mjpm2", 0.0, 2000.0, problems);
        const double diffuse = number(table, row, "diffuse_share", 0.0, 1.0, problems);
        radiation.diffuse_mjpm2[row] = diffuse * global_mjpm2;
        radiation.direct_mjpm2[row] = (1.0 - diffuse) * global_mjpm2;
    }
    return radiation;
}

/// Sums of January and July; a fifth of the larger one leaves no doubt.
void check_seasons(const MappedStand& stand, const MappedTables& tables, config::Problems& problems) {
    const auto sum_of = [&](std::size_t month) {
        return stand.radiation.direct_mjpm2[month] + stand.radiation.diffuse_mjpm2[month];
    };
    const double january_mjpm2 = sum_of(0);
    const double july_mjpm2 = sum_of(6);
    check_hemisphere({.latitude_deg = stand.latitude.in_degrees(),
                      .january = january_mjpm2,
                      .july = july_mjpm2,
                      .clear = 0.2 * std::max(january_mjpm2, july_mjpm2),
                      .from_deg = 30.0},  // monsoons dim the summer up to there
                     tables.slopes.place(0, "latitude_deg"),
                     joined("latitude_deg ", tables.slopes.text(0, "latitude_deg")), tables.radiation.file(),
                     problems);
}

/// Whether a table has the reference light of a slope.
bool has_light(const std::optional<config::Table>& table, const std::string& light) {
    return table && table->has(light);
}

/// "column 'ligth_mine' of sensors.csv": what may be meant to hold the light of a slope; "" without. The
/// light of another slope is not.
std::string nearest_light(const MappedTables& tables, const std::string& light) {
    for (const config::Table* table : {&tables.trees, tables.ground ? &*tables.ground : nullptr,
                                       tables.sensors ? &*tables.sensors : nullptr}) {
        if (table == nullptr) {
            continue;
        }
        std::vector<std::string> columns = table->columns();
        for (std::size_t row = 0; row < tables.slopes.rows(); ++row) {
            std::erase(columns, "light_" + tables.slopes.text(row, "slope"));
        }
        const std::string nearest = config::nearest_word(light, columns);
        if (!nearest.empty()) {
            return joined("column ", config::in_quotes(nearest), " of ", table->file());
        }
    }
    return "";
}

/// Each slope needs something to be compared with.
void check_references(const MappedTables& tables, config::Problems& problems) {
    for (std::size_t row = 0; row < tables.slopes.rows(); ++row) {
        const std::string light = "light_" + tables.slopes.text(row, "slope");
        if (!tables.trees.has(light) && !has_light(tables.ground, light) &&
            !has_light(tables.sensors, light)) {
            const std::string meant = nearest_light(tables, light);
            problems.add(config::ExitCode::data, tables.slopes.place(row, "slope"),
                         "slope '" + tables.slopes.text(row, "slope") + "' without reference light",
                         "a column " + light + " in trees.csv, ground.csv or sensors.csv",
                         meant.empty() ? "add the column, or leave the slope out"
                                       : joined("if it is ", meant, ", give it that name"));
        }
    }
}

bool columns_are_there(const MappedTables& tables, config::Problems& problems) {
    bool all = tables.trees.require(
        {"species", "x_m", "y_m", "dbh_cm", "height_m", "crown_base_m", "crown_radius_m"}, problems);
    all = tables.leaves.require({"species", "crown", "foliage_a", "foliage_b", "sla_m2_per_kg"}, problems) &&
          all;
    all = tables.radiation.require({"global_mjpm2", "diffuse_share"}, problems) && all;
    all =
        tables.slopes.require(
            {"slope", "latitude_deg", "side_m", "slope_deg", "aspect_deg", "y_axis_azimuth_deg"}, problems) &&
        all;
    if (tables.slopes.has("direct_mjpm2") != tables.slopes.has("diffuse_mjpm2")) {
        all = tables.slopes.require({"direct_mjpm2", "diffuse_mjpm2"}, problems) && all;
    }
    if (tables.sensors) {
        all = tables.sensors->require({"x_m", "y_m"}, problems) && all;
    }
    if (all) {
        check_references(tables, problems);
    }
    return all;
}

/// What holds for the stand on all slopes: where it lies and how large it is.
void read_place(const config::Table& slopes, MappedStand& stand, config::Problems& problems) {
    double first_latitude_deg = 0.0;
    for (std::size_t row = 0; row < slopes.rows(); ++row) {
        for (std::size_t earlier = 0; earlier < row; ++earlier) {
            if (slopes.text(earlier, "slope") == slopes.text(row, "slope")) {
                problems.add(config::ExitCode::data, slopes.place(row, "slope"),
                             joined("slope ", config::in_quotes(slopes.text(row, "slope")),
                                    " a second time, as in line ",
                                    std::to_string(slopes.place(earlier, "slope").line)),
                             "one row for each slope", "leave one of the rows out, or give it another name");
                break;
            }
        }
        const std::size_t problems_before = problems.list().size();
        const double latitude_deg = number(slopes, row, "latitude_deg", -66.0, 66.0, problems);
        const double side_m = number(slopes, row, "side_m", widest_column_m, 1000.0, problems);
        if (problems.list().size() != problems_before) {
            continue;  // what is no number differs from nothing
        }
        if (row == 0) {
            first_latitude_deg = latitude_deg;
            stand.latitude = config::Angle::from_degrees(latitude_deg);
            stand.side_m = side_m;
        } else if (latitude_deg != first_latitude_deg || side_m != stand.side_m) {
            problems.add(config::ExitCode::data, slopes.place(row, "latitude_deg"),
                         "another latitude or side than in the first row",
                         "one stand, laid on all slopes at one place",
                         "repeat the values of the first row, or make a case for each stand");
        }
        if (std::fmod(side_m, widest_column_m) != 0.0) {
            problems.add(config::ExitCode::data, slopes.place(row, "side_m"),
                         "a side of " + slopes.text(row, "side_m") + " m",
                         "a multiple of 10 m, the width of the columns of light",
                         "cut the stand, and leave out the trees beyond");
        }
    }
}

/// Agreement is a mean over something.
void check_rows(const config::Table& table, const std::string& of, config::Problems& problems) {
    if (table.rows() == 0) {
        problems.add(config::ExitCode::data, {table.file()}, "no rows", "a row for each " + of);
    }
}

void check_inside(const MappedStand& stand, double x_m, double y_m, const std::string& what,
                  const config::Place& place, config::Problems& problems) {
    if (std::max(std::abs(x_m - 0.5 * stand.side_m), std::abs(y_m - 0.5 * stand.side_m)) >
        0.5 * stand.side_m) {
        problems.add(config::ExitCode::data, place, what + " off the stand",
                     "x_m and y_m from 0 to side_m of the slopes",
                     "shift the positions, or leave " + what.substr(2) + "s beyond out");
    }
}

}  // namespace

MappedStand mapped_stand(const MappedTables& tables) {
    config::Problems problems;
    MappedStand stand;
    if (columns_are_there(tables, problems)) {
        check_rows(tables.trees, "tree", problems);
        if (tables.ground) {
            check_rows(*tables.ground, "place where light on the ground is known", problems);
        }
        check_rows(tables.slopes, "slope", problems);
        read_place(tables.slopes, stand, problems);
        stand.radiation = radiation_of(tables.radiation, problems);
        if (problems.empty()) {
            check_seasons(stand, tables, problems);
        }
        const std::map<std::string, LeavesOf> leaves = leaves_of(tables.leaves, problems);
        for (std::size_t row = 0; row < tables.trees.rows(); ++row) {
            const std::size_t problems_before = problems.list().size();
            stand.trees.push_back(tree_of(tables.trees, row, leaves, tables.leaves.file(), problems));
            if (problems.list().size() == problems_before) {
                check_inside(stand, stand.trees.back().x_m, stand.trees.back().y_m, "a tree",
                             tables.trees.place(row, "x_m"), problems);
            }
        }
        if (tables.sensors) {
            check_rows(*tables.sensors, "sensor", problems);
            for (std::size_t row = 0; row < tables.sensors->rows(); ++row) {
                const std::size_t problems_before = problems.list().size();
                stand.sensors.push_back({number(*tables.sensors, row, "x_m", -1e4, 1e4, problems),
                                         number(*tables.sensors, row, "y_m", -1e4, 1e4, problems)});
                if (problems.list().size() == problems_before) {
                    check_inside(stand, stand.sensors.back().x_m, stand.sensors.back().y_m, "a sensor",
                                 tables.sensors->place(row, "x_m"), problems);
                }
            }
        }
        for (std::size_t row = 0; row < tables.slopes.rows(); ++row) {
            MappedSlope slope = slope_of(tables.slopes, row, problems);
            const std::string light = "light_" + slope.name;
            if (tables.trees.has(light)) {
                slope.tree_light = column_of(tables.trees, light, problems);
            }
            if (has_light(tables.ground, light)) {
                slope.ground_light = column_of(*tables.ground, light, problems);
            }
            if (has_light(tables.sensors, light)) {
                slope.sensor_light = column_of(*tables.sensors, light, problems);
            }
            stand.slopes.push_back(std::move(slope));
        }
    }
    problems.throw_if_any();
    return stand;
}

void warn_of_unknown_columns(const MappedTables& tables, config::Warnings& warnings) {
    std::vector<std::string> light;
    for (std::size_t row = 0; row < tables.slopes.rows() && tables.slopes.has("slope"); ++row) {
        light.push_back("light_" + tables.slopes.text(row, "slope"));
    }
    const auto warn = [&](const config::Table& table, std::vector<std::string> known, bool has_light) {
        if (has_light) {
            known.insert(known.end(), light.begin(), light.end());
        }
        warn_of_unknown_columns(table, known, warnings);
    };
    warn(tables.trees,
         {"tree_id", "species", "x_m", "y_m", "dbh_cm", "height_m", "crown_base_m", "crown_radius_m"}, true);
    warn(tables.leaves, {"species", "crown", "foliage_a", "foliage_b", "sla_m2_per_kg"}, false);
    warn(tables.radiation, {"month", "global_mjpm2", "diffuse_share"}, false);
    warn(tables.slopes,
         {"slope", "latitude_deg", "side_m", "slope_deg", "aspect_deg", "y_axis_azimuth_deg", "direct_mjpm2",
          "diffuse_mjpm2"},
         false);
    if (tables.ground) {
        warn(*tables.ground, {"x_m", "y_m"}, true);
    }
    if (tables.sensors) {
        warn(*tables.sensors, {"sensor", "x_m", "y_m"}, true);
    }
}

}  // namespace coupling::validation::forest_cases
