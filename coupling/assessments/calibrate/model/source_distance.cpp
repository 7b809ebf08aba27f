#include "coupling/assessments/calibrate/model/source_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::calibrate {
namespace {

/// Cells a side at most.
constexpr int most_cells = 1000;
constexpr double far = 1e20;

config::GridFrame frame_for(const Site& site, double largest_cell_m) {
    config::GridFrame frame = site.map_frame_on_terrain();
    const int longest = std::max(frame.columns, frame.rows);
    const double wanted = std::ceil(frame.cell_width_m / largest_cell_m);
    const int parts = static_cast<int>(std::clamp(wanted, 1.0, std::max(1.0, 1.0 * most_cells / longest)));
    if (parts > 1) {
        frame.columns *= parts;
        frame.rows *= parts;
        frame.cell_width_m /= parts;
        frame.cell_height_m /= parts;
    }
    const int times = 1 + (std::max(frame.columns, frame.rows) - 1) / most_cells;
    frame.columns = (frame.columns + times - 1) / times;
    frame.rows = (frame.rows + times - 1) / times;
    const double north_m = site.map_frame_on_terrain().y_north_m();
    frame.cell_width_m *= times;
    frame.cell_height_m *= times;
    frame.y_south_m = north_m - frame.rows * frame.cell_height_m;
    return frame;
}

config::Cell nearest_cell(const config::GridFrame& frame, const Eigen::Vector2d& place_m) {
    const config::Cell cell = frame.cell_at(place_m.x(), place_m.y());
    return {std::clamp(cell.column, 0, frame.columns - 1), std::clamp(cell.row, 0, frame.rows - 1)};
}

}  // namespace

void add_distances(std::vector<double>& values, double step) {
    const auto n = static_cast<int>(values.size());
    const double step2 = step * step;
    std::vector<int> lowest;     // of parabolas, from left to right
    std::vector<double> begins;  // where each of them begins to be the lowest
    const auto value = [&](int i) { return values[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < n; ++i) {
        double begin = -far;
        while (!lowest.empty()) {
            const int k = lowest.back();
            begin = ((value(i) / step2 + double{1.0} * i * i) - (value(k) / step2 + double{1.0} * k * k)) /
                    (2.0 * (i - k));
            if (begin > begins.back()) {
                break;
            }
            lowest.pop_back();
            begins.pop_back();
            begin = -far;
        }
        lowest.push_back(i);
        begins.push_back(begin);
    }
    std::vector<double> added(values.size());
    std::size_t at = 0;
    for (int i = 0; i < n; ++i) {
        while (at + 1 < lowest.size() && begins[at + 1] < i) {
            ++at;
        }
        const double off = i - lowest[at];
        added[static_cast<std::size_t>(i)] = value(lowest[at]) + step2 * off * off;
    }
    values = std::move(added);
}

SourceDistance::SourceDistance(const Site& site, const std::vector<std::uint32_t>& zones,
                               double largest_cell_m)
    : metres_{frame_for(site, largest_cell_m), 0.0F} {
    const config::GridFrame& frame = metres_.frame;
    config::Raster<double> squares{frame, far};
    for (const rockfall::ReleaseSource& source : site.sources) {
        if (zones.empty() || std::binary_search(zones.begin(), zones.end(), source.zone)) {
            constexpr int steps = 8;  // along a line, or through a cell
            for (int i = 0; i <= steps; ++i) {
                const double share = static_cast<double>(i) / steps;
                squares.at(nearest_cell(frame, source.first_m + share * (source.last_m - source.first_m))) =
                    0.0;
            }
        }
    }
    std::vector<double> line(static_cast<std::size_t>(frame.columns));
    for (int row = 0; row < frame.rows; ++row) {
        for (int column = 0; column < frame.columns; ++column) {
            line[static_cast<std::size_t>(column)] = squares.at({column, row});
        }
        add_distances(line, frame.cell_width_m);
        for (int column = 0; column < frame.columns; ++column) {
            squares.at({column, row}) = line[static_cast<std::size_t>(column)];
        }
    }
    line.resize(static_cast<std::size_t>(frame.rows));
    for (int column = 0; column < frame.columns; ++column) {
        for (int row = 0; row < frame.rows; ++row) {
            line[static_cast<std::size_t>(row)] = squares.at({column, row});
        }
        add_distances(line, frame.cell_height_m);
        for (int row = 0; row < frame.rows; ++row) {
            metres_.at({column, row}) = static_cast<float>(std::sqrt(line[static_cast<std::size_t>(row)]));
        }
    }
}

double SourceDistance::at(const Eigen::Vector2d& place_m) const {
    return static_cast<double>(metres_.at(nearest_cell(metres_.frame, place_m)));
}

}  // namespace coupling::calibrate
