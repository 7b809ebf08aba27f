#include "validation/engine/forest_cases/shared/plot_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;

/// Outermost rows along a coordinate.
struct Reach {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// Where stands are mapped, the outermost of twenty trees is nearer to the edge [choice].
constexpr std::size_t least_rows = 20;
constexpr double most_empty_share = 0.25;

void warn_of_empty_edge(const config::Table& trees, const char* column, Reach reach, double side_m,
                        const std::string& sides_file, config::Warnings& warnings) {
    if (reach.low < most_empty_share * side_m && side_m - reach.high < most_empty_share * side_m) {
        return;
    }
    warnings.add(joined(trees.file(), ": trees have ", column, " from ", config::to_text(reach.low), " to ",
                        config::to_text(reach.high), ", the plot of ", sides_file, " is ",
                        config::to_text(side_m),
                        " m wide: ground without trees counts as part of the plot; correct the side if it "
                        "does not belong to it"));
}

double coordinate(const config::Table& table, std::size_t row, const char* column) {
    return config::parse_number(table.text(row, column)).value_or(0.0);
}

}  // namespace

void warn_of_shared_places(const config::Table& table, config::Warnings& warnings) {
    std::map<std::pair<double, double>, std::size_t> seen;
    std::size_t shared = 0;
    std::size_t first_line = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::pair place{coordinate(table, row, "x_m"), coordinate(table, row, "y_m")};
        if (!seen.emplace(place, row).second && shared++ == 0) {
            first_line = table.place(row, "x_m").line;
        }
    }
    if (shared > 0) {
        warnings.add(joined(table.file(), ", line ", std::to_string(first_line), ": ", std::to_string(shared),
                            shared == 1 ? " row has" : " rows have",
                            " the x_m and y_m of an earlier one; leave out what stands there twice, keep "
                            "stems of one stool"));
    }
}

void warn_of_empty_edges(const config::Table& trees, PlotSides sides, const std::string& sides_file,
                         config::Warnings& warnings) {
    if (trees.rows() < least_rows) {
        return;
    }
    Reach x;
    Reach y;
    for (std::size_t row = 0; row < trees.rows(); ++row) {
        x.add(coordinate(trees, row, "x_m"));
        y.add(coordinate(trees, row, "y_m"));
    }
    warn_of_empty_edge(trees, "x_m", x, sides.x_m, sides_file, warnings);
    warn_of_empty_edge(trees, "y_m", y, sides.y_m, sides_file, warnings);
}

void check_hemisphere(const plausible::Hemisphere& at, const config::Place& latitude,
                      const std::string& field, const std::string& series_file, config::Problems& problems) {
    if (plausible::seasons_contradict(at)) {
        const bool is_north = at.latitude_deg > 0.0;
        problems.add(config::ExitCode::data, latitude, field,
                     joined("a place ", is_north ? "south" : "north", " of the equator: in ", series_file,
                            " ", is_north ? "January" : "July", " is the summer month"),
                     "write latitudes north of the equator as positive, or correct the months");
    }
}

}  // namespace coupling::validation::forest_cases
