#include "coupling/assessments/today/rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "config/units/angle.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/today/figures/static_layouts.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling {
namespace {

using config::j_per_kj;

/// Absolute easting, northing and height to the centimetre.
void add_place(CsvRow& row, const Eigen::Vector3d& place_m, const Eigen::Vector2d& origin_m) {
    row.number<2>(place_m.x() + origin_m.x());
    row.number<2>(place_m.y() + origin_m.y());
    row.number<2>(place_m.z());
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

void append_centimetres(std::string& text, double value_m) {
    std::array<char, 400> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value_m, std::chars_format::fixed, 2).ptr;
    text.append(digits.data(), end);
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

std::size_t columns_of(std::string_view file) {
    return layout_of(static_layouts(), file).columns.size();
}

}  // namespace

void write_rock_header(std::ostream& out) {
    write_header(out, layout_of(static_layouts(), "rocks.csv"));
}

void write_rock(std::ostream& out, const rockfall::RockRecord& record, Cover cover,
                const Eigen::Vector2d& origin_m, std::uint32_t zone, std::optional<int> end_ground) {
    static const std::size_t columns = columns_of("rocks.csv");
    CsvRow row{out, columns};
    row.whole(record.rock).text(coupling::name_of(cover)).whole(zone).whole(record.source);
    row.number<3>(static_cast<double>(record.diameter_m)).text(coupling::name_of(record.reason));
    add_place(row, record.start_m, origin_m);
    add_place(row, record.end_m, origin_m);
    row.number<2>(record.run_out_m());
    row.number<1>(azimuth_deg((record.end_m - record.start_m).head<2>()));
    end_ground ? row.whole(static_cast<unsigned>(*end_ground)) : row.empty();
    row.number<2>(record.path_m).number<2>(record.time_s);
    row.number<3>(record.max_speed_mps).number<3>(record.mean_speed_mps()).number<3>(record.min_speed_mps);
    row.number<3>(record.max_energy_j / j_per_kj);
    row.number<3>(record.max_height_m).number<3>(record.mean_jump_height_m());
    row.whole(record.jumps).number<3>(record.min_jump_length_m).number<3>(record.mean_jump_length_m());
    row.number<3>(record.max_jump_length_m).whole(record.ground_impacts);
    row.text(impacts_in_words(record.impacts_by_ground));
    row.whole(record.tree_hits).whole(record.trees_broken);
    row.number<3>(record.tree_energy_j / j_per_kj);
    row.whole(record.log_hits).whole(record.logs_broken).number<3>(record.log_energy_j / j_per_kj);
    row.end();
}

void write_arrival_header(std::ostream& out) {
    write_header(out, layout_of(static_layouts(), "arrivals.csv"));
}

void write_arrival(std::ostream& out, std::uint64_t rock, std::string_view target_id, Cover cover,
                   const Eigen::Vector2d& origin_m, const rockfall::Arrival& arrival) {
    static const std::size_t columns = columns_of("arrivals.csv");
    CsvRow row{out, columns};
    row.whole(rock).text(target_id).text(coupling::name_of(cover));
    row.number<2>(static_cast<double>(arrival.x_m) + origin_m.x());
    row.number<2>(static_cast<double>(arrival.y_m) + origin_m.y());
    row.number<3>(static_cast<double>(arrival.energy_j) / j_per_kj);
    row.number<3>(static_cast<double>(arrival.translational_j) / j_per_kj);
    row.number<3>(static_cast<double>(arrival.speed_mps));
    row.number<3>(static_cast<double>(arrival.height_m));
    row.number<3>(static_cast<double>(arrival.centre_height_m));
    row.number<3>(static_cast<double>(arrival.top_height_m));
    row.end();
}

void write_tree_hit_header(std::ostream& out) {
    write_header(out, layout_of(static_layouts(), "tree_hits.csv"));
}

void write_tree_hit(std::ostream& out, std::uint64_t rock, std::string_view tree_id,
                    const Eigen::Vector2d& origin_m, const rockfall::TreeHitRecord& hit) {
    static const std::size_t columns = columns_of("tree_hits.csv");
    CsvRow row{out, columns};
    row.whole(rock).text(tree_id);
    add_place(row, hit.position_m, origin_m);
    row.number<2>(static_cast<double>(hit.height_m));
    row.number<3>(static_cast<double>(hit.energy_j) / j_per_kj);
    row.number<3>(static_cast<double>(hit.loss_j) / j_per_kj);
    row.text(hit_type_name(hit.type)).text(hit.broken ? "yes" : "no").text(hit.stopped ? "yes" : "no");
    row.end();
}

void write_log_hit_header(std::ostream& out) {
    write_header(out, layout_of(static_layouts(), "log_hits.csv"));
}

void write_log_hit(std::ostream& out, std::uint64_t rock, std::string_view log_id,
                   const Eigen::Vector2d& origin_m, const rockfall::LogHitRecord& hit) {
    static const std::size_t columns = columns_of("log_hits.csv");
    CsvRow row{out, columns};
    row.whole(rock).text(log_id);
    add_place(row, hit.position_m, origin_m);
    row.number<3>(static_cast<double>(hit.energy_j) / j_per_kj);
    row.number<3>(static_cast<double>(hit.loss_j) / j_per_kj).text(log_outcome_name(hit.outcome));
    row.end();
}

void write_path_header(std::ostream& out) {
    write_header(out, layout_of(static_layouts(), "trajectories.csv"));
}

void write_path(std::ostream& out, std::uint64_t rock, Cover cover, const Eigen::Vector2d& origin_m,
                std::span<const rockfall::PathPoint> points) {
    static const std::size_t columns = columns_of("trajectories.csv");
    CsvRow row{out, columns};
    for (std::size_t i = 0; i < points.size(); ++i) {
        row.whole(rock).text(coupling::name_of(cover)).whole(i);
        add_place(row, points[i].position_m, origin_m);
        row.number<3>(static_cast<double>(points[i].energy_j) / j_per_kj);
        row.number<2>(static_cast<double>(points[i].height_m));
        row.end();
    }
}

void write_path_wkt_header(std::ostream& out) {
    write_header(out, layout_of(static_layouts(), "trajectories_wkt.csv"));
}

void write_path_wkt(std::ostream& out, std::uint64_t rock, Cover cover, const Eigen::Vector2d& origin_m,
                    std::span<const rockfall::PathPoint> points) {
    if (points.size() < 2) {
        return;  // one point is no line
    }
    std::string wkt = "LINESTRING Z (";
    for (std::size_t i = 0; i < points.size(); ++i) {
        wkt += i == 0 ? "" : ",";
        append_centimetres(wkt, points[i].position_m.x() + origin_m.x());
        wkt += ' ';
        append_centimetres(wkt, points[i].position_m.y() + origin_m.y());
        wkt += ' ';
        append_centimetres(wkt, points[i].position_m.z());
    }
    wkt += ')';
    static const std::size_t columns = columns_of("trajectories_wkt.csv");
    CsvRow row{out, columns};
    row.whole(rock).text(coupling::name_of(cover)).number<3>(largest_energy_kj(points)).text(wkt);
    row.end();
}

}  // namespace coupling
