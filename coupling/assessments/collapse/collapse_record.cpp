#include "coupling/assessments/collapse/collapse_record.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coupling::collapse {
namespace {

using rockfall::rock_mass::BlockStatus;
using rockfall::rock_mass::RockMass;

/// Faster blocks count as moving [choice].
constexpr double moving_mps = 0.5;

/// Of the sphere of a block's volume.
double radius_of(double volume_m3) {
    return std::cbrt(volume_m3 / (4.0 / 3.0 * std::numbers::pi));
}

/// Whether a block in two places crossed a target's lines, touches them with its side, or stands in its area.
/// Its side is that of a sphere of its volume.
bool meets_target(const rockfall::Target& target, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                  double volume_m3) {
    return rockfall::first_crossing(target, from, to).has_value() ||
           (target.is_area && rockfall::is_inside(target, to)) ||
           (target.is_hit_by_side &&
            rockfall::first_touch(target, from, to, radius_of(volume_m3)).has_value());
}

/// Reads or writes one list after the other.
template <class Visit, class Record>
void visit_record(Visit& visit, Record& r) {
    for (auto* list : {&r.cell_blocks, &r.cell_energy_j, &r.cell_speed_mps, &r.last_cell, &r.block_speed_mps,
                       &r.block_energy_j}) {
        visit.list(*list);
    }
    for (auto& floor : r.floors) {
        visit.list(floor.largest_j());
    }
    visit.number(r.largest_speed_mps);
}

struct Writer {
    std::vector<double>& out;
    void number(double value) { out.push_back(value); }
    void list(const std::vector<double>& values) {
        out.push_back(static_cast<double>(values.size()));
        out.insert(out.end(), values.begin(), values.end());
    }
};

struct Reader {
    std::span<const double> in;
    std::size_t at = 0;
    bool whole = true;
    double next() {
        if (at >= in.size()) {
            whole = false;
            return 0.0;
        }
        return in[at++];
    }
    void number(double& value) { value = next(); }
    void list(std::vector<double>& values) {
        if (next() != static_cast<double>(values.size()) || in.size() - at < values.size()) {
            whole = false;
            return;
        }
        std::copy_n(in.begin() + static_cast<std::ptrdiff_t>(at), values.size(), values.begin());
        at += values.size();
    }
};

constexpr std::size_t row_numbers = sizeof(FrameRow) / sizeof(double);
constexpr std::size_t hit_numbers = sizeof(TargetHit) / sizeof(double);
static_assert(sizeof(FrameRow) == row_numbers * sizeof(double));
constexpr std::size_t place_numbers = sizeof(BlockPlace) / sizeof(float);
static_assert(sizeof(BlockPlace) == place_numbers * sizeof(float));

template <class Plain>
void write_plain(Writer& writer, const Plain& value) {
    const auto* numbers = reinterpret_cast<const double*>(&value);
    writer.out.insert(writer.out.end(), numbers, numbers + sizeof(Plain) / sizeof(double));
}
template <class Plain>
void read_plain(Reader& reader, Plain& value) {
    auto* numbers = reinterpret_cast<double*>(&value);
    for (std::size_t k = 0; k < sizeof(Plain) / sizeof(double); ++k) {
        numbers[k] = reader.next();
    }
}

}  // namespace

CollapseRecord::CollapseRecord(const CollapseSite& site) {
    for (std::vector<double>* cells : {&cell_blocks, &cell_energy_j, &cell_speed_mps}) {
        cells->assign(site.map_frame.size(), 0.0);
    }
    for (std::vector<double>* blocks : {&block_speed_mps, &block_energy_j}) {
        blocks->assign(site.count.free, 0.0);
    }
    last_cell.assign(site.count.free, -1.0);
    for (const rockfall::Target& target : site.targets) {
        floors.emplace_back(target);
    }
    reached_.assign(site.targets.size(), std::vector<std::uint8_t>(site.count.free, 0));
    for (std::size_t i = 0; i < site.count.free; ++i) {
        start_x_m_.push_back(site.blocks[i].centre_m.x());
        start_y_m_.push_back(site.blocks[i].centre_m.y());
    }
}

void CollapseRecord::observe(const CollapseSite& site, const RockMass& mass, const HandOver& hand_over) {
    for (std::size_t i = 0; i < site.count.free; ++i) {
        const SeenBlock block = hand_over.seen(mass, i);
        if (block.status != BlockStatus::moving) {
            continue;
        }
        const double speed_mps = block.velocity_mps.norm(), energy_j = block.energy_j;
        largest_speed_mps = std::max(largest_speed_mps, speed_mps);
        block_speed_mps[i] = std::max(block_speed_mps[i], speed_mps);
        block_energy_j[i] = std::max(block_energy_j[i], energy_j);
        const Eigen::Vector2d at = block.centre_m.head<2>() + site.origin_m;
        const config::Cell cell = site.map_frame.cell_at(at.x(), at.y());
        if (site.map_frame.contains(cell)) {
            const std::size_t k = site.map_frame.index(cell);
            if (last_cell[i] != static_cast<double>(k)) {
                last_cell[i] = static_cast<double>(k);
                cell_blocks[k] += 1.0;
            }
            cell_energy_j[k] = std::max(cell_energy_j[k], energy_j);
            cell_speed_mps[k] = std::max(cell_speed_mps[k], speed_mps);
        }
        // The way since the last look, at the present speed.
        constexpr double look_s = 0.06;
        const Eigen::Vector2d to = block.centre_m.head<2>();
        const Eigen::Vector2d from = to - look_s * block.velocity_mps.head<2>();
        for (std::size_t t = 0; t < site.targets.size(); ++t) {
            const rockfall::Target& target = site.targets[t];
            floors[t].pass(from, to, radius_of(mass.blocks()[i].volume_m3), energy_j);
            if (reached_[t][i] == 0 && meets_target(target, from, to, mass.blocks()[i].volume_m3)) {
                reached_[t][i] = 1;
                hits.push_back({static_cast<double>(t), static_cast<double>(i), mass.time_s(), at.x(), at.y(),
                                speed_mps, energy_j, block.translation_j, mass.blocks()[i].volume_m3,
                                target.is_area ? static_cast<double>(wall_met(target, from, to)) : -1.0});
            }
        }
    }
}

void CollapseRecord::add_frame(const CollapseSite& site, const RockMass& mass, const HandOver& hand_over) {
    FrameRow row;
    row.time_s = mass.time_s();
    row.ledger = mass.ledger();
    const double turnover_j = row.ledger.turnover_j(mass.motion_at_start_j());
    row.residual_share = turnover_j > 0.0 ? row.ledger.residual_j() / turnover_j : 0.0;
    double mass_kg = 0.0, momentum = 0.0, displacement_kgm = 0.0, change = 0.0;
    const double since_s = rows.empty() ? 0.0 : row.time_s - rows.back().time_s;
    std::vector<BlockPlace> places;
    for (std::size_t i = 0; i < site.count.free; ++i) {
        const SeenBlock block = hand_over.seen(mass, i);
        const double speed_mps = block.velocity_mps.norm();
        mass_kg += mass.blocks()[i].mass_kg;
        momentum += mass.blocks()[i].mass_kg * speed_mps;
        displacement_kgm += mass.blocks()[i].mass_kg * (block.centre_m - site.blocks[i].centre_m).norm();
        if (since_s > 0.0 && block.status != BlockStatus::left) {
            const double change_mps = (block.velocity_mps - frames.back()[i].velocity()).norm();
            change += mass.blocks()[i].mass_kg * change_mps;
            row.largest_acceleration_mps2 = std::max(row.largest_acceleration_mps2, change_mps / since_s);
        }
        largest_speed_mps = std::max(largest_speed_mps, speed_mps);
        row.front_m = std::max(
            row.front_m, std::hypot(block.centre_m.x() - start_x_m_[i], block.centre_m.y() - start_y_m_[i]));
        if (block.status == BlockStatus::moving && speed_mps > moving_mps) {
            row.moving_share += 1.0;
            row.moving_m3 += mass.blocks()[i].volume_m3;
        }
        const Eigen::Quaterniond& q = block.attitude;
        places.push_back(
            {{static_cast<float>(block.centre_m.x()), static_cast<float>(block.centre_m.y()),
              static_cast<float>(block.centre_m.z())},
             {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
              static_cast<float>(q.z())},
             static_cast<float>(speed_mps),
             {static_cast<float>(block.velocity_mps.x()), static_cast<float>(block.velocity_mps.y()),
              static_cast<float>(block.velocity_mps.z())},
             static_cast<float>(block.energy_j)});
    }
    row.mean_acceleration_mps2 = since_s > 0.0 ? change / mass_kg / since_s : 0.0;
    row.mean_speed_mps = momentum / mass_kg;
    row.mean_displacement_m = displacement_kgm / mass_kg;
    row.moving_share /= static_cast<double>(site.count.free);
    row.largest_speed_mps = largest_speed_mps;
    row.bonds_intact = static_cast<double>(mass.bonds_intact());
    row.broken_by_tension = static_cast<double>(mass.broken_by_tension());
    row.broken_by_shear = static_cast<double>(mass.broken_by_shear());
    largest_speed_mps = 0.0;
    rows.push_back(row);
    frames.push_back(std::move(places));
}

std::vector<double> CollapseRecord::packed() const {
    std::vector<double> numbers;
    Writer writer{numbers};
    visit_record(writer, *this);
    writer.number(static_cast<double>(rows.size()));
    for (std::size_t f = 0; f < rows.size(); ++f) {
        write_plain(writer, rows[f]);
        for (const BlockPlace& place : frames[f]) {
            const auto* values = reinterpret_cast<const float*>(&place);
            for (std::size_t k = 0; k < place_numbers; ++k) {
                writer.number(static_cast<double>(values[k]));
            }
        }
    }
    writer.number(static_cast<double>(hits.size()));
    for (const TargetHit& hit : hits) {
        write_plain(writer, hit);
    }
    return numbers;
}

bool CollapseRecord::unpack(std::span<const double> numbers) {
    Reader reader{numbers};
    visit_record(reader, *this);
    const std::size_t blocks = last_cell.size();
    const double row_count = reader.next();
    if (!reader.whole || row_count * static_cast<double>(row_numbers + place_numbers * blocks) >
                             static_cast<double>(numbers.size())) {
        return false;
    }
    rows.resize(static_cast<std::size_t>(row_count));
    frames.resize(rows.size());
    for (std::size_t f = 0; f < rows.size(); ++f) {
        read_plain(reader, rows[f]);
        frames[f].resize(blocks);
        for (BlockPlace& place : frames[f]) {
            auto* values = reinterpret_cast<float*>(&place);
            for (std::size_t k = 0; k < place_numbers; ++k) {
                values[k] = static_cast<float>(reader.next());
            }
        }
    }
    const double hit_count = reader.next();
    if (!reader.whole || hit_count * static_cast<double>(hit_numbers) > static_cast<double>(numbers.size())) {
        return false;
    }
    hits.resize(static_cast<std::size_t>(hit_count));
    for (TargetHit& hit : hits) {
        read_plain(reader, hit);
        const auto t = static_cast<std::size_t>(hit.target), b = static_cast<std::size_t>(hit.block);
        if (t >= reached_.size() || b >= blocks) {
            return false;
        }
        reached_[t][b] = 1;
    }
    return reader.whole && reader.at == numbers.size();
}

}  // namespace coupling::collapse
