#include <algorithm>
#include <map>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"

namespace coupling::meshes {

namespace {

using config::ExitCode;
using config::fail;

/// A group of a DXF file: a line with its code and a line with its value.
struct Group {
    int code = 0;
    std::string_view value;
    std::size_t line = 0;  ///< of the value
};

/// The groups of a file, one after the other.
class Groups {
public:
    Groups(std::string_view text, const std::string& file) : text_{text}, file_{file} {}

    Group next() {
        Group group;
        const std::string_view code = next_line();
        const auto number = config::parse_whole(code);
        constexpr long long most = 9999;  // codes go up to 1071
        if (!number || *number < -most || *number > most) {
            fail(ExitCode::data, place(), config::in_quotes(code), "the code of a group, a whole number");
        }
        group.code = static_cast<int>(*number);
        group.value = next_line();
        group.line = line_;
        return group;
    }
    [[nodiscard]] double number_of(const Group& group) const {
        const auto value = config::parse_number(group.value);
        if (!value) {
            fail(ExitCode::data, {file_, group.line, 1}, config::in_quotes(group.value), "a finite number");
        }
        return *value;
    }
    [[nodiscard]] config::Place place() const { return {file_, line_, 1}; }

private:
    std::string_view next_line() {
        if (text_.empty()) {
            fail(ExitCode::data, {file_, line_ + 1, 1}, "the end of the file", "groups up to 0 EOF");
        }
        ++line_;
        const std::size_t end = std::min(text_.find('\n'), text_.size());
        const std::string_view line = config::trimmed(text_.substr(0, end));
        text_.remove_prefix(std::min(end + 1, text_.size()));
        return line;
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t line_ = 0;
};

/// What an entity says of places: coordinates 1k, 2k and 3k of its k-th one.
struct Entity {
    std::string type;
    std::size_t line = 0;
    std::array<Eigen::Vector3d, 4> corners{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                           Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    std::array<bool, 4> has{};
    std::vector<Eigen::Vector2d> plan_m;  ///< vertices of an LWPOLYLINE
    double elevation_m = 0.0;             ///< of an LWPOLYLINE (38)
    long long flags = 0;                  ///< 70
};

/// Reads the entities of the section ENTITIES.
class DxfReader {
public:
    DxfReader(std::string_view bytes, const std::string& file) : groups_{bytes, file}, file_{file} {}

    MeshFile read() {
        mesh_.format = "DXF";
        bool in_entities = false;
        Group group = groups_.next();
        while (!(group.code == 0 && group.value == "EOF")) {
            if (group.code == 0 && group.value == "SECTION") {
                group = groups_.next();
                in_entities = group.code == 2 && group.value == "ENTITIES";
                group = groups_.next();
            } else if (group.code == 0 && group.value == "ENDSEC") {
                in_entities = false;
                group = groups_.next();
            } else if (group.code == 0 && in_entities) {
                group = read_entity(group);
            } else {
                group = groups_.next();
            }
        }
        for (const auto& [type, count] : other_) {
            mesh_.passed_over.push_back(type + " (" + std::to_string(count) + ")");
        }
        if (!mesh_.faces.empty() && !mesh_.lines.empty()) {
            fail(ExitCode::data, {file_}, "3DFACE beside lines",
                 "faces as they are, or lines to triangulate");
        }
        return std::move(mesh_);
    }

private:
    /// Reads to the group that begins the next entity and returns it.
    Group read_entity(const Group& first) {
        Entity entity;
        entity.type = std::string{first.value};
        entity.line = first.line;
        Group group = groups_.next();
        for (; group.code != 0; group = groups_.next()) {
            take(entity, group);
        }
        put(entity);
        return group;
    }

    void take(Entity& entity, const Group& group) {
        const int axis = group.code / 10 - 1;
        const int corner = group.code % 10;
        if (entity.type == "LWPOLYLINE" && group.code == 10) {
            entity.plan_m.emplace_back(groups_.number_of(group), 0.0);
        } else if (entity.type == "LWPOLYLINE" && group.code == 20 && !entity.plan_m.empty()) {
            entity.plan_m.back().y() = groups_.number_of(group);
        } else if (group.code == 38) {
            entity.elevation_m = groups_.number_of(group);
        } else if (group.code == 70) {
            entity.flags = config::parse_whole(group.value).value_or(0);
        } else if (group.code >= 10 && group.code < 40 && corner < 4) {
            const auto k = static_cast<std::size_t>(corner);
            entity.corners[k][axis] = groups_.number_of(group);
            entity.has[k] = true;
        }
    }

    std::uint32_t add_point(const Eigen::Vector3d& point) {
        mesh_.points_m.push_back(point);
        return static_cast<std::uint32_t>(mesh_.points_m.size() - 1);
    }

    void require(const Entity& entity, std::size_t corners) const {
        for (std::size_t k = 0; k < corners; ++k) {
            if (!entity.has[k]) {
                fail(ExitCode::data, {file_, entity.line, 1}, entity.type + " without all its places",
                     std::to_string(corners) + " of them");
            }
        }
    }

    void put(const Entity& entity) {
        if (entity.type == "POINT") {
            require(entity, 1);
            add_point(entity.corners[0]);
        } else if (entity.type == "LINE") {
            require(entity, 2);
            const std::uint32_t from = add_point(entity.corners[0]);
            mesh_.lines.push_back({from, add_point(entity.corners[1])});
        } else if (entity.type == "3DFACE") {
            put_face(entity);
        } else if (entity.type == "LWPOLYLINE") {
            begin_line(entity.flags);
            for (const Eigen::Vector2d& place : entity.plan_m) {
                go_on({place.x(), place.y(), entity.elevation_m});
            }
            end_line();
        } else if (entity.type == "POLYLINE") {
            constexpr long long mesh_flags = 16 + 64;  // polygon mesh, polyface mesh
            in_polyline_ = (entity.flags & mesh_flags) == 0;
            // Some programs write lines in space without their flag and without a height of their own: 0.
            constexpr long long three_dimensional = 8;
            const double own_height_m = entity.corners[0].z();
            height_m_ = (entity.flags & three_dimensional) != 0 || own_height_m == 0.0
                            ? std::nullopt
                            : std::optional{own_height_m};
            begin_line(entity.flags);
            if (!in_polyline_) {
                ++other_["POLYLINE as a mesh"];
            }
        } else if (entity.type == "VERTEX" && in_polyline_) {
            require(entity, 1);
            const Eigen::Vector3d& place = entity.corners[0];
            go_on({place.x(), place.y(), height_m_.value_or(place.z())});
        } else if (entity.type == "SEQEND") {
            end_line();
            in_polyline_ = false;
        } else if (entity.type != "VERTEX") {
            ++other_[entity.type];
        }
    }

    void put_face(const Entity& entity) {
        require(entity, 3);
        std::array<std::uint32_t, 3> face{};
        for (std::size_t k = 0; k < 3; ++k) {
            face[k] = add_point(entity.corners[k]);
        }
        mesh_.faces.push_back(face);
        if (entity.has[3] && entity.corners[3] != entity.corners[2]) {
            mesh_.faces.push_back({face[0], face[2], add_point(entity.corners[3])});
        }
    }

    void begin_line(long long flags) {
        line_.clear();
        closed_ = (flags & 1) != 0;
    }
    void go_on(const Eigen::Vector3d& place) { line_.push_back(add_point(place)); }
    void end_line() {
        for (std::size_t i = 1; i < line_.size(); ++i) {
            mesh_.lines.push_back({line_[i - 1], line_[i]});
        }
        if (closed_ && line_.size() > 2) {
            mesh_.lines.push_back({line_.back(), line_.front()});
        }
        line_.clear();
    }

    Groups groups_;
    const std::string& file_;
    MeshFile mesh_;
    std::map<std::string, std::size_t> other_;
    std::vector<std::uint32_t> line_;
    bool closed_ = false;
    bool in_polyline_ = false;
    std::optional<double> height_m_;  ///< of a polyline in plan
};

}  // namespace

MeshFile read_dxf(std::string_view bytes, const std::string& file) {
    if (bytes.starts_with("AutoCAD Binary DXF")) {
        fail(ExitCode::data, {file}, "a binary DXF", "DXF as text");
    }
    return DxfReader{bytes, file}.read();
}

}  // namespace coupling::meshes
