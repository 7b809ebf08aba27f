#include "coupling/inputs/nets/net_input.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/inputs/places/shape_input.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/tables/meant_columns.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::joined;

constexpr config::NumberRange height_range_m{.low = 0.0, .high = 50.0, .low_excluded = true};
constexpr config::NumberRange gap_range_m{.low = 0.0, .high = 50.0};
/// [choice] Of 66 nets that were approved by ETAG 027 the strongest held 10 400 kJ, in the open class above
/// 4500 kJ (Geosciences 2019, 9(1), 49). Joules begin far beyond: 35 kJ are 35 000 J.
constexpr double strongest_net_kj = 10'400.0;
constexpr double joules_from_kj = 35'000.0;
constexpr config::NumberRange capacity_range_kj{.low = 0.0, .low_excluded = true};
constexpr double shortest_net_m = 0.1;
/// So far apart lie the places at which a net is looked at for ground below it.
constexpr double ground_step_m = 1.0;
/// Outside of these a figure is likely to be meant in another unit [choice]: nets on offer begin at 1.5 m and
/// 35 kJ, and the highest are 10 m high.
constexpr double low_net_m = 0.5;
constexpr double highest_net_m = 12.0;
constexpr double weak_net_kj = 10.0;

const std::vector<std::string>& net_columns() {
    static const std::vector<std::string> columns{"name", "height_m", "capacity_kj", "class", "gap_m", "wkt"};
    return columns;
}

/// A name without capitals and blanks.
std::string bare_name(const std::string& name) {
    std::string bare;
    for (const char letter : name) {
        if (letter != ' ' && letter != '\t') {
            bare += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        }
    }
    return bare;
}

/// A table of nets, row by row; what is wrong becomes a problem.
class NetTable {
public:
    NetTable(const config::Table& table, config::Problems& problems) : table_{table}, problems_{problems} {}

    [[nodiscard]] NetRecord net_of(std::size_t row) const {
        NetRecord record;
        record.name = table_.text(row, "name");
        record.net.height_m = table_.number(row, "height_m", height_range_m, problems_).value_or(0.0);
        if (has_value(table_, row, "gap_m")) {
            record.net.gap_m = table_.number(row, "gap_m", gap_range_m, problems_).value_or(0.0);
            if (record.net.height_m > 0.0 && record.net.gap_m >= record.net.height_m) {
                refuse(row, "gap_m",
                       joined("a gap of ", config::to_text(record.net.gap_m), " m below a net up to ",
                              config::to_text(record.net.height_m), " m"),
                       "gap_m below height_m");
            }
        }
        take_capacity(row, record);
        take_line(row, record);
        return record;
    }

    void check_name(std::size_t row, const std::vector<NetRecord>& before) const {
        const std::string& name = table_.text(row, "name");
        const bool doubled =
            std::any_of(before.begin(), before.end(), [&](const NetRecord& n) { return n.name == name; });
        if (name.empty() || doubled) {
            refuse(row, "name",
                   name.empty() ? "no name" : joined("name ", config::in_quotes(name), " a second time"),
                   "one name for each net");
        }
    }

    /// Two nets in one place: a rock would meet both at once.
    void check_place(std::size_t row, const std::vector<NetRecord>& before) const {
        const std::string& name = table_.text(row, "name");
        const std::vector<Eigen::Vector2d>& line = before[row].net.line_m;
        for (std::size_t other = 0; other < row; ++other) {
            const double shared_m = length_in_one_place_m(before[other].net.line_m, line);
            if (shared_m > 0.0) {
                refuse(row, "wkt",
                       joined("net ", config::in_quotes(name), " in the place of net ",
                              config::in_quotes(before[other].name), " of line ",
                              std::to_string(table_.place(other, "wkt").line), " over ",
                              to_centimetres(shared_m), " m"),
                       "nets apart from each other: where two stand in one place, rocks that break the first "
                       "would miss the second");
            }
        }
    }

private:
    void refuse(std::size_t row, const char* column, std::string found, std::string expected) const {
        problems_.add(config::ExitCode::data, table_.place(row, column), std::move(found),
                      std::move(expected));
    }

    void take_capacity(std::size_t row, NetRecord& record) const {
        const bool by_number = has_value(table_, row, "capacity_kj");
        const bool by_class = has_value(table_, row, "class");
        if (by_number == by_class) {
            refuse(row,
                   table_.has("capacity_kj") ? "capacity_kj"
                   : table_.has("class")     ? "class"
                                             : "name",
                   by_number ? "both capacity_kj and class" : "neither capacity_kj nor class", "one of them");
            return;
        }
        if (by_number) {
            const double capacity_kj =
                table_.number(row, "capacity_kj", capacity_range_kj, problems_).value_or(0.0);
            if (capacity_kj >= joules_from_kj) {
                problems_.add(config::ExitCode::data, table_.place(row, "capacity_kj"),
                              joined("a net that takes ", table_.text(row, "capacity_kj"),
                                     " kJ, which looks like joules"),
                              "kilojoules: the strongest approved nets take 10 400 kJ",
                              "divide the column capacity_kj by 1000");
            }
            record.net.capacity_j = j_per_kj * capacity_kj;
            return;
        }
        record.energy_class = table_.text(row, "class");
        const auto& classes = net_classes();
        const auto found = std::find_if(classes.begin(), classes.end(),
                                        [&](const NetClass& c) { return c.name == record.energy_class; });
        if (found == classes.end()) {
            refuse(row, "class", joined("class ", config::in_quotes(record.energy_class)),
                   joined("a class of `bannwald info net_classes`: ", classes.front().name, " to ",
                          classes[classes.size() - 2].name));
        } else if (std::isinf(found->mel_kj)) {
            refuse(row, "class",
                   joined("class ", config::in_quotes(found->name), ", which has no upper limit"),
                   "capacity_kj of the net instead");
        } else {
            record.net.capacity_j = j_per_kj * found->mel_kj;
        }
    }

    void take_line(std::size_t row, NetRecord& record) const {
        const auto shape = shape_of(table_, row, {config::Shape::Kind::line}, problems_);
        if (!shape) {
            return;
        }
        if (shape->parts.size() != 1) {
            refuse(row, "wkt", joined(std::to_string(shape->parts.size()), " lines"),
                   "one line for each net");
            return;
        }
        std::vector<Eigen::Vector2d>& line = record.net.line_m;
        double length_m = 0.0;
        for (const config::Point2& point : shape->parts.front()) {
            const Eigen::Vector2d corner{point.x_m, point.y_m};
            if (line.empty() || corner != line.back()) {  // a corner given twice is one corner
                length_m += line.empty() ? 0.0 : (corner - line.back()).norm();
                line.push_back(corner);
            }
        }
        if (length_m < shortest_net_m) {
            problems_.add(config::ExitCode::data, table_.place(row, "wkt"),
                          joined("a net of length ", config::metres_in_words(length_m), " m"),
                          joined("at least ", config::to_text(shortest_net_m), " m"),
                          "check whether its corners are metres, not degrees or kilometres");
        } else if (meets_itself(line)) {
            refuse(row, "wkt", joined("net ", config::in_quotes(record.name), " crosses or touches itself"),
                   "a line that does not");
        }
    }

    const config::Table& table_;
    config::Problems& problems_;
};

/// A net that leaves the terrain: where, or why the whole line lies elsewhere. Absolute coordinates.
config::Problem off_terrain_problem(const std::string& name, const std::vector<config::Point2>& line,
                                    const config::Point2& first_off, const plausible::Extent& terrain,
                                    config::Place place) {
    const std::string net = joined("net ", config::in_quotes(name));
    const std::string expected = "a line wholly on the terrain";
    if (std::any_of(line.begin(), line.end(), [&](const auto& corner) { return terrain.contains(corner); })) {
        return {config::ExitCode::data, std::move(place),
                joined(net, " leaves the terrain at x ", to_centimetres(first_off.x_m), ", y ",
                       to_centimetres(first_off.y_m)),
                expected, "shorten the net, or take a larger terrain"};
    }
    const plausible::OffCause cause =
        plausible::cause_off_terrain(terrain, line, "exchange x and y in the lines");
    return {config::ExitCode::data, std::move(place),
            joined(net, " outside the terrain: ", cause.reason, "; the net spans ",
                   plausible::in_words(plausible::extent_of(line)), ", the terrain ",
                   plausible::in_words(terrain)),
            expected, cause.advice};
}

}  // namespace

std::optional<Eigen::Vector2d> first_place_off_ground(const rockfall::Net& net,
                                                      const rockfall::Terrain& terrain) {
    for (std::size_t i = 0; i + 1 < net.line_m.size(); ++i) {
        const Eigen::Vector2d way_m = net.line_m[i + 1] - net.line_m[i];
        // As far as coordinates reach, the steps outnumber an int; the first one off the ground ends them.
        const double steps = std::ceil(way_m.norm() / ground_step_m);
        for (double k = 0.0; k <= steps; ++k) {
            const Eigen::Vector2d place = net.line_m[i] + k / steps * way_m;
            if (!terrain.locate(place.x(), place.y())) {
                return place;
            }
        }
    }
    return std::nullopt;
}

GivenNets nets_of(const config::Table& table, Standing standing) {
    config::Problems problems;
    table.require({"name", "height_m", "wkt"}, problems);
    problems.throw_if_any();
    const NetTable rows{table, problems};
    GivenNets given;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        rows.check_name(row, given.nets);
        given.nets.push_back(rows.net_of(row));
        given.lines.push_back(table.place(row, "wkt"));
        if (standing == Standing::together) {
            rows.check_place(row, given.nets);
        }
    }
    if (given.nets.empty()) {
        problems.add(config::ExitCode::data, {table.file()}, "no nets", "at least one, or no nets.file");
    }
    config::Problems shown;
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    return given;
}

std::vector<config::Problem> net_warnings(const config::Table& table, const std::vector<NetRecord>& nets) {
    std::vector<config::Problem> warnings;
    const auto warn = [&](config::Place place, std::string found, std::string expected,
                          std::string advice = "") {
        warnings.push_back({config::ExitCode::data, std::move(place), std::move(found), std::move(expected),
                            std::move(advice)});
    };
    for (const std::string& column : table.columns_beside(net_columns())) {
        const std::string like = meant_column(column, net_columns());
        if (!like.empty() && !table.has(like) &&
            !config::is_other_unit(config::form_of(column), config::form_of(like))) {
            warn({table.file()}, joined("column ", config::in_quotes(column), ", which is passed over"),
                 joined(like, ", if that is what is meant"));
            table.count_as_named(column);
        }
    }
    for (std::size_t row = 0; row < nets.size(); ++row) {
        const NetRecord& record = nets[row];
        const double capacity_kj = record.net.capacity_j / j_per_kj;
        if (record.net.height_m < low_net_m || record.net.height_m > highest_net_m) {
            warn(table.place(row, "height_m"),
                 joined("a net of ", config::to_text(record.net.height_m), " m"),
                 "a height in metres: nets are 1.5 to 10 m high",
                 record.net.height_m < low_net_m ? "check the unit of the column height_m"
                                                 : "multiply feet by 0.3048, divide decimetres by 10");
        }
        if (record.energy_class.empty() && capacity_kj < weak_net_kj) {
            warn(table.place(row, "capacity_kj"),
                 joined("a net that takes ", config::to_text(capacity_kj), " kJ"),
                 "kilojoules: the weakest nets on offer take 35 kJ", "multiply megajoules by 1000");
        }
        if (capacity_kj > strongest_net_kj) {
            warn(table.place(row, "capacity_kj"),
                 joined("a net that takes ", config::to_text(capacity_kj), " kJ"),
                 "kilojoules: the strongest approved nets take 10 400 kJ");
        }
        for (std::size_t other = 0; other < row; ++other) {
            if (bare_name(nets[other].name) == bare_name(record.name)) {
                warn(table.place(row, "name"),
                     joined("name ", config::in_quotes(record.name), " beside ",
                            config::in_quotes(nets[other].name)),
                     "names that differ by more than capitals and blanks");
            }
        }
    }
    return warnings;
}

std::optional<GivenNets> read_nets(Reading& reading) {
    const std::string& file = reading.scenario().nets.file;
    if (file.empty()) {
        return GivenNets{};
    }
    return reading.attempt([&] {
        const config::Table table = reading.table("nets.file", "nets", file);
        GivenNets given = nets_of(table);
        for (const config::Problem& found : net_warnings(table, given.nets)) {
            reading.warn(found.place, found.found, found.expected, found.advice);
        }
        return given;
    });
}

std::vector<NetRecord> on_terrain(GivenNets given, const rockfall::Terrain& terrain,
                                  config::Problems& problems) {
    const Eigen::Vector2d origin_m = terrain.origin_m();
    for (std::size_t i = 0; i < given.nets.size(); ++i) {
        NetRecord& record = given.nets[i];
        std::vector<config::Point2> line;
        for (Eigen::Vector2d& corner : record.net.line_m) {
            line.push_back({corner.x(), corner.y()});
            corner -= origin_m;
        }
        if (const auto place = first_place_off_ground(record.net, terrain)) {
            problems.add(off_terrain_problem(record.name, line,
                                             {place->x() + origin_m.x(), place->y() + origin_m.y()},
                                             plausible::extent_of(terrain), given.lines[i]));
        }
    }
    return std::move(given.nets);
}

}  // namespace coupling
