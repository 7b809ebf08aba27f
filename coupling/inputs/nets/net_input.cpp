#include "coupling/inputs/nets/net_input.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/inputs/plausible/beyond_terrain.hpp"
#include "coupling/inputs/plausible/cut_command.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/plausible/share_on_terrain.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/net_settings.hpp"
#include "coupling/inputs/tables/meant_columns.hpp"
#include "coupling/inputs/tables/needed_columns.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::joined;

using config::above;

constexpr config::NumberRange height_range_m{0.0, 50.0, above};
/// [choice] Of 66 nets that were approved by ETAG 027 the strongest held 10 400 kJ, in the open class above
/// 4500 kJ (Geosciences 2019, 9(1), 49). Joules begin far beyond: 35 kJ are 35 000 J.
constexpr double strongest_net_kj = 10'400.0;
constexpr double joules_from_kj = 35'000.0;
constexpr double shortest_net_m = 0.1;
/// So far apart lie the places at which a net is looked at for ground below it.
constexpr double ground_step_m = 1.0;
/// Outside of these a figure is likely to be meant in another unit [choice]: nets on offer begin at 1.5 m and
/// 35 kJ, and the highest are 10 m high.
constexpr double low_net_m = 0.5;
constexpr double highest_net_m = 12.0;
constexpr double weak_net_kj = 10.0;

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

void take_capacity(const config::Read<ListedNet>& row, const config::Table& table, rockfall::Net& net,
                   config::RowProblems& wrong) {
    const bool by_class = !row.energy_class.empty();
    if (row.capacity_kj.has_value() == by_class) {
        wrong.refuse(row.row, table.has("capacity_kj") ? "capacity_kj" : "class",
                     by_class ? "both capacity_kj and class" : "neither capacity_kj nor class",
                     "one of them");
        return;
    }
    if (!by_class) {
        if (*row.capacity_kj >= joules_from_kj) {
            wrong.refuse(row.row, "capacity_kj",
                         joined("a net that takes ", config::to_text(*row.capacity_kj),
                                " kJ, which looks like joules"),
                         "kilojoules: the strongest approved nets take 10 400 kJ",
                         "divide the column capacity_kj by 1000");
        }
        net.capacity_j = j_per_kj * *row.capacity_kj;
        return;
    }
    const auto& classes = net_classes();
    const auto found = std::find_if(classes.begin(), classes.end(),
                                    [&](const NetClass& c) { return c.name == row.energy_class; });
    if (found == classes.end()) {
        wrong.refuse(row.row, "class", joined("class ", config::in_quotes(row.energy_class)),
                     joined("a class of `bannwald info net_classes`: ", classes.front().name, " to ",
                            classes[classes.size() - 2].name));
    } else if (std::isinf(found->mel_kj)) {
        wrong.refuse(row.row, "class",
                     joined("class ", config::in_quotes(found->name), ", which has no upper limit"),
                     "capacity_kj of the net instead");
    } else {
        net.capacity_j = j_per_kj * found->mel_kj;
    }
}

void take_line(const config::Read<ListedNet>& row, rockfall::Net& net, config::RowProblems& wrong) {
    std::vector<Eigen::Vector2d>& line = net.line_m;
    double length_m = 0.0;
    for (const config::Point2& point : row.line.parts.front()) {
        const Eigen::Vector2d corner{point.x_m, point.y_m};
        if (line.empty() || corner != line.back()) {  // a corner given twice is one corner
            length_m += line.empty() ? 0.0 : (corner - line.back()).norm();
            line.push_back(corner);
        }
    }
    if (length_m < shortest_net_m) {
        wrong.refuse(row.row, "wkt", joined("a net of length ", config::metres_in_words(length_m), " m"),
                     joined("at least ", config::to_text(shortest_net_m), " m"),
                     "check whether its corners are metres, not degrees or kilometres");
    } else if (meets_itself(line)) {
        wrong.refuse(row.row, "wkt",
                     joined("net ", config::in_quotes(row.name), " crosses or touches itself"),
                     "a line that does not");
    }
}

NetRecord net_of(const config::Read<ListedNet>& row, const config::Table& table, config::RowProblems& wrong) {
    NetRecord record{row.name, row.energy_class, {}, row.cost};
    if (row.cost.investment.has_value() != row.cost.life_years.has_value()) {
        wrong.refuse(
            row.row, row.cost.investment ? "life_years" : "investment",
            row.cost.investment ? "an investment without life_years" : "life_years without an investment",
            "both, or none of them");
    }
    record.net.height_m = row.height_m;
    record.net.gap_m = row.gap_m;
    if (row.gap_m >= row.height_m) {
        wrong.refuse(row.row, "gap_m",
                     joined("a gap of ", config::to_text(row.gap_m), " m below a net up to ",
                            config::to_text(row.height_m), " m"),
                     "gap_m below height_m");
    }
    take_capacity(row, table, record.net, wrong);
    take_line(row, record.net, wrong);
    return record;
}

/// Two nets in one place: a rock would meet both at once.
void check_place_of_last(const GivenNets& given, std::size_t row, config::RowProblems& wrong) {
    const NetRecord& net = given.nets.back();
    for (std::size_t other = 0; other + 1 < given.nets.size(); ++other) {
        const NetRecord& before = given.nets[other];
        const double shared_m = length_in_one_place_m(before.net.line_m, net.net.line_m);
        if (shared_m > 0.0) {
            wrong.refuse(
                row, "wkt",
                joined("net ", config::in_quotes(net.name), " in the place of net ",
                       config::in_quotes(before.name), " of line ", std::to_string(given.lines[other].line),
                       " over ", to_centimetres(shared_m), " m"),
                "nets apart from each other: where two stand in one place, rocks that break the first "
                "would miss the second");
        }
    }
}

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

const config::Schema<ListedNet>& net_columns() {
    const auto cost = [](auto member) {
        return [member](ListedNet & row) -> auto& {
            return row.cost.*member;
        };
    };
    // clang-format off
    static const config::Schema<ListedNet> columns{
        {.role = "nets", .setting = "nets.file", .row = "net", .no_rows = "at least one, or no nets.file"},
        {{"name", &ListedNet::name, "in results", {.unique = true}},
         {"height_m", &ListedNet::height_m, "of the upper edge above the ground, vertical", {.range = height_range_m}},
         {"gap_m", &ListedNet::gap_m, "between ground and lower edge, through which rocks pass; empty: 0", {.range = {0.0, 50.0}, .optional = true}},
         {"capacity_kj", &ListedNet::capacity_kj, "energy that it takes at most", {.range = {.low = 0.0, .low_excluded = true}}},
         {"class", &ListedNet::energy_class, "instead: a class of `bannwald info net_classes`", {.optional = true}},
         {"investment", cost(&BarrierCost::investment), "what it costs to build, in risk.currency", {.range = {0.0, 1e12}}},
         {"life_years", cost(&BarrierCost::life_years), "how long it stands", {.unit = "yr", .range = {1.0, 1000.0}}},
         {"maintenance_percent", cost(&BarrierCost::maintenance_percent), "what it costs a year, of the investment; empty: 0", {.unit = "%", .range = {0.0, 100.0}, .optional = true}},
         {"wkt", &ListedNet::line, "the line", {.shapes = {config::Shape::Kind::line}, .single = true}}}};
    // clang-format on
    return columns;
}

GivenNets nets_of(const config::Table& table, Standing standing, GivenNets given) {
    config::Problems missing;
    require_columns(table, net_columns(), missing);
    missing.throw_if_any();
    config::RowProblems wrong{table};
    const auto before = static_cast<std::ptrdiff_t>(given.nets.size());
    for (const config::Read<ListedNet>& row : net_columns().rows(table, wrong)) {
        if (std::any_of(given.nets.begin(), given.nets.begin() + before,
                        [&](const NetRecord& other) { return other.name == row.name; })) {
            wrong.refuse(row.row, "name",
                         joined("net ", config::in_quotes(row.name), " of another file of nets too"),
                         "one name for each net", "change it in one of the files");
        }
        given.nets.push_back(net_of(row, table, wrong));
        given.lines.push_back(table.place(row.row, "wkt"));
        if (standing == Standing::together) {
            check_place_of_last(given, row.row, wrong);
        }
    }
    wrong.throw_first();
    return given;
}

std::vector<config::Problem> net_warnings(const config::Table& table, const std::vector<NetRecord>& nets) {
    std::vector<config::Problem> warnings = misspelt_columns(table, net_columns().names());
    const auto warn = [&](config::Place place, std::string found, std::string expected,
                          std::string advice = "") {
        warnings.push_back({config::ExitCode::data, std::move(place), std::move(found), std::move(expected),
                            std::move(advice)});
    };
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

namespace {

/// With other costs the same rocks fall.
void leave_costs_out_of_hash(const config::Table& table, Reading& reading) {
    const auto is_there = [&](const char* column) { return table.has(column); };
    constexpr std::array costs{"investment", "life_years", "maintenance_percent"};
    if (std::none_of(costs.begin(), costs.end(), is_there)) {
        return;
    }
    std::string text;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (const char* column : {"name", "height_m", "gap_m", "capacity_kj", "class", "wkt"}) {
            text += joined(table.has(column) ? table.text(row, column) : std::string{}, "\n");
        }
    }
    reading.use_part_of("nets", "all but costs", hash_text(text));
}

}  // namespace

std::optional<GivenNets> read_nets(Reading& reading) {
    const std::string& file = reading.nets().file;
    if (file.empty()) {
        return GivenNets{};
    }
    return reading.attempt([&] {
        GivenNets given;
        for (const NamedTable& name : tables_in(file)) {
            const config::Table table = reading.table("nets.file", "nets", name.name, name.id_opening);
            const auto before = static_cast<std::ptrdiff_t>(given.nets.size());
            given = nets_of(table, Standing::together, std::move(given));
            leave_costs_out_of_hash(table, reading);
            const std::vector<NetRecord> of_table(given.nets.begin() + before, given.nets.end());
            for (const config::Problem& found : net_warnings(table, of_table)) {
                reading.warn(found.place, found.found, found.expected, found.advice);
            }
        }
        return given;
    });
}

std::vector<NetRecord> on_terrain(GivenNets given, const rockfall::Terrain& terrain, Reading& reading) {
    const std::string& file = reading.nets().file;
    const plausible::Extent extent = plausible::extent_of(terrain);
    plausible::ThingsOnTerrain things{{shown_tables(file, reading)},
                                      "net",
                                      {},
                                      "a line wholly on the terrain",
                                      "exchange x and y in the lines",
                                      plausible::cut_command_of_first(reading, "nets", file, extent)};
    GivenNets kept;
    for (std::size_t i = 0; i < given.nets.size(); ++i) {
        config::Shape shape{config::Shape::Kind::line, {{}}};
        for (const Eigen::Vector2d& corner : given.nets[i].net.line_m) {
            shape.parts.front().push_back({corner.x(), corner.y()});
        }
        const bool is_beyond = !plausible::touches_terrain(shape, terrain, extent);
        things.things.push_back({given.nets[i].name, shape.parts.front(), is_beyond, given.lines[i]});
        if (!is_beyond) {
            kept.nets.push_back(std::move(given.nets[i]));
            kept.lines.push_back(std::move(given.lines[i]));
        }
    }
    plausible::judge_beyond_terrain(things, extent, reading);
    return on_terrain(std::move(kept), terrain, reading.problems());
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
