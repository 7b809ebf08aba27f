#include "coupling/run/tally_archive.hpp"

namespace coupling {
namespace {

/// Of the fine bins most are empty.
struct FilledBin {
    std::uint64_t bin;
    std::uint64_t count;
};

void write_bins(ByteWriter& out, std::span<const std::uint64_t> counts) {
    std::vector<FilledBin> filled;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) {
            filled.push_back({i, counts[i]});
        }
    }
    out.list(filled);
}

/// Into bins that are empty so far.
void read_bins(ByteReader& in, std::span<std::uint64_t> counts) {
    for (const FilledBin& filled : in.list<FilledBin>()) {
        if (filled.bin < counts.size()) {
            counts[filled.bin] = filled.count;
        }
    }
}

void write_bins(ByteWriter& out, const rockfall::BinCounts& counts) {
    std::vector<FilledBin> filled;
    for (const auto& [bin, count] : counts.filled()) {
        filled.push_back({bin, count});
    }
    out.list(filled);
}

void read_bins(ByteReader& in, rockfall::BinCounts& counts) {
    for (const FilledBin& filled : in.list<FilledBin>()) {
        if (filled.bin < counts.bins()) {
            counts.add(static_cast<std::size_t>(filled.bin), filled.count);
        }
    }
}

void write_parts(ByteWriter& out, const std::map<rockfall::RimPart, std::uint64_t>& counts) {
    std::vector<FilledBin> filled;
    for (const auto& [part, count] : counts) {
        filled.push_back({static_cast<std::uint64_t>(part), count});
    }
    out.list(filled);
}

void read_parts(ByteReader& in, std::map<rockfall::RimPart, std::uint64_t>& counts) {
    for (const FilledBin& filled : in.list<FilledBin>()) {
        counts[static_cast<rockfall::RimPart>(filled.bin)] = filled.count;
    }
}

/// The plain numbers of a run tally, in one order for writing and reading.
template <class Tally, class Visit>
void each_number(Tally& t, const Visit& visit) {
    for (auto* v : {&t.rocks,
                    &t.run_out_sum_mm,
                    &t.open_run_out_sum_mm,
                    &t.max_speed_sum_mmps,
                    &t.mean_speed_sum_mmps,
                    &t.max_energy_sum_j,
                    &t.max_height_sum_mm,
                    &t.jump_height_sum_mm,
                    &t.jumps,
                    &t.ground_impacts,
                    &t.hits,
                    &t.trees_broken,
                    &t.tree_energy_sum_j,
                    &t.log_hits,
                    &t.logs_broken,
                    &t.log_energy_sum_j,
                    &t.dissipated_sum_j,
                    &t.residual_sum_mj,
                    &t.corrected_sum_mj,
                    &t.unsolved}) {
        visit(*v);
    }
    for (auto* v :
         {&t.max_speed_mps, &t.max_energy_j, &t.max_height_m, &t.max_run_out_m, &t.max_open_run_out_m}) {
        visit(*v);
    }
}

}  // namespace

void write(ByteWriter& out, const rockfall::ArrivalTally& t) {
    out.value(t.reached);
    write_bins(out, t.energy);
    write_bins(out, t.speed);
    write_bins(out, t.height);
    write_bins(out, t.top_height);
    write_bins(out, t.above);
    for (const double v : {t.energy_max_j, t.speed_max_mps, t.height_max_m, t.top_height_max_m}) {
        out.value(v);
    }
    for (const std::uint64_t v : {t.energy_sum_j, t.speed_sum_mmps, t.height_sum_mm, t.top_height_sum_mm}) {
        out.value(v);
    }
}

void read(ByteReader& in, rockfall::ArrivalTally& t) {
    t.reached = in.value<std::uint64_t>();
    read_bins(in, t.energy);
    read_bins(in, t.speed);
    read_bins(in, t.height);
    read_bins(in, t.top_height);
    read_bins(in, t.above);
    for (double* v : {&t.energy_max_j, &t.speed_max_mps, &t.height_max_m, &t.top_height_max_m}) {
        *v = in.value<double>();
    }
    for (std::uint64_t* v : {&t.energy_sum_j, &t.speed_sum_mmps, &t.height_sum_mm, &t.top_height_sum_mm}) {
        *v = in.value<std::uint64_t>();
    }
}

void write(ByteWriter& out, const rockfall::RunTally& t) {
    each_number(t, [&](const auto& v) { out.value(v); });
    write_bins(out, t.by_reason);
    write_parts(out, t.left_over);
    write_bins(out, t.run_out);
    write_bins(out, t.open_run_out);
    write_bins(out, t.tree_hits);
    write_bins(out, t.max_speed);
    write_bins(out, t.max_energy);
    write_bins(out, t.max_height);
}

void read(ByteReader& in, rockfall::RunTally& t) {
    each_number(t, [&](auto& v) { v = in.value<std::remove_reference_t<decltype(v)>>(); });
    read_bins(in, t.by_reason);
    read_parts(in, t.left_over);
    read_bins(in, t.run_out);
    read_bins(in, t.open_run_out);
    read_bins(in, t.tree_hits);
    read_bins(in, t.max_speed);
    read_bins(in, t.max_energy);
    read_bins(in, t.max_height);
}

void write(ByteWriter& out, const rockfall::TargetTally& t) {
    for (const rockfall::ArrivalTally& arrivals : t.by_cover) {
        write(out, arrivals);
    }
    out.value(t.reached_both);
}

void read(ByteReader& in, rockfall::TargetTally& t) {
    for (rockfall::ArrivalTally& arrivals : t.by_cover) {
        read(in, arrivals);
    }
    t.reached_both = in.value<std::uint64_t>();
}

void write(ByteWriter& out, const rockfall::StratumTally& t) {
    for (const rockfall::RunOutTally& run_outs : t.run_outs) {
        out.value(run_outs.rocks);
        out.value(run_outs.stopped);
        out.value(run_outs.sum_mm);
        write_bins(out, run_outs.bins);
    }
    out.value(static_cast<std::uint64_t>(t.targets.size()));
    for (const rockfall::TargetTally& target : t.targets) {
        write(out, target);
    }
}

void read(ByteReader& in, rockfall::StratumTally& t) {
    for (rockfall::RunOutTally& run_outs : t.run_outs) {
        run_outs.rocks = in.value<std::uint64_t>();
        run_outs.stopped = in.value<std::uint64_t>();
        run_outs.sum_mm = in.value<std::uint64_t>();
        read_bins(in, run_outs.bins);
    }
    t.targets.resize(in.count_of(8));
    for (rockfall::TargetTally& target : t.targets) {
        read(in, target);
    }
}

}  // namespace coupling
