#include "coupling/results/maps/vtp.hpp"

#include <bit>
#include <cstdint>
#include <string>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::joined;

/// The raw blocks behind the markup, each with its length before it, least byte first.
class Blocks {
public:
    /// The element that describes the next block; `fill` adds its values.
    template <class Fill>
    std::string array(std::string_view type, std::string_view attributes, const Fill& fill) {
        const std::string offset = std::to_string(bytes_.size());
        const std::size_t length_at = bytes_.size();
        bytes_.append(8, '\0');
        fill();
        const std::uint64_t length = bytes_.size() - length_at - 8;
        for (std::size_t i = 0; i < 8; ++i) {
            bytes_[length_at + i] = static_cast<char>((length >> (8 * i)) & 0xFFU);
        }
        return joined("<DataArray type=\"", type, "\" ", attributes, " format=\"appended\" offset=\"", offset,
                      "\"/>\n");
    }
    void add(std::uint64_t value) {
        for (std::size_t i = 0; i < 8; ++i) {
            bytes_ += static_cast<char>((value >> (8 * i)) & 0xFFU);
        }
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

}  // namespace

void write_vtp(std::ostream& out, std::span<const rockfall::PathRecord> paths,
               const Eigen::Vector2d& origin_m) {
    Blocks blocks;
    std::size_t points = 0;
    const auto each_point = [&](const auto& visit) {
        for (const rockfall::PathRecord& path : paths) {
            for (const rockfall::PathPoint& point : path.points) {
                visit(point);
            }
        }
    };
    each_point([&](const rockfall::PathPoint&) { ++points; });
    const std::string energy = blocks.array("Float64", "Name=\"energy_kj\"", [&] {
        each_point([&](const auto& p) { blocks.add(static_cast<double>(p.energy_j) / j_per_kj); });
    });
    const std::string height = blocks.array("Float64", "Name=\"height_m\"", [&] {
        each_point([&](const auto& p) { blocks.add(static_cast<double>(p.height_m)); });
    });
    const std::string rock = blocks.array("UInt64", "Name=\"rock\"", [&] {
        for (const rockfall::PathRecord& path : paths) {
            blocks.add(path.rock);
        }
    });
    const std::string cover = blocks.array("UInt64", "Name=\"cover\"", [&] {
        for (const rockfall::PathRecord& path : paths) {
            blocks.add(std::uint64_t{path.cover == rockfall::Cover::bare ? 1U : 0U});
        }
    });
    const std::string places = blocks.array("Float64", "NumberOfComponents=\"3\"", [&] {
        each_point([&](const auto& p) {
            blocks.add(p.position_m.x() + origin_m.x());
            blocks.add(p.position_m.y() + origin_m.y());
            blocks.add(p.position_m.z());
        });
    });
    const std::string corners = blocks.array("UInt64", "Name=\"connectivity\"", [&] {
        for (std::uint64_t i = 0; i < points; ++i) {
            blocks.add(i);
        }
    });
    const std::string ends = blocks.array("UInt64", "Name=\"offsets\"", [&] {
        std::uint64_t end = 0;
        for (const rockfall::PathRecord& path : paths) {
            blocks.add(end += path.points.size());
        }
    });
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\""
        << points << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << paths.size()
        << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData Scalars=\"energy_kj\">\n"
        << energy << height << "</PointData>\n<CellData>\n"
        << rock << cover << "</CellData>\n<Points>\n"
        << places << "</Points>\n<Lines>\n"
        << corners << ends << "</Lines>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_"
        << blocks.bytes() << "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace coupling
