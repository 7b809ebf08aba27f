#include "coupling/assessments/nets/figures/net_paths.hpp"

#include <bit>

#include "coupling/results/disk/byte_archive.hpp"
#include "coupling/run/in_order.hpp"
#include "rockfall/one_slope.hpp"
#include "rockfall/trajectory.hpp"

namespace coupling {
namespace {

constexpr std::uint64_t magic = 0x36305054'454E4E42ULL;  // "BNNETP06", least byte first
enum class Mark : std::uint8_t { end, path };

/// Keeps what a rock does, piece by piece.
struct PathKeeper {
    std::vector<StoredPiece> pieces;

    void flew(const rockfall::Rock&, const rockfall::Flight& flight, double until_s,
              std::span<const rockfall::Stretch> stretches, double spin_radps) {
        if (!stretches.empty()) {
            pieces.push_back({stretches.back().triangle, true, false, flight.start_m, flight.velocity_mps,
                              until_s, spin_radps});
        }
    }
    void rolled(const rockfall::Rock&, const rockfall::RollingPiece& piece, std::uint32_t triangle) {
        const rockfall::StraightWay way = rockfall::StraightWay::of(piece);
        pieces.push_back({triangle, false, way.slides, way.start_m, way.end_m, way.squared_speed_start,
                          way.squared_speed_end, way.rotation_start_j, way.rotation_end_j});
    }
    void impacted(const Eigen::Vector3d&, int) {}
    void met_stem(const Eigen::Vector3d&, const rockfall::StemHit&, const rockfall::TreeImpact&, double) {}
    void met_log(const Eigen::Vector3d&, const rockfall::LogHit&, const rockfall::LogImpact&, double) {}
    void crossed_net(const Eigen::Vector3d&, const rockfall::NetCrossing&) {}
};

void write(ByteWriter& out, const Eigen::Vector3d& place) {
    for (const double v : {place.x(), place.y(), place.z()}) {
        out.value(v);
    }
}

Eigen::Vector3d read_place(ByteReader& in) {
    Eigen::Vector3d place;
    for (int axis = 0; axis < 3; ++axis) {
        place[axis] = in.value<double>();
    }
    return place;
}

void write(ByteWriter& out, const StoredPath& path) {
    out.value(Mark::path);
    out.value(path.rock);
    out.value(path.cover);
    for (const double v :
         {path.body.diameter_m, path.body.radius_m, path.body.mass_kg, path.body.inertia_kgm2}) {
        out.value(v);
    }
    out.value(static_cast<std::uint64_t>(path.pieces.size()));
    for (const StoredPiece& piece : path.pieces) {
        out.value(piece.triangle);
        const bool has_own = piece.rotation_end_j >= 0.0;
        out.value(
            static_cast<std::uint8_t>((piece.flies ? 1 : 0) + (piece.slides ? 2 : 0) + (has_own ? 4 : 0)));
        write(out, piece.start_m);
        write(out, piece.other);
        out.value(piece.first);
        out.value(piece.second);
        if (has_own) {
            out.value(piece.rotation_start_j);
            out.value(piece.rotation_end_j);
        }
    }
}

StoredPath read_path(ByteReader& in) {
    StoredPath path;
    path.rock = in.value<std::uint64_t>();
    path.cover = in.value<rockfall::Cover>();
    for (double* v :
         {&path.body.diameter_m, &path.body.radius_m, &path.body.mass_kg, &path.body.inertia_kgm2}) {
        *v = in.value<double>();
    }
    path.pieces.resize(in.count_of(69));
    for (StoredPiece& piece : path.pieces) {
        piece.triangle = in.value<std::uint32_t>();
        const auto kind = in.value<std::uint8_t>();
        piece.flies = (kind & 1U) != 0;
        piece.slides = (kind & 2U) != 0;
        piece.start_m = read_place(in);
        piece.other = read_place(in);
        piece.first = in.value<double>();
        piece.second = in.value<double>();
        if ((kind & 4U) != 0) {
            piece.rotation_start_j = in.value<double>();
            piece.rotation_end_j = in.value<double>();
        }
    }
    return path;
}

void write(ByteWriter& out, const DesignSettings& design) {
    out.value(design.rule);
    for (const double v :
         {design.percentile, design.energy_factor, design.height_factor, design.freeboard_m}) {
        out.value(v);
    }
    out.list(design.sold_heights_m);
}

DesignSettings read_design(ByteReader& in) {
    DesignSettings design;
    design.rule = in.value<DesignRule>();
    for (double* v :
         {&design.percentile, &design.energy_factor, &design.height_factor, &design.freeboard_m}) {
        *v = in.value<double>();
    }
    design.sold_heights_m = in.list<double>();
    return design;
}

void write(ByteWriter& out, const PathsHead& head) {
    out.value(magic);
    out.text(head.version);
    out.value(head.seed);
    out.value(head.strata.count);
    out.value(head.strata.seed);
    out.value(head.wanted_share);
    write(out, head.design);
    out.value(static_cast<std::uint8_t>(head.with_forest ? 1 : 0));
    out.value(static_cast<std::uint64_t>(head.inputs.size()));
    for (const InputFile& input : head.inputs) {
        out.text(input.role);
        out.text(input.name);
        out.text(input.hash);
        out.value(input.bytes);
    }
    out.value(static_cast<std::uint64_t>(head.settings.size()));
    for (const auto& [key, value] : head.settings) {
        out.text(key);
        out.text(value);
    }
    for (const std::uint64_t rocks : head.rocks) {
        out.value(rocks);
    }
}

PathsHead read_head(ByteReader& in) {
    PathsHead head;
    head.version = in.text();
    head.seed = in.value<std::uint64_t>();
    head.strata.count = in.value<std::uint32_t>();
    head.strata.seed = in.value<std::uint64_t>();
    head.wanted_share = in.value<double>();
    head.design = read_design(in);
    head.with_forest = in.value<std::uint8_t>() != 0;
    head.inputs.resize(in.count_of(32));
    for (InputFile& input : head.inputs) {
        input.role = in.text();
        input.name = in.text();
        input.hash = in.text();
        input.bytes = in.value<std::uint64_t>();
    }
    head.settings.resize(in.count_of(16));
    for (auto& [key, value] : head.settings) {
        key = in.text();
        value = in.text();
    }
    for (std::uint64_t& rocks : head.rocks) {
        rocks = in.value<std::uint64_t>();
    }
    return head;
}

}  // namespace

Ended write_net_paths(const std::filesystem::path& file, const PathsHead& head,
                      const rockfall::Assessment& assessment, int threads) {
    ByteWriter out{file};
    write(out, head);
    out.value(assessment.slope.terrain.origin_m().x());
    out.value(assessment.slope.terrain.origin_m().y());
    out.list(assessment.slope.terrain.vertices());
    out.list(assessment.slope.terrain.triangles());
    const std::vector<rockfall::Chunk> chunks =
        rockfall::plan_chunks(assessment.sources, rockfall::rocks_of_chunk(assessment.law.motion.model));
    struct Busy {
        rockfall::FallScratch scratch;
        rockfall::ChunkRows rows;
        PathKeeper keeper;
        std::vector<StoredPath> paths;
    };
    std::vector<Busy> workers(static_cast<std::size_t>(threads));
    const std::size_t fallen = in_order(
        chunks.size(), workers,
        [&](Busy& busy, std::size_t i) {
            busy.paths.clear();
            rockfall::each_start(assessment, chunks[i], busy.rows, [&](const rockfall::RockStart& start) {
                for (const rockfall::Cover cover : {rockfall::Cover::forest, rockfall::Cover::bare}) {
                    if (cover == rockfall::Cover::forest && !head.with_forest) {
                        continue;
                    }
                    rockfall::Obstacles obstacles = assessment.obstacles(cover, {});
                    obstacles.nets = nullptr;
                    const config::StreamKey key{assessment.seed, assessment.replicate, assessment.year,
                                                start.id};
                    busy.keeper.pieces.clear();
                    rockfall::fall(assessment.slope_of(start.id), obstacles, assessment.law_of(start.id), key,
                                   start, busy.scratch, busy.keeper);
                    busy.paths.push_back({start.id, cover, start.rock, busy.keeper.pieces});
                }
            });
        },
        [&](Busy& busy, std::size_t) {
            for (const StoredPath& path : busy.paths) {
                write(out, path);
            }
        });
    out.value(Mark::end);
    out.close();
    return fallen == chunks.size() ? Ended::done : Ended::interrupted;
}

namespace {

[[noreturn]] void refuse_damaged(const std::string& file) {
    config::fail(config::ExitCode::file, {file}, "stored paths that are cut off or damaged",
                 "the file as the run wrote it: run the scenario again with nets.keep_paths = yes");
}

constexpr const char* other_kind = "no stored paths of this version";

/// What stands before the paths.
struct PathsBeginning {
    PathsHead head;
    Eigen::Vector2d origin_m;
    std::vector<rockfall::Vertex> vertices;
    std::vector<rockfall::Triangle> triangles;
};

PathsBeginning read_beginning(ByteReader& in, const std::string& file) {
    if (in.value<std::uint64_t>() != magic) {
        config::fail(config::ExitCode::file, {file}, other_kind,
                     "net_paths.bin of a run with nets.keep_paths = yes");
    }
    PathsBeginning begun;
    begun.head = read_head(in);
    begun.origin_m.x() = in.value<double>();
    begun.origin_m.y() = in.value<double>();
    begun.vertices = in.list<rockfall::Vertex>();
    begun.triangles = in.list<rockfall::Triangle>();
    return begun;
}

/// Whether a message says that the file is of another kind, which is more than "damaged".
bool is_other_kind(const config::InputError& error) {
    return error.problems().front().found == other_kind;
}

/// Reads all of the file and keeps nothing: until its checksum is known, none of its numbers may be used.
void check_all(ByteReader in, const std::string& file) {
    bool whole = false;
    try {
        const std::size_t triangles = read_beginning(in, file).triangles.size();
        whole = true;
        while (in.value<Mark>() == Mark::path) {
            whole = is_whole_path(read_path(in), triangles) && whole;
        }
        in.check_end();
    } catch (const config::InputError& error) {
        if (is_other_kind(error)) {
            throw;
        }
        whole = false;
    }
    if (!whole) {
        refuse_damaged(file);
    }
}

}  // namespace

NetPathsReader::NetPathsReader(const std::filesystem::path& file) : file_{file.string()} {
    check_all(ByteReader{file}, file_);
    ByteReader in{file};
    PathsBeginning begun = read_beginning(in, file_);
    if (!begun.origin_m.allFinite() || !is_whole_terrain(begun.vertices, begun.triangles) ||
        !is_whole_design(begun.head.design) || !std::has_single_bit(begun.head.strata.count)) {
        refuse_damaged(file_);
    }
    head_ = std::move(begun.head);
    terrain_ = std::make_unique<rockfall::Terrain>(begun.origin_m, std::move(begun.vertices),
                                                   std::move(begun.triangles));
}

NetPathsReader::NetPathsReader(NetPathsReader&& other) noexcept = default;
NetPathsReader::~NetPathsReader() = default;

void NetPathsReader::each(const std::function<void(const StoredPath&)>& look) {
    ByteReader in{file_};
    read_beginning(in, file_);
    while (in.value<Mark>() == Mark::path) {
        const StoredPath path = read_path(in);
        if (!is_whole_path(path, terrain_->triangles().size())) {
            refuse_damaged(file_);  // changed since it was checked
        }
        look(path);
    }
    in.check_end();
}

}  // namespace coupling
