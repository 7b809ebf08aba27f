#include "coupling/inputs/rockyfor3d/forest.hpp"

#include <cmath>

#include "config/errors/input_error.hpp"
#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "config/text/joined.hpp"
#include "forest/start/height_curve.hpp"

namespace coupling::rockyfor3d {
namespace {

using config::joined;

constexpr double thinnest_cm = 5.0;
constexpr double m2_per_ha = 10'000.0;

/// Trees of the list and cells of the rasters have streams of their own.
constexpr std::uint64_t cells_from = 1ULL << 40U;

class Planter {
public:
    explicit Planter(const Folder& folder) : folder_{folder} {
        forest_.all_conifers = !folder.conifer_percent.has_value();
    }

    /// `u`: uniform on [0, 1).
    void plant(double x_m, double y_m, double dbh_cm, double u) {
        const config::GridFrame& frame = folder_.dem.frame;
        if (!on_terrain(x_m, y_m) || std::isnan(folder_.dem.at(frame.cell_at(x_m, y_m)))) {
            ++forest_.outside;
        } else if (dbh_cm < thinnest_cm) {
            ++forest_.too_thin;
        } else {
            const double conifers =
                forest_.all_conifers ? 100.0 : folder_.conifer_percent->at(frame.cell_at(x_m, y_m));
            // NODATA counts as no share given: conifer, as without the raster.
            const bool is_conifer = std::isnan(conifers) || u < conifers / 100.0;
            forest_.trees.push_back({x_m, y_m, is_conifer ? conifer : broadleaf, dbh_cm,
                                     forest::curve_of_prealps.height_m(dbh_cm)});
        }
    }
    [[nodiscard]] Forest done() { return std::move(forest_); }
    void generated() { forest_.generated = true; }

private:
    /// The terrain joins the centres of cells: it ends half a cell inside the DEM.
    [[nodiscard]] bool on_terrain(double x_m, double y_m) const {
        const config::GridFrame& frame = folder_.dem.frame;
        return x_m > frame.x_centre_m(0) && x_m < frame.x_centre_m(frame.columns - 1) &&
               y_m > frame.y_centre_m(frame.rows - 1) && y_m < frame.y_centre_m(0);
    }

    const Folder& folder_;
    Forest forest_;
};

void plant_listed(const Folder& folder, Planter& planter) {
    for (std::size_t i = 0; i < folder.trees->size(); ++i) {
        config::RandomStream stream{{.seed = forest_seed, .id = i}, config::Purpose::stand};
        const FileTree& tree = (*folder.trees)[i];
        planter.plant(tree.x_m, tree.y_m, tree.dbh_cm, stream.uniform());
    }
}

double gamma_dbh_cm(double u, double mean_cm, double deviation_cm) {
    constexpr double nothing = 1e-3;  // of the mean; the shape of so narrow a distribution may overflow
    if (deviation_cm <= nothing * mean_cm) {
        return mean_cm;
    }
    const double shape = (mean_cm / deviation_cm) * (mean_cm / deviation_cm);
    return config::gamma(u, shape, mean_cm / shape);
}

void plant_generated(const Folder& folder, Planter& planter) {
    const config::GridFrame& frame = folder.dem.frame;
    planter.generated();
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const double stems_pha = folder.stems_pha->values[i];
        const double mean_cm = folder.mean_dbh_cm->values[i];
        const double deviation_cm = folder.dbh_deviation_cm->values[i];
        if (!(stems_pha > 0.0) || !(mean_cm > 0.0) || std::isnan(folder.dem.values[i])) {
            continue;
        }
        config::RandomStream stream{{.seed = forest_seed, .id = cells_from + i}, config::Purpose::stand};
        const double expected = stems_pha * frame.cell_area_m2() / m2_per_ha;
        const double whole = std::floor(expected);
        const auto count = static_cast<std::size_t>(whole) + (stream.uniform() < expected - whole ? 1U : 0U);
        const config::Cell cell = frame.cell_of(i);
        for (std::size_t tree = 0; tree < count; ++tree) {
            const double x_m = frame.x_west_m + (cell.column + stream.uniform()) * frame.cell_width_m;
            const double y_m = frame.y_north_m() - (cell.row + stream.uniform()) * frame.cell_height_m;
            const double dbh_cm =
                gamma_dbh_cm(stream.uniform(), mean_cm, std::isnan(deviation_cm) ? 0.0 : deviation_cm);
            planter.plant(x_m, y_m, dbh_cm, stream.uniform());
        }
    }
}

}  // namespace

Forest forest_of(const Folder& folder) {
    Planter planter{folder};
    if (folder.trees) {
        plant_listed(folder, planter);
        Forest forest = planter.done();
        if (forest.trees.empty()) {
            config::fail(
                config::ExitCode::data, {"treefile.txt"},
                joined("no tree to plant: ", std::to_string(folder.trees->size()), " in the file, ",
                       std::to_string(forest.outside), " off the terrain, ", std::to_string(forest.too_thin),
                       " below 5 cm"),
                "columns x, y, DBH in cm in the coordinates of dem.asc, or no such file for a bare slope");
        }
        return forest;
    }
    if (folder.stems_pha) {
        plant_generated(folder, planter);
    }
    return planter.done();
}

}  // namespace coupling::rockyfor3d
