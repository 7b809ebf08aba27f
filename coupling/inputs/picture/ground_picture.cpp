#include "coupling/inputs/picture/ground_picture.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/systems/extent.hpp"

namespace coupling {
namespace picture {
namespace {

using config::joined;

/// Numbers from `begin` up to `end`.
struct Span {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

/// The pixels of a row or column that reach into a part of it; in pixels from the first one.
Span pixels_in(double from, double to, std::uint32_t count) {
    constexpr double slack = 1e-6;  // a rim that lies on the border between two pixels
    const double last = static_cast<double>(count);
    const double begin = std::clamp(std::floor(from + slack), 0.0, last - 1.0);
    const double end = std::clamp(std::ceil(to - slack), begin + 1.0, last);
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

/// Part `number` of `parts` of a row or column of pixels: at least one.
Span part_of_span(const Span& span, std::uint32_t number, std::uint32_t parts) {
    const auto at = [&](std::uint32_t i) {
        return span.begin + static_cast<std::uint32_t>(std::uint64_t{i} * span.size() / parts);
    };
    return {at(number), std::max(at(number) + 1, at(number + 1))};
}

}  // namespace

double covered_share(const config::GridFrame& picture, const config::GridFrame& map) {
    const double width_m =
        std::min(picture.x_east_m(), map.x_east_m()) - std::max(picture.x_west_m, map.x_west_m);
    const double height_m =
        std::min(picture.y_north_m(), map.y_north_m()) - std::max(picture.y_south_m, map.y_south_m);
    const double map_m2 = (map.x_east_m() - map.x_west_m) * (map.y_north_m() - map.y_south_m);
    return std::max(0.0, width_m) * std::max(0.0, height_m) / map_m2;
}

GroundPicture cut_out(const PlacedPicture& placed, const config::GridFrame& map, std::uint32_t most_a_side) {
    const config::GridFrame& from = placed.frame;
    const Span columns = pixels_in((map.x_west_m - from.x_west_m) / from.cell_width_m,
                                   (map.x_east_m() - from.x_west_m) / from.cell_width_m, placed.pixels.width);
    const Span rows =
        pixels_in((from.y_north_m() - map.y_north_m()) / from.cell_height_m,
                  (from.y_north_m() - map.y_south_m) / from.cell_height_m, placed.pixels.height);
    const double scale =
        std::max(1.0, static_cast<double>(std::max(columns.size(), rows.size())) / most_a_side);
    const auto reduced = [&](std::uint32_t size) {
        return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(size / scale));
    };
    GroundPicture cut;
    cut.pixels.width = reduced(columns.size());
    cut.pixels.height = reduced(rows.size());
    cut.pixels.rgb.reserve(std::size_t{3} * cut.pixels.width * cut.pixels.height);
    for (std::uint32_t row = 0; row < cut.pixels.height; ++row) {
        const Span of_row = part_of_span(rows, row, cut.pixels.height);
        for (std::uint32_t column = 0; column < cut.pixels.width; ++column) {
            const Span of_column = part_of_span(columns, column, cut.pixels.width);
            std::uint64_t sums[3] = {0, 0, 0};
            for (std::uint32_t r = of_row.begin; r < of_row.end; ++r) {
                const std::uint8_t* pixel =
                    placed.pixels.rgb.data() + 3 * (std::size_t{r} * placed.pixels.width + of_column.begin);
                for (std::uint32_t c = of_column.begin; c < of_column.end; ++c, pixel += 3) {
                    sums[0] += pixel[0];
                    sums[1] += pixel[1];
                    sums[2] += pixel[2];
                }
            }
            const std::uint64_t count = std::uint64_t{of_row.size()} * of_column.size();
            for (const std::uint64_t sum : sums) {
                cut.pixels.rgb.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
            }
        }
    }
    cut.frame = {.columns = static_cast<int>(cut.pixels.width),
                 .rows = static_cast<int>(cut.pixels.height),
                 .x_west_m = from.x_west_m + columns.begin * from.cell_width_m,
                 .y_south_m = from.y_north_m() - rows.end * from.cell_height_m,
                 .cell_width_m = columns.size() * from.cell_width_m / cut.pixels.width,
                 .cell_height_m = rows.size() * from.cell_height_m / cut.pixels.height};
    return cut;
}

}  // namespace picture

namespace {

std::shared_ptr<const GroundPicture> picture_on(const config::GridFrame& map, Reading& reading) {
    using config::joined;
    const std::string& name = reading.terrain().picture;
    const std::string file = reading.shown(name);
    const FileBytes bytes =
        reading.open("terrain.picture", "picture", name, "a GeoTIFF, or a PNG or JPEG with a world file");
    std::deque<std::string> texts;  // what lies beside, while it is read
    const picture::PlacedPicture placed =
        picture::read_picture(bytes.text(), file, [&](const std::string& ending) -> std::string_view {
            const std::string beside = reading.name_beside(name, ending);
            if (!path_exists(reading.settings().resolve(beside))) {
                return {};
            }
            return texts.emplace_back(reading.text_beside(joined("picture ", ending), beside));
        });
    const double share = picture::covered_share(placed.frame, map);
    if (!(share > 0.0)) {
        config::fail(config::ExitCode::data, {file},
                     joined("a picture of ", plausible::in_words(plausible::extent_of(placed.frame))),
                     joined("one that shows the terrain, ", plausible::in_words(plausible::extent_of(map))),
                     "transform it to the system of the heights (QGIS: Warp), or name another picture");
    }
    if (placed.projection.empty()) {
        reading.note(joined(file, ": names no coordinate system; taken as that of the terrain"));
    }
    reading.take_system("picture", name, placed.projection);
    constexpr double whole = 0.995;  // the note has whole per cents
    if (share < whole) {
        reading.note(joined(file, ": covers ", std::to_string(std::lround(100.0 * share)), " % of the map"));
    }
    return std::make_shared<const GroundPicture>(picture::cut_out(placed, map));
}

}  // namespace

std::shared_ptr<const GroundPicture> read_ground_picture(const config::GridFrame& map, Reading& reading) {
    if (reading.terrain().picture.empty()) {
        return nullptr;
    }
    return reading.attempt([&] { return picture_on(map, reading); }).value_or(nullptr);
}

}  // namespace coupling
