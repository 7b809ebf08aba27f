#include "coupling/run/checkpoint.hpp"

#include "coupling/results/disk/disk.hpp"
#include "coupling/run/tally_archive.hpp"

namespace coupling {
namespace {

constexpr std::uint64_t checkpoint_magic = 0x33315452'41504E42ULL;  // "BNPART13", least byte first

void write(ByteWriter& out, const rockfall::CellHistograms* histograms) {
    out.value(static_cast<std::uint8_t>(histograms != nullptr));
    if (histograms == nullptr) {
        return;
    }
    for (std::size_t i = 0; i < histograms->tiles(); ++i) {
        if (!histograms->tile(i).empty()) {
            out.value(static_cast<std::uint64_t>(i));
            out.list(histograms->tile(i));
        }
    }
    out.value(static_cast<std::uint64_t>(histograms->tiles()));  // one past the last tile: the end
}

void read(ByteReader& in, rockfall::CellHistograms* histograms) {
    if (in.value<std::uint8_t>() == 0) {
        return;
    }
    while (true) {
        const auto tile = in.value<std::uint64_t>();
        if (histograms == nullptr || tile >= histograms->tiles()) {
            return;
        }
        histograms->add_tile(tile, in.list<std::uint32_t>());
    }
}

/// Field by field: what lies between fields differs from run to run.
void write(ByteWriter& out, const std::vector<NetRow>& rows) {
    out.value(static_cast<std::uint64_t>(rows.size()));
    for (const NetRow& row : rows) {
        const rockfall::NetCrossingRecord& c = row.crossing;
        out.value(row.rock);
        out.value(row.cover);
        out.value(c.net);
        for (const float v :
             {c.x_m, c.y_m, c.along_m, c.height_m, c.radius_m, c.energy_j, c.translational_j, c.speed_mps}) {
            out.value(v);
        }
        out.value(c.outcome);
        out.value(static_cast<std::uint8_t>(c.first ? 1 : 0));
    }
}

void write(ByteWriter& out, const Checkpoint& checkpoint) {
    out.value(checkpoint.chunks_done);
    out.value(checkpoint.begun.source);
    out.list(checkpoint.begun.marks);
    out.value(checkpoint.not_started);
    out.list(checkpoint.tables);
    out.list(checkpoint.gone);
    out.value(static_cast<std::uint64_t>(checkpoint.paths.size()));
    for (const rockfall::PathRecord& path : checkpoint.paths) {
        out.value(path.rock);
        out.value(path.cover);
        out.value(static_cast<std::uint64_t>(path.points.size()));
        for (const rockfall::PathPoint& point : path.points) {
            for (const double v : {point.position_m.x(), point.position_m.y(), point.position_m.z()}) {
                out.value(v);
            }
            out.value(point.energy_j);
            out.value(point.height_m);
            out.value(point.time_s);
            out.value(point.speed_mps);
            for (const float v : point.attitude) {
                out.value(v);
            }
        }
        out.value(static_cast<std::uint64_t>(path.shape_m.size()));
        for (const Eigen::Vector3f& vertex_m : path.shape_m) {
            for (const float v : vertex_m) {
                out.value(v);
            }
        }
        out.value(path.diameter_m);
    }
    write(out, checkpoint.net_rows);
}

std::vector<NetRow> read_net_rows(ByteReader& in) {
    std::vector<NetRow> rows(in.count_of(47));
    for (NetRow& row : rows) {
        rockfall::NetCrossingRecord& c = row.crossing;
        row.rock = in.value<std::uint64_t>();
        row.cover = in.value<rockfall::Cover>();
        c.net = in.value<std::uint32_t>();
        for (float* v : {&c.x_m, &c.y_m, &c.along_m, &c.height_m, &c.radius_m, &c.energy_j,
                         &c.translational_j, &c.speed_mps}) {
            *v = in.value<float>();
        }
        c.outcome = in.value<rockfall::NetOutcome>();
        c.first = in.value<std::uint8_t>() != 0;
    }
    return rows;
}

std::vector<rockfall::PathRecord> read_paths(ByteReader& in) {
    std::vector<rockfall::PathRecord> paths(in.count_of(29));
    for (rockfall::PathRecord& path : paths) {
        path.rock = in.value<std::uint64_t>();
        path.cover = in.value<rockfall::Cover>();
        path.points.resize(in.count_of(56));
        for (rockfall::PathPoint& point : path.points) {
            for (int axis = 0; axis < 3; ++axis) {
                point.position_m[axis] = in.value<double>();
            }
            point.energy_j = in.value<float>();
            point.height_m = in.value<float>();
            point.time_s = in.value<float>();
            point.speed_mps = in.value<float>();
            for (float& v : point.attitude) {
                v = in.value<float>();
            }
        }
        path.shape_m.resize(in.count_of(12));
        for (Eigen::Vector3f& vertex_m : path.shape_m) {
            for (float& v : vertex_m) {
                v = in.value<float>();
            }
        }
        path.diameter_m = in.value<float>();
    }
    return paths;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint,
                      const rockfall::EnsembleTally& tally,
                      const std::array<rockfall::CellHistograms*, rockfall::covers>& histograms) {
    const std::filesystem::path temporary = temporary_beside(file);
    ByteWriter out{temporary};
    out.value(checkpoint_magic);
    out.text(checkpoint.settings_hash);
    write(out, checkpoint);
    for (std::size_t c = 0; c < rockfall::covers; ++c) {
        write(out, tally.cells[c].cells);
        write(out, tally.cells[c].repeats);
        write(out, tally.cells[c].spread);
        write(out, tally.cells[c].releases);
        write(out, tally.runs[c]);
        write(out, histograms[c]);
    }
    out.value(static_cast<std::uint64_t>(tally.targets.size()));
    for (const rockfall::TargetTally& target : tally.targets) {
        write(out, target);
    }
    out.list(tally.stems);
    out.list(tally.logs);
    out.value(static_cast<std::uint64_t>(tally.strata.size()));
    for (const rockfall::StratumTally& stratum : tally.strata) {
        write(out, stratum);
    }
    close_and_rename(out, temporary, file);
}

void write_marker(const std::filesystem::path& file, const std::string& settings_hash) {
    const std::filesystem::path temporary = temporary_beside(file);
    ByteWriter out{temporary};
    out.value(checkpoint_magic);
    out.text(settings_hash);
    close_and_rename(out, temporary, file);
}

std::optional<std::string> checkpoint_hash(const std::filesystem::path& file) {
    if (!is_there(file)) {
        return std::nullopt;
    }
    ByteReader in{file};
    if (in.value<std::uint64_t>() != checkpoint_magic) {
        config::fail(config::ExitCode::file, {file.string()}, "not a part file of this version",
                     "run with --overwrite to start from the beginning");
    }
    in.check_whole();
    return in.text();
}

Checkpoint read_checkpoint(const std::filesystem::path& file, rockfall::EnsembleTally& tally,
                           const std::array<rockfall::CellHistograms*, rockfall::covers>& histograms) {
    ByteReader in{file};
    in.check_whole();
    Checkpoint checkpoint;
    in.value<std::uint64_t>();
    checkpoint.settings_hash = in.text();
    checkpoint.chunks_done = in.value<std::uint64_t>();
    checkpoint.begun.source = in.value<std::uint32_t>();
    checkpoint.begun.marks = in.list<std::uint8_t>();
    checkpoint.not_started = in.value<std::uint64_t>();
    checkpoint.tables = in.list<KeptTable>();
    checkpoint.gone = in.list<std::uint8_t>();
    checkpoint.paths = read_paths(in);
    checkpoint.net_rows = read_net_rows(in);
    for (std::size_t c = 0; c < rockfall::covers; ++c) {
        read(in, tally.cells[c].cells);
        read(in, tally.cells[c].repeats);
        read(in, tally.cells[c].spread);
        read(in, tally.cells[c].releases);
        read(in, tally.runs[c]);
        read(in, histograms[c]);
    }
    tally.targets.resize(in.count_of(8));
    for (rockfall::TargetTally& target : tally.targets) {
        read(in, target);
    }
    tally.stems = in.list<rockfall::StemTally>();
    tally.logs = in.list<rockfall::LogTally>();
    tally.strata.resize(in.count_of(8), rockfall::StratumTally{0});
    for (rockfall::StratumTally& stratum : tally.strata) {
        read(in, stratum);
    }
    in.check_end();
    return checkpoint;
}

}  // namespace coupling
