#include "coupling/inputs/plausible/terrain/stripes.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"

namespace coupling::plausible::terrain {
namespace {

using config::joined;

constexpr int blocks = 4;

/// A square or less, rows across the lines that are looked for.
struct Window {
    int rows = 0;
    int columns = 0;
    double row_spacing_m = 1.0;
    std::vector<double> values;
};

/// First and count of the middle of a side, the same seen from both ends.
std::pair<int, int> middle_of(int cells) {
    if (cells <= limits::stripe_window) {
        return {0, cells};
    }
    const int count = limits::stripe_window - (cells - limits::stripe_window) % 2;
    return {(cells - count) / 2, count};
}

/// The middle of a field; the lines of `axis` become rows.
Window middle_window(const HeightField& field, const Axis& axis) {
    const auto [first_line, lines] = middle_of(axis.lines);
    const auto [first_cell, cells] = middle_of(axis.cells);
    Window window{.rows = lines, .columns = cells, .row_spacing_m = axis.line_spacing_m, .values = {}};
    window.values.reserve(static_cast<std::size_t>(lines) * static_cast<std::size_t>(cells));
    for (int line = 0; line < lines; ++line) {
        const double* cell =
            field.heights_m + (first_line + line) * axis.line_step + first_cell * axis.cell_step;
        for (int i = 0; i < cells; ++i, cell += axis.cell_step) {
            window.values.push_back(*cell);
        }
    }
    return window;
}

/// Every value less the mean of the 2 `reach` + 1 values around it in its column; the rows at the rim are
/// left out.
Window without_average(const Window& window, int reach) {
    Window rest{.rows = window.rows - 2 * reach,
                .columns = window.columns,
                .row_spacing_m = window.row_spacing_m,
                .values = {}};
    const auto columns = static_cast<std::size_t>(window.columns);
    rest.values.resize(static_cast<std::size_t>(rest.rows) * columns);
    for (int row = 0; row < rest.rows; ++row) {
        double* out = rest.values.data() + static_cast<std::size_t>(row) * columns;
        std::fill(out, out + columns, 0.0);
        for (int k = 0; k <= 2 * reach; ++k) {
            const double* in = window.values.data() + static_cast<std::size_t>(row + k) * columns;
            for (std::size_t i = 0; i < columns; ++i) {
                out[i] -= in[i];
            }
        }
        const double* own = window.values.data() + static_cast<std::size_t>(row + reach) * columns;
        for (std::size_t i = 0; i < columns; ++i) {
            out[i] = own[i] + out[i] / (2 * reach + 1);
        }
    }
    return rest;
}

/// Twice the median of the sizes of all known values; 0 with too few.
double cut_off(const Window& window) {
    std::vector<double> sizes;
    for (const double value : window.values) {
        if (!std::isnan(value)) {
            sizes.push_back(std::abs(value));
        }
    }
    if (sizes.size() < 200) {
        return 0.0;
    }
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return 2.0 * *middle;
}

/// Of each line in each of four blocks.
struct Profiles {
    std::array<std::vector<double>, blocks> cut;    ///< means of residuals that were cut off: for their signs
    std::array<std::vector<double>, blocks> whole;  ///< means of whole residuals: for their sizes
};

double sign_of(double value) {
    return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0;
}

/// 0 of none; NaN are left out.
double quantile(std::vector<double> values, double share) {
    std::erase_if(values, [](double value) { return std::isnan(value); });
    if (values.empty()) {
        return 0.0;
    }
    const auto middle =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Mean residual of each line in each of four blocks; not known where a block has fewer than 8 cells of it.
/// A line rises by `slant` rows from one column to the next.
Profiles block_profiles(const Window& rest, double limit, double slant) {
    const int shift = static_cast<int>(std::ceil(std::abs(slant) * rest.columns)) + 1;
    const auto lines = static_cast<std::size_t>(rest.rows + 2 * shift);
    Profiles sums;
    std::array<std::vector<int>, blocks> counts;
    sums.cut.fill(std::vector<double>(lines, 0.0));
    sums.whole.fill(std::vector<double>(lines, 0.0));
    counts.fill(std::vector<int>(lines, 0));
    for (int column = 0; column < rest.columns; ++column) {
        const auto block = static_cast<std::size_t>(std::min(column * blocks / rest.columns, blocks - 1));
        const int offset = shift + static_cast<int>(std::floor(slant * column + 0.5));
        for (int row = 0; row < rest.rows; ++row) {
            const double value =
                rest.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(rest.columns) +
                            static_cast<std::size_t>(column)];
            if (!std::isnan(value)) {
                const auto line = static_cast<std::size_t>(row + offset);
                sums.cut[block][line] += std::clamp(value, -limit, limit);
                sums.whole[block][line] += value;
                ++counts[block][line];
            }
        }
    }
    for (std::size_t block = 0; block < blocks; ++block) {
        for (std::size_t line = 0; line < lines; ++line) {
            const int count = counts[block][line];
            sums.cut[block][line] = count >= 8 ? sums.cut[block][line] / count : not_known;
            sums.whole[block][line] = count >= 8 ? sums.whole[block][line] / count : not_known;
        }
        // Where few cells stand out on one side, the means of all lines lie on that side.
        const double middle = quantile(sums.cut[block], 0.5);
        for (double& mean : sums.cut[block]) {
            mean -= middle;
        }
    }
    return sums;
}

Stripes stripes_of(const Profiles& both, double row_spacing_m) {
    const auto& profiles = both.cut;
    double agreeing = 0.0;
    std::size_t pairs = 0;
    std::vector<double> steps_m;
    double before = not_known;
    double side = 0.0;
    std::size_t turns = 0;
    std::size_t lines = 0;
    for (std::size_t line = 0; line < profiles[0].size(); ++line) {
        double sum = 0.0;
        double cut = 0.0;
        int known = 0;
        for (std::size_t a = 0; a < blocks; ++a) {
            if (std::isnan(profiles[a][line])) {
                continue;
            }
            sum += both.whole[a][line];
            cut += profiles[a][line];
            ++known;
            for (std::size_t b = 0; b < a; ++b) {
                if (!std::isnan(profiles[b][line])) {
                    agreeing += sign_of(profiles[a][line]) * sign_of(profiles[b][line]);
                    ++pairs;
                }
            }
        }
        const double mean = known > 0 ? sum / known : not_known;
        lines += known > 0 ? 1 : 0;
        turns += sign_of(cut) * side < 0.0 ? 1 : 0;
        side = cut != 0.0 ? sign_of(cut) : side;
        if (!std::isnan(mean - before)) {
            steps_m.push_back(std::abs(mean - before));
        }
        before = mean;
    }
    const bool is_wave = static_cast<double>(turns) < limits::least_turns * static_cast<double>(lines);
    if (pairs < 72 || is_wave) {  // twelve lines of six pairs
        return {};
    }
    // Seven in ten are smaller: two lines up, two lines down have a step every other line, and the few kinks
    // of a profile do not count.
    const double step_m = quantile(std::move(steps_m), 0.7);
    return {agreeing / static_cast<double>(pairs), step_m / row_spacing_m, step_m};
}

void take_strongest(const HeightField& field, const Axis& axis, Stripes& strongest) {
    const Window window = middle_window(field, axis);
    for (const int reach : {1, 2, 4, 8}) {
        if (window.rows < std::max(24, 12 * reach) || window.columns < 8 * blocks) {
            continue;
        }
        // Once takes planes away, twice what bends slowly.
        const Window rest = without_average(without_average(window, reach), reach);
        const double limit = cut_off(rest);
        if (!(limit > 0.0)) {
            continue;
        }
        for (const double slant : {0.0, -0.364, 0.364, -1.0, 1.0}) {  // tan of 20 and 45 degrees
            const Stripes found = stripes_of(block_profiles(rest, limit, slant), axis.line_spacing_m);
            if (found.agreement >= limits::stripe_agreement && found.step > strongest.step) {
                strongest = found;
            }
        }
    }
}

/// Whether lines bend on the way: a drawn profile that is drawn out sideways does not, and its benches are no
/// stripes.
bool has_texture(const HeightField& field, const Axis& axis) {
    const double least_bend_m = 1e-3 * axis.spacing_m;  // a millimetre in a metre: rounding
    std::size_t cells = 0;
    std::size_t bent = 0;
    visit_cells(field, axis, 1, axis.cells - 1, [&](int, int, const double* cell) {
        const double bend = cell[-axis.cell_step] - 2.0 * cell[0] + cell[axis.cell_step];
        cells += std::isnan(bend) ? 0 : 1;
        bent += std::abs(bend) > least_bend_m ? 1 : 0;
    });
    return 5 * bent > cells;
}

}  // namespace

Stripes strongest_stripes(const HeightField& field) {
    Stripes strongest;
    if (!has_texture(field, along_rows(field)) || !has_texture(field, along_columns(field))) {
        return strongest;
    }
    take_strongest(field, along_rows(field), strongest);
    take_strongest(field, along_columns(field), strongest);
    return strongest;
}

std::optional<Finding> judge_stripes(const HeightField& field) {
    const Stripes stripes = strongest_stripes(field);
    if (stripes.agreement < limits::stripe_agreement || stripes.step < limits::stripe_warning) {
        return std::nullopt;
    }
    return Finding{
        stripes.step >= limits::stripe_error,
        joined("straight stripes through the whole terrain, with steps of about ",
               config::to_text(std::round(100.0 * stripes.step_m) / 100.0), " m from line to line"),
        "heights of the ground, which has none",
        "take heights without them: the provider's terrain model, or the original before it was "
        "resampled or merged from flight strips"};
}

}  // namespace coupling::plausible::terrain
