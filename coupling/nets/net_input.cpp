#include "coupling/nets/net_input.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/numbers.hpp"
#include "coupling/inputs/shape_input.hpp"
#include "coupling/nets/net_classes.hpp"
#include "coupling/results/joined.hpp"

namespace coupling {
namespace {

constexpr config::NumberRange height_range_m{.low = 0.0, .high = 50.0, .low_excluded = true};
constexpr config::NumberRange gap_range_m{.low = 0.0, .high = 50.0};
constexpr config::NumberRange capacity_range_kj{.low = 0.0, .high = 1e6, .low_excluded = true};
constexpr double j_per_kj = 1000.0;
constexpr double shortest_net_m = 0.1;
/// So far apart lie the places at which a net is looked at for ground below it.
constexpr double ground_step_m = 1.0;

double side_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool is_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return side_of(a, b, p) == 0.0 && (p - a).dot(p - b) <= 0.0;
}

/// Whether two pieces of line have a point in common.
bool touch(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
           const Eigen::Vector2d& d) {
    const double c_side = side_of(a, b, c);
    const double d_side = side_of(a, b, d);
    const double a_side = side_of(c, d, a);
    const double b_side = side_of(c, d, b);
    return (c_side * d_side < 0.0 && a_side * b_side < 0.0) || is_between(a, b, c) || is_between(a, b, d) ||
           is_between(c, d, a) || is_between(c, d, b);
}

/// A line that meets itself, but for one that closes, has no order along it.
bool meets_itself(const std::vector<Eigen::Vector2d>& line) {
    const std::size_t pieces = line.size() - 1;
    const bool closed = line.front() == line.back();
    for (std::size_t i = 0; i < pieces; ++i) {
        for (std::size_t j = i + 1; j < pieces; ++j) {
            const bool next_to_it = j == i + 1 || (closed && i == 0 && j + 1 == pieces);
            if (!next_to_it && touch(line[i], line[i + 1], line[j], line[j + 1])) {
                return true;
            }
            if (j == i + 1 && (is_between(line[i], line[i + 1], line[j + 1]) ||
                               is_between(line[j], line[j + 1], line[i]))) {
                return true;  // folds back onto itself
            }
        }
    }
    return false;
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
            record.net.capacity_j =
                j_per_kj * table_.number(row, "capacity_kj", capacity_range_kj, problems_).value_or(0.0);
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
            refuse(row, "wkt", joined("a net of length ", config::to_text(length_m), " m"),
                   joined("at least ", config::to_text(shortest_net_m), " m"));
        } else if (meets_itself(line)) {
            refuse(row, "wkt", joined("net ", config::in_quotes(record.name), " crosses or touches itself"),
                   "a line that does not");
        }
    }

    const config::Table& table_;
    config::Problems& problems_;
};

}  // namespace

std::optional<Eigen::Vector2d> first_place_off_ground(const rockfall::Net& net,
                                                      const rockfall::Terrain& terrain) {
    for (std::size_t i = 0; i + 1 < net.line_m.size(); ++i) {
        const Eigen::Vector2d way_m = net.line_m[i + 1] - net.line_m[i];
        const int steps = static_cast<int>(std::ceil(way_m.norm() / ground_step_m));
        for (int k = 0; k <= steps; ++k) {
            const Eigen::Vector2d place = net.line_m[i] + static_cast<double>(k) / steps * way_m;
            if (!terrain.locate(place.x(), place.y())) {
                return place;
            }
        }
    }
    return std::nullopt;
}

std::vector<NetRecord> nets_of(const config::Table& table) {
    config::Problems problems;
    table.require({"name", "height_m", "wkt"}, problems);
    problems.throw_if_any();
    const NetTable rows{table, problems};
    std::vector<NetRecord> nets;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        rows.check_name(row, nets);
        nets.push_back(rows.net_of(row));
    }
    if (nets.empty()) {
        problems.add(config::ExitCode::data, {table.file()}, "no nets", "at least one, or no nets.file");
    }
    config::Problems shown;
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    return nets;
}

std::optional<std::vector<NetRecord>> read_nets(Reading& reading) {
    const std::string& file = reading.scenario().nets.file;
    if (file.empty()) {
        return std::vector<NetRecord>{};
    }
    return reading.attempt([&] { return nets_of(reading.table("nets.file", "nets", file)); });
}

std::vector<NetRecord> on_terrain(std::vector<NetRecord> nets, const rockfall::Terrain& terrain,
                                  const std::string& file, config::Problems& problems) {
    const Eigen::Vector2d origin_m = terrain.origin_m();
    for (NetRecord& record : nets) {
        for (Eigen::Vector2d& corner : record.net.line_m) {
            corner -= origin_m;
        }
        if (const auto place = first_place_off_ground(record.net, terrain)) {
            problems.add(config::ExitCode::data, {file},
                         joined("net ", config::in_quotes(record.name), " leaves the terrain at x ",
                                config::to_text(place->x() + origin_m.x()), ", y ",
                                config::to_text(place->y() + origin_m.y())),
                         "a line wholly on the terrain");
        }
    }
    return nets;
}

}  // namespace coupling
