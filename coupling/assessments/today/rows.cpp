#include "coupling/assessments/today/rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "config/text/joined.hpp"
#include "config/units/angle.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::joined;

Eigen::Vector3d absolute(const Eigen::Vector3d& place_m, const Eigen::Vector2d& origin_m) {
    return {place_m.x() + origin_m.x(), place_m.y() + origin_m.y(), place_m.z()};
}

double kj_of(double energy_j) {
    return energy_j / j_per_kj;
}

/// Clockwise from north, 0 to 360; NaN without a direction.
double azimuth_deg(const Eigen::Vector2d& way_m) {
    if (way_m.norm() < 0.005) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double degrees = config::Angle::from_radians(std::atan2(way_m.x(), way_m.y())).in_degrees();
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

const char* log_outcome_name(rockfall::LogOutcome outcome) {
    switch (outcome) {
        case rockfall::LogOutcome::climbed:
            return "climbed";
        case rockfall::LogOutcome::broke:
            return "broke";
        case rockfall::LogOutcome::turned:
            return "turned";
        case rockfall::LogOutcome::stopped:
            break;
    }
    return "stopped";
}

const char* hit_type_name(rockfall::HitType type) {
    switch (type) {
        case rockfall::HitType::frontal:
            return "frontal";
        case rockfall::HitType::lateral:
            return "lateral";
        case rockfall::HitType::scratch:
            break;
    }
    return "scratch";
}

double largest_energy_kj(std::span<const rockfall::PathPoint> points) {
    float largest_j = 0.0F;
    for (const rockfall::PathPoint& point : points) {
        largest_j = std::max(largest_j, point.energy_j);
    }
    return static_cast<double>(largest_j) / j_per_kj;
}

/// With two decimals, as std::to_chars rounds them; several times faster.
void append_centimetres(std::string& text, double value_m) {
    constexpr double most_m = 1e9;
    std::array<char, 400> digits;
    char* const end = digits.data() + digits.size();
    const double size_m = std::abs(value_m);
    if (!(size_m < most_m)) {
        text.append(digits.data(),
                    std::to_chars(digits.data(), end, value_m, std::chars_format::fixed, 2).ptr);
        return;
    }
    // The exact value is the product and what it lost; of two equally near ones the even one.
    const double product = 100.0 * size_m;
    const double lost = std::fma(100.0, size_m, -product);
    auto hundredths = static_cast<std::uint64_t>(product);
    const double beyond_half = product - static_cast<double>(hundredths) - 0.5 + lost;
    if (beyond_half > 0.0 || (beyond_half == 0.0 && hundredths % 2 == 1)) {
        ++hundredths;
    }
    char* next = digits.data();
    if (std::signbit(value_m)) {
        *next++ = '-';
    }
    next = std::to_chars(next, end, hundredths / 100).ptr;
    *next++ = '.';
    *next++ = static_cast<char>('0' + hundredths / 10 % 10);
    *next++ = static_cast<char>('0' + hundredths % 10);
    text.append(digits.data(), next);
}

/// "3:12 5:2": code of the ground and impacts on it, by code.
std::string impacts_in_words(std::vector<rockfall::GroundCount> counts) {
    std::sort(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.ground < b.ground; });
    std::string text;
    for (const rockfall::GroundCount& one : counts) {
        text += (text.empty() ? "" : " ") + std::to_string(one.ground) + ":" + std::to_string(one.impacts);
    }
    return text;
}

ColumnsOf<rockfall::RockRecord> obstacle_columns() {
    using Record = rockfall::RockRecord;
    return {
        {"impacts_by_ground",
         "code of the ground type and impacts on it, such as 3:12 5:2; blanks between the grounds",
         [](const Record& r) { return impacts_in_words(r.impacts_by_ground); }},
        {"tree_hits", "hits on trees", &Record::tree_hits},
        {"trees_broken", "hits with more energy than the tree can take", &Record::trees_broken},
        {"tree_energy_kj", 3, "energy taken by trees",
         [](const Record& r) { return kj_of(r.tree_energy_j); }},
        {"log_hits", "hits on lying logs", &Record::log_hits},
        {"logs_broken", "hits that break a log", &Record::logs_broken},
        {"log_energy_kj", 3, "energy taken by logs", [](const Record& r) { return kj_of(r.log_energy_j); }}};
}

/// What columns of a hit on a tree or a log share.
template <class Record>
ColumnsOf<HitRow<Record>> hit_columns(const char* id, const char* meaning, const char* source,
                                      const ColumnsOf<Record>& height, const ColumnsOf<Record>& rest) {
    const auto of_hit = [](const auto& row) -> const Record& { return row.hit; };
    const ColumnsOf<Record> energies{{"energy_kj", 3, "kinetic energy of the rock before the hit",
                                      [](const Record& hit) { return kj_of(hit.energy_j); }},
                                     {"energy_taken_kj", 3, joined("energy that the ", meaning, " took"),
                                      [](const Record& hit) { return kj_of(hit.loss_j); }}};
    return {{rock_column(), [](const auto& row) { return row.rock; }},
            {id, joined(meaning, " that was hit"), source, [](const auto& row) { return row.id; }},
            {place_columns("", "the rock's underside"),
             [](const auto& row) { return absolute(row.hit.position_m, row.origin_m); }},
            {height, of_hit},
            {energies, of_hit},
            {rest, of_hit}};
}

constexpr auto rock_of_row = [](const auto& row) { return row.rock; };
constexpr auto slope_of_row = [](const auto& row) { return coupling::name_of(row.cover); };

}  // namespace

const TableOf<RockRow>& rock_table() {
    static const TableOf<RockRow> table{
        "rocks.csv",
        "each rock, with forest and without: start, end, run-out, speeds, heights, why it stopped",
        "a rock on one slope",
        {{rock_column(), [](const auto& row) { return row.record.rock; }},
         {cover_column(), slope_of_row},
         {"zone", "release zone", "input release", [](const auto& row) { return row.zone; }},
         {"source", "number of the release source, from 0", "input release",
          [](const auto& row) { return row.record.source; }},
         {"diameter_m", 3, "diameter of the rock",
          "that of its source, else drawn as release.diameter_kind says",
          [](const auto& row) { return row.record.diameter_m; }},
         {"stop_reason",
          "at_rest, caught (by the roughness of the ground), tree, log, net, left_terrain or gave_up",
          [](const auto& row) { return coupling::name_of(row.record.reason); }},
         {place_columns("_start", "the release"),
          [](const auto& row) { return absolute(row.record.start_m, row.origin_m); }},
         {place_columns("_end", "the end"),
          [](const auto& row) { return absolute(row.record.end_m, row.origin_m); }},
         {"run_out_m", 2, "plan distance from release to end",
          [](const auto& row) { return row.record.run_out_m(); }},
         {"azimuth_deg", 1, "direction in plan from release to end, clockwise from north; empty on the spot",
          [](const auto& row) {
              return azimuth_deg((row.record.end_m - row.record.start_m).template head<2>());
          }},
         {"end_ground", "code of the ground type at the end", "input terrain",
          [](const auto& row) { return row.end_ground; }},
         {ColumnsOf<rockfall::RockRecord>{motion_columns(), obstacle_columns()},
          [](const auto& row) { return &row.record; }}}};
    return table;
}

const TableOf<ArrivalOfRock>& arrival_table() {
    using rockfall::Arrival;
    static const TableOf<ArrivalOfRock> table{
        "arrivals.csv",
        "each rock that reached a target: where, with which energy, speed and height",
        "a rock that reached a target on one slope",
        {{rock_column(), rock_of_row},
         {target_id_column(), [](const auto& row) { return row.target_id; }},
         {cover_column(), slope_of_row},
         {"x_m", 2, "easting of the first arrival",
          [](const auto& row) { return static_cast<double>(row.arrival.x_m) + row.origin_m.x(); }},
         {"y_m", 2, "northing of the first arrival",
          [](const auto& row) { return static_cast<double>(row.arrival.y_m) + row.origin_m.y(); }},
         {ColumnsOf<Arrival>{
              {"energy_kj", 3, joined("kinetic energy there, ", rockfall::what_energies_count()),
               [](const auto& a) { return kj_of(a.energy_j); }},
              {"translational_kj", 3, "the translational part of it",
               [](const auto& a) { return kj_of(a.translational_j); }},
              {"speed_mps", 3, "speed there", &Arrival::speed_mps},
              {"height_m", 3, "height of the underside above the ground there, vertical", &Arrival::height_m},
              {"centre_height_m", 3, "height of the rock's centre above the ground there, vertical",
               &Arrival::centre_height_m},
              {"top_height_m", 3, "height of the rock's highest point above the ground there, vertical",
               &Arrival::top_height_m},
              {"by_side", "yes: the centre of the rock passes beside the target, its side touches it",
               &Arrival::by_side}},
          [](const auto& row) -> const Arrival& { return row.arrival; }}}};
    return table;
}

const TableOf<HitRow<rockfall::TreeHitRecord>>& tree_hit_table() {
    using Hit = rockfall::TreeHitRecord;
    static const TableOf<HitRow<Hit>> table{
        "tree_hits.csv", "each hit of a rock on a tree", "a hit of a rock on a tree",
        hit_columns<Hit>(
            "tree_id", "tree", "input trees.file, or drawn from stands.records",
            {"height_m", 2, "height of the rock's centre above the ground at the stem", &Hit::height_m},
            {{"hit_type", "frontal, lateral or scratch",
              [](const Hit& hit) { return hit_type_name(hit.type); }},
             {"broken", "yes: the hit had more energy than the tree can take", &Hit::broken},
             {"stopped", "yes: the rock stopped at the tree", &Hit::stopped}})};
    return table;
}

const TableOf<HitRow<rockfall::LogHitRecord>>& log_hit_table() {
    using Hit = rockfall::LogHitRecord;
    static const TableOf<HitRow<Hit>> table{
        "log_hits.csv", "each hit of a rock on a lying log", "a hit of a rock on a lying log",
        hit_columns<Hit>("log_id", "log", "input trees.logs", {},
                         {"outcome", "climbed, broke, turned or stopped",
                          [](const Hit& hit) { return log_outcome_name(hit.outcome); }})};
    return table;
}

const TableOf<PathRow>& path_table() {
    static const TableOf<PathRow> table{
        "trajectories.csv",
        "Sampled paths point by point with energy and height.",
        "a corner of a sampled path",
        {{rock_column(), rock_of_row},
         {cover_column(), slope_of_row},
         {"point", "number of the corner along the path, from 0", [](const auto& row) { return row.number; }},
         {place_columns("", "the rock's underside"),
          [](const auto& row) { return absolute(row.point.position_m, row.origin_m); }},
         {"energy_kj", 3, joined("kinetic energy, ", rockfall::what_energies_count()),
          [](const auto& row) { return kj_of(row.point.energy_j); }},
         {"height_m", 2, "height of the underside above the ground, vertical",
          [](const auto& row) { return row.point.height_m; }}}};
    return table;
}

const TableOf<WholePath>& wkt_table() {
    static const TableOf<WholePath> table{
        "trajectories_wkt.csv",
        "Sampled paths as lines (WKT) for QGIS.",
        "a sampled path",
        {{rock_column(), rock_of_row},
         {cover_column(), slope_of_row},
         {"energy_max_kj", 3, "largest kinetic energy at the corners of the path", &WholePath::largest_kj},
         {"wkt", "the path as LINESTRING Z in metres", &WholePath::wkt}}};
    return table;
}

std::optional<WholePath> whole_path(std::uint64_t rock, Cover cover, const Eigen::Vector2d& origin_m,
                                    std::span<const rockfall::PathPoint> points) {
    if (points.size() < 2) {
        return std::nullopt;
    }
    WholePath path{rock, cover, largest_energy_kj(points), "LINESTRING Z ("};
    for (std::size_t i = 0; i < points.size(); ++i) {
        path.wkt += i == 0 ? "" : ",";
        append_centimetres(path.wkt, points[i].position_m.x() + origin_m.x());
        path.wkt += ' ';
        append_centimetres(path.wkt, points[i].position_m.y() + origin_m.y());
        path.wkt += ' ';
        append_centimetres(path.wkt, points[i].position_m.z());
    }
    path.wkt += ')';
    return path;
}

std::vector<TableLayout> row_layouts() {
    return {rock_table(), arrival_table(), tree_hit_table(), log_hit_table(), path_table(), wkt_table()};
}

}  // namespace coupling
