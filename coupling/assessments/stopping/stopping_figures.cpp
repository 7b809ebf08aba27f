#include "coupling/assessments/stopping/stopping_figures.hpp"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iomanip>

#include "coupling/inputs/tables/csv_row.hpp"

namespace coupling {

namespace {

/// A rolled rock is watched over tens of metres, which shows more than one throw.
constexpr std::uint32_t throws_for_a_roll = 10;

/// What came of one surface, by diameter.
struct OneSurface {
    std::vector<rockfall::ThrowTally> thrown;
    std::vector<rockfall::RollTally> rolled;
    double cover = 0.0;
    double projection_m = 0.0;
};

OneSurface throw_at_one(const SurfaceRecipe& recipe, const ThrowPlan& plan, std::uint32_t number) {
    const rockfall::SurfaceKey key{plan.seed, number};
    const rockfall::BlockCover cover =
        rockfall::lay_blocks(recipe.kinds, rockfall::patch_side_m(recipe.kinds), key);
    OneSurface surface;
    surface.cover = cover.cover();
    surface.projection_m = cover.mean_projection_m();
    const std::uint32_t rolls = std::max(1U, plan.throws / throws_for_a_roll);
    for (const double diameter_m : plan.diameters_m) {
        surface.thrown.push_back(rockfall::throw_rocks(cover, diameter_m, {}, key, plan.throws));
        surface.rolled.push_back(rockfall::roll_rocks(cover, diameter_m, {}, key, rolls));
    }
    return surface;
}

SurfaceFigures surface_figures_of(const SurfaceRecipe& recipe, const ThrowPlan& plan,
                                  std::span<const OneSurface> surfaces) {
    SurfaceFigures figures{.recipe = recipe, .sizes = {}};
    figures.surfaces = plan.surfaces;
    figures.throws = std::uint64_t{plan.surfaces} * plan.throws;
    for (const OneSurface& surface : surfaces) {
        figures.mean_cover += surface.cover / plan.surfaces;
        figures.mean_projection_m += surface.projection_m / plan.surfaces;
    }
    for (std::size_t i = 0; i < plan.diameters_m.size(); ++i) {
        std::vector<rockfall::ThrowTally> thrown;
        std::vector<rockfall::RollTally> rolled;
        for (const OneSurface& surface : surfaces) {
            thrown.push_back(surface.thrown[i]);
            rolled.push_back(surface.rolled[i]);
        }
        figures.sizes.push_back(
            {plan.diameters_m[i], rockfall::stop_probability(thrown), rockfall::rolling_stops_per_m(rolled)});
    }
    return figures;
}

/// Diameters that the screen shows: all of a few; of many about 0.5, 1 and 2 m, else the first ones.
std::vector<std::size_t> shown_sizes(const std::vector<StoppingFigures>& sizes) {
    constexpr std::size_t most = 5;
    std::vector<std::size_t> shown;
    for (const double wanted_m : {0.5, 0.95, 1.84}) {
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            if (sizes.size() > most && sizes[i].diameter_m == wanted_m) {
                shown.push_back(i);
            }
        }
    }
    std::vector<std::size_t> few;
    for (std::size_t i = 0; shown.empty() && i < std::min(most, sizes.size()); ++i) {
        few.push_back(i);
    }
    return shown.empty() ? few : shown;
}

}  // namespace

std::vector<double> usual_diameters_m() {
    return {0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 0.95, 1.3, 1.84, 2.4, 3.0};
}

std::vector<SurfaceFigures> throw_at_surfaces(std::span<const SurfaceRecipe> recipes, const ThrowPlan& plan,
                                              const std::function<bool()>& done) {
    std::vector<OneSurface> surfaces(recipes.size() * plan.surfaces);
    std::atomic<bool> goes_on = true;
    const auto count = static_cast<std::int64_t>(surfaces.size());
    const int threads = plan.threads > 0 ? plan.threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (std::int64_t i = 0; i < count; ++i) {
        if (!goes_on) {
            continue;
        }
        const auto index = static_cast<std::size_t>(i);
        surfaces[index] = throw_at_one(recipes[index / plan.surfaces], plan,
                                       static_cast<std::uint32_t>(index % plan.surfaces));
#pragma omp critical
        goes_on = done() && goes_on;
    }
    std::vector<SurfaceFigures> figures;
    for (std::size_t i = 0; goes_on && i < recipes.size(); ++i) {
        const std::span all{surfaces};
        figures.push_back(
            surface_figures_of(recipes[i], plan, all.subspan(i * plan.surfaces, plan.surfaces)));
    }
    return figures;
}

void write_stopping_table(std::span<const SurfaceFigures> surfaces, const std::string& made_by,
                          std::ostream& out) {
    const bool has_codes = !surfaces.empty() && surfaces.front().recipe.code.has_value();
    out << made_by << (has_codes ? "code," : "")
        << "name,diameter_m,p_stop,standard_error,rolling_stops_per_m,rolling_standard_error,"
           "projecting_height_m,throws,surfaces\n";
    CsvRow row{out};
    for (const SurfaceFigures& surface : surfaces) {
        for (const StoppingFigures& size : surface.sizes) {
            if (has_codes) {
                row.whole(static_cast<unsigned>(*surface.recipe.code));
            }
            row.text(surface.recipe.name).text(config::to_text(size.diameter_m));
            row.number<6>(size.stop.value).number<6>(size.stop.standard_error);
            row.number<5>(size.rolling.value).number<5>(size.rolling.standard_error);
            row.number<3>(surface.mean_projection_m).whole(surface.throws).whole(surface.surfaces).end();
        }
    }
}

void write_overview(std::span<const SurfaceFigures> surfaces, std::ostream& out) {
    if (surfaces.empty()) {
        return;
    }
    std::size_t widest = 7;
    for (const SurfaceFigures& surface : surfaces) {
        widest = std::max(widest, surface.recipe.name.size());
    }
    const auto width = static_cast<int>(widest);
    const std::vector<std::size_t> shown = shown_sizes(surfaces.front().sizes);
    out << "Probability that an impact stops a rock of this diameter, in %, with its standard error\n\n"
        << std::left << std::setw(width) << "surface" << std::right << "  cover %";
    for (const std::size_t i : shown) {
        out << std::setw(14) << config::to_text(surfaces.front().sizes[i].diameter_m) << " m";
    }
    out << '\n' << std::fixed;
    for (const SurfaceFigures& surface : surfaces) {
        out << std::left << std::setw(width) << surface.recipe.name << std::right << std::setprecision(2)
            << std::setw(9) << 100.0 * surface.mean_cover << std::setprecision(3);
        for (const std::size_t i : shown) {
            const rockfall::SurfaceEstimate& stop = surface.sizes[i].stop;
            out << std::setw(8) << 100.0 * stop.value << " ±" << std::setw(6) << 100.0 * stop.standard_error;
        }
        out << '\n';
    }
}

}  // namespace coupling
