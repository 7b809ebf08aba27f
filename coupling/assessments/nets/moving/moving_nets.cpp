#include "coupling/assessments/nets/moving/moving_nets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/moving/near_paths.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/page_scripts/json_text.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/report/map/cut_out.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::moving {
namespace {

using config::joined;
using page_scripts::json_array;
using page_scripts::json_packed;
using page_scripts::JsonObject;
using report::page_text;
using report::PageFields;

/// Around the area in which a net can be moved.
constexpr double map_margin = 0.04;

std::string packed(const std::vector<double>& values) {
    return json_packed(std::span<const double>{values});
}

/// x and y of each corner, moved by an offset.
std::string packed_line(const PlanLine& line, const Eigen::Vector2d& offset_m) {
    std::vector<double> numbers;
    for (const Eigen::Vector2d& corner : line) {
        numbers.push_back(corner.x() + offset_m.x());
        numbers.push_back(corner.y() + offset_m.y());
    }
    return packed(numbers);
}

/// All that the script counts, in its order (listOf in page_scripts/sources/net_count.js): it must come to
/// the same.
std::string counted(const NetFigures& of) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> numbers{static_cast<double>(of.reached.whole), static_cast<double>(of.reached.part)};
    for (const Share& share : of.outcome) {
        numbers.push_back(static_cast<double>(share.part));
    }
    numbers.push_back(static_cast<double>(of.inexact));
    for (const NetQuantity& quantity : {of.energy_kj, of.height_m}) {
        for (const double value : {quantity.mean, quantity.p50, quantity.p90, quantity.p95.value,
                                   quantity.p99.value, quantity.max}) {
            numbers.push_back(value);
        }
    }
    if (of.design) {
        const BarrierDesign& design = *of.design;
        numbers.insert(numbers.end(),
                       {design.percentile_energy_kj, design.design_energy_kj, design.capacity_kj,
                        design.percentile_height_m, design.design_height_m, design.height_m,
                        static_cast<double>(design.held.part), static_cast<double>(design.over.part),
                        static_cast<double>(design.through.part)});
    } else {
        numbers.insert(numbers.end(), 9, unknown);
    }
    return packed(numbers);
}

std::string json_of(const NetRecord& record, std::uint32_t number, const NearPaths& near,
                    const Eigen::Vector2d& origin_m) {
    std::vector<std::string> figures;
    for (const NetFigures& of : near.figures) {
        if (of.net == number) {
            figures.push_back(counted(of));
        }
    }
    const rockfall::Net& net = record.net;
    return JsonObject{}
        .text("name", record.name)
        .text("energy_class", record.energy_class)
        .add("size", packed({net.height_m, net.gap_m, net.capacity_j / config::j_per_kj}))
        .add("line", packed_line(net.line_m, origin_m))
        .add("area", packed_line(near.areas[number].corners_m(), Eigen::Vector2d::Zero()))
        .add("counted", json_array(figures))
        .json();
}

std::string json_of(const DesignSettings& settings) {
    const DesignMargins margins = margins_of(settings);
    return JsonObject{}
        .add("percentile", config::to_text(settings.percentile))
        .add("energy_factor", config::to_text(margins.energy_factor))
        .add("height_factor", config::to_text(margins.height_factor))
        .add("freeboard_m", config::to_text(margins.freeboard_m))
        .add("sold", packed(settings.sold_heights_m))
        .json();
}

std::string json_of_classes() {
    std::vector<std::string> classes;
    for (const NetClass& one : net_classes()) {
        classes.push_back(JsonObject{}
                              .text("name", one.name)
                              .add("mel_kj", std::isfinite(one.mel_kj) ? config::to_text(one.mel_kj) : "null")
                              .json());
    }
    return json_array(classes);
}

std::string json_of(const KeptGround& ground) {
    return JsonObject{}
        .add("x", packed(ground.x_m))
        .add("y", packed(ground.y_m))
        .add("z", packed(ground.z_m))
        .add("corners", json_packed(std::span<const std::uint32_t>{ground.corners}))
        .json();
}

/// Covers become places in the list of slopes.
std::string json_of(const KeptPaths& paths, bool with_forest) {
    std::vector<std::uint8_t> slopes = paths.covers;
    for (std::uint8_t& slope : slopes) {
        slope = with_forest ? slope : 0;
    }
    return JsonObject{}
        .add("covers", json_packed(std::span<const std::uint8_t>{slopes}))
        .add("bodies", packed(paths.bodies))
        .add("body_of", json_packed(std::span<const std::uint32_t>{paths.body_of}))
        .add("pieces", json_packed(std::span<const std::uint32_t>{paths.counts}))
        .add("kinds", json_packed(std::span<const std::uint8_t>{paths.kinds}))
        .add("numbers", packed(paths.numbers))
        .json();
}

std::string numbers_of(const NearPaths& near, std::span<const NetRecord> nets, const PathsHead& head,
                       const Eigen::Vector2d& origin_m) {
    std::vector<std::string> slopes;
    for (const Cover cover : all_covers) {
        if (cover == Cover::bare || head.with_forest) {
            slopes.push_back(
                JsonObject{}
                    .text("name", cover == Cover::forest ? page_text("with forest") : page_text("bare slope"))
                    .add("rocks", std::to_string(near.rocks[index_of(cover)]))
                    .json());
        }
    }
    std::vector<std::string> records;
    for (std::uint32_t number = 0; number < nets.size(); ++number) {
        records.push_back(json_of(nets[number], number, near, origin_m));
    }
    return JsonObject{}
        .add("origin", packed({origin_m.x(), origin_m.y()}))
        .add("slopes", json_array(slopes))
        .add("every", std::to_string(near.every))
        .add("width_m", config::to_text(near.width_m))
        .add("design", json_of(head.design))
        .add("classes", json_of_classes())
        .add("nets", json_array(records))
        .add("ground", json_of(near.ground))
        .add("paths", json_of(near.paths, head.with_forest))
        .json();
}

PageFields map_of(const NetRecord& record, std::uint32_t number, const AreaAround& area,
                  const Eigen::Vector2d& origin_m, const report::MapSheet& sheet) {
    const Eigen::Vector2d size_m = area.high_m() - area.low_m();
    const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(map_margin * size_m.maxCoeff());
    const Eigen::Vector2d low_m = area.low_m() - margin_m + origin_m;
    const Eigen::Vector2d high_m = area.high_m() + margin_m + origin_m;
    const report::CutOut part{page_text("Map around the net {net}", {{"net", record.name}}),
                              {low_m.x(), low_m.y()},
                              {high_m.x(), high_m.y()}};
    std::string rim;
    for (const Eigen::Vector2d& corner : area.corners_m()) {
        rim += joined(rim.empty() ? "M" : "L", report::place(part.x_of(corner.x() + origin_m.x())), " ",
                      report::place(part.y_of(corner.y() + origin_m.y())));
    }
    return {{"number", std::to_string(number)},
            {"net", record.name},
            {"west", config::to_text(part.low.x_m)},
            {"north", config::to_text(part.high.y_m)},
            {"units", config::to_text(part.units_per_m())},
            {"map", cut_out(sheet, part, report::svg_path("net-area", joined(rim, "Z")))}};
}

}  // namespace

std::string moving_nets(NetPathsReader& paths, std::span<const NetRecord> nets,
                        const report::MapSheet& sheet) {
    const Eigen::Vector2d origin_m = paths.terrain().origin_m();
    const std::optional<NearPaths> near = paths_near(paths, nets);
    std::optional<PageFields> movable;
    if (near) {
        std::vector<PageFields> maps;
        for (std::uint32_t number = 0; number < nets.size(); ++number) {
            maps.push_back(map_of(nets[number], number, near->areas[number], origin_m, sheet));
        }
        movable = PageFields{{"width", report::exact(near->width_m)},
                             {"of_all", near->every == 1},
                             {"every", report::grouped(near->every)},
                             {"breaks", std::any_of(near->figures.begin(), near->figures.end(),
                                                    [](const NetFigures& of) { return of.inexact > 0; })},
                             {"maps", maps},
                             {"numbers", numbers_of(*near, nets, paths.head(), origin_m)}};
    }
    return report::filled_template("moving_nets.html", {{"movable", movable}});
}

}  // namespace coupling::moving
