#include "coupling/inputs/forest/crown_cover_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"

namespace coupling {
namespace {

using config::joined;

/// In shares: a raster of which no cell is above 1 holds shares, else percent.
void make_shares(config::Raster<double>& cover, const std::string& file) {
    double high = 0.0;
    for (std::size_t i = 0; i < cover.values.size(); ++i) {
        const double value = cover.values[i];
        if (value < 0.0 || value > 100.0) {
            config::fail(
                config::ExitCode::data, {file},
                joined("crown cover ", config::to_text(value), " in ", cell_in_words(cover.frame, i)),
                "percent from 0 to 100, or shares from 0 to 1",
                "declare values that stand for something else, such as 255, as NODATA");
        }
        high = value > high ? value : high;  // not for NaN
    }
    if (high > 1.0) {
        for (double& value : cover.values) {
            value *= 0.01;
        }
    }
}

bool has_stems_to_place(const forest::StandRecord& record) {
    return std::any_of(record.species.begin(), record.species.end(), [](const forest::SpeciesRecord& part) {
        return part.stems_pha.value_or(0.0) > 0.0 || part.basal_area_m2pha.value_or(0.0) > 0.0;
    });
}

/// What was found on the patches of all stands.
struct CoverCount {
    std::size_t patches = 0;
    std::size_t unknown = 0;
    std::size_t without = 0;  ///< no trees
    std::size_t crowded = 0;  ///< stands
    double sum = 0.0;         ///< of the known ones
};

/// The cover of the patches of a stand; nothing where it is 0 on all of them.
std::optional<std::vector<double>> cover_of_stand(const forest::StandRecord& record,
                                                  const forest::PatchGrid& grid,
                                                  const config::Raster<double>& raster, CoverCount& count) {
    std::vector<double> cover;
    double sum = 0.0;
    std::size_t known = 0;
    for (const forest::PatchId patch : record.patches) {
        cover.push_back(
            cover_around(raster, grid.x_centre_m(patch), grid.y_centre_m(patch), forest::patch_side_m));
        if (!std::isnan(cover.back())) {
            sum += cover.back();
            ++known;
        }
    }
    count.patches += cover.size();
    count.unknown += cover.size() - known;
    count.sum += sum;
    if (sum <= 0.0) {
        return std::nullopt;
    }
    std::size_t covered = 0;
    for (double& share : cover) {
        share = std::isnan(share) ? sum / static_cast<double>(known) : share;
        covered += share > 0.0 ? 1U : 0U;
    }
    count.without += cover.size() - covered;
    count.crowded += 2 * covered < cover.size() ? 1U : 0U;
    return cover;
}

void report_cover(const CoverCount& count, const std::string& file, Reading& reading) {
    if (count.unknown > 0) {
        reading.warn({file}, joined("no crown cover for ", counted(count.unknown, "forest cell"), " of 10 m"),
                     "a value wherever there is forest",
                     "as it is, these have the mean cover of their stand");
    }
    if (count.crowded > 0) {
        reading.warn({file},
                     joined(counted(count.crowded, "stand"), " with crowns on less than half of the area"),
                     "records per hectare of the whole stand, its gaps included",
                     "cut the gaps out of the stand if its stems were counted where it is closed: they stand "
                     "too dense otherwise");
    }
    const std::size_t known = count.patches - count.unknown;
    if (known > 0) {
        reading.note(joined(file, ": stems of each stand are placed by crown cover, ",
                            std::to_string(std::lround(100.0 * count.sum / static_cast<double>(known))),
                            " % in the mean; ", counted(count.without, "forest cell"), " of ",
                            std::to_string(count.patches), " without trees"));
    }
}

}  // namespace

double cover_around(const config::Raster<double>& cover, double x_m, double y_m, double side_m) {
    constexpr int points = 10;
    const double step_m = side_m / points;
    double sum = 0.0;
    int known = 0;
    for (int row = 0; row < points; ++row) {
        for (int column = 0; column < points; ++column) {
            const config::Cell cell = cover.frame.cell_at(x_m + (column + 0.5) * step_m - 0.5 * side_m,
                                                          y_m + (row + 0.5) * step_m - 0.5 * side_m);
            if (cover.frame.contains(cell) && !std::isnan(cover.at(cell))) {
                sum += cover.at(cell);
                ++known;
            }
        }
    }
    return known > 0 ? sum / known : std::numeric_limits<double>::quiet_NaN();
}

void add_crown_cover(std::vector<forest::StandRecord>& inventory, const forest::PatchGrid& grid,
                     Reading& reading) {
    const std::string& name = reading.forest().stand_cover;
    if (name.empty()) {
        return;
    }
    const std::string file = reading.shown(name);
    const auto cover = reading.attempt([&] {
        config::Raster<double> raster = reading.grid("stands.cover", "crown_cover", name);
        make_shares(raster, file);
        return raster;
    });
    if (!cover) {
        return;
    }
    CoverCount count;
    for (forest::StandRecord& record : inventory) {
        if (auto of_stand = cover_of_stand(record, grid, *cover, count)) {
            record.cover = std::move(*of_stand);
        } else if (has_stems_to_place(record)) {
            const std::uint32_t stand = grid[record.patches.front()].management_unit;
            reading.refuse({file},
                           joined("no crown cover in stand ", std::to_string(stand), ", which has stems"),
                           "a cover above 0 where trees stand",
                           "correct the raster, or write stems_pha 0 for the stand");
        }
    }
    report_cover(count, file, reading);
}

}  // namespace coupling
