#include <Eigen/Geometry>
#include <cstring>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"

namespace coupling::collapse {
namespace {

/// Raw blocks behind the markup, each with its length before it, least byte first.
class RawBlocks {
public:
    template <class Value>
    std::string array(const char* type, const char* attributes, const std::vector<Value>& values) {
        const std::string offset = std::to_string(bytes_.size());
        const std::uint64_t length = values.size() * sizeof(Value);
        append(&length, sizeof length);
        append(values.data(), length);
        return config::joined("<DataArray type=\"", type, "\" ", attributes, " format=\"appended\" offset=\"",
                              offset, "\"/>\n");
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    void append(const void* from, std::size_t count) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + count);
        if (count > 0) {
            std::memcpy(bytes_.data() + at, from, count);
        }
    }
    std::string bytes_;
};

}  // namespace

void write_blocks_vtp(std::ostream& out, const CollapseResults& results, std::size_t frame) {
    std::vector<double> points;
    std::vector<std::int32_t> corners, ends, numbers, handed;
    std::vector<float> speeds, volumes;
    for (std::size_t i = 0; i < results.site.count.free; ++i) {
        const BlockPlace& place = results.record.frames[frame][i];
        const bool is_handed = results.hand_over.was_single(i, results.record.rows[frame].time_s);
        const Eigen::Quaterniond turn{
            static_cast<double>(place.attitude[0]), static_cast<double>(place.attitude[1]),
            static_cast<double>(place.attitude[2]), static_cast<double>(place.attitude[3])};
        const Eigen::Vector3d centre{static_cast<double>(place.centre_m[0]) + results.site.origin_m.x(),
                                     static_cast<double>(place.centre_m[1]) + results.site.origin_m.y(),
                                     static_cast<double>(place.centre_m[2])};
        const auto& hull = results.site.blocks[i].solid.hull;
        const auto first = static_cast<std::int32_t>(points.size() / 3);
        for (const Eigen::Vector3d& vertex : hull.vertices_m) {
            const Eigen::Vector3d at = centre + turn.normalized() * vertex;
            points.insert(points.end(), {at.x(), at.y(), at.z()});
        }
        for (const auto& face : hull.faces) {
            for (const std::uint32_t corner : face.corners) {
                corners.push_back(first + static_cast<std::int32_t>(corner));
            }
            ends.push_back(static_cast<std::int32_t>(corners.size()));
            numbers.push_back(static_cast<std::int32_t>(i));
            handed.push_back(is_handed ? 1 : 0);
            speeds.push_back(place.speed_mps);
            volumes.push_back(static_cast<float>(results.site.blocks[i].solid.volume_m3));
        }
    }
    RawBlocks blocks;
    const std::string number = blocks.array("Int32", "Name=\"block\"", numbers);
    const std::string speed = blocks.array("Float32", "Name=\"speed_mps\"", speeds);
    const std::string volume = blocks.array("Float32", "Name=\"volume_m3\"", volumes);
    const std::string single =
        results.hands_over() ? blocks.array("Int32", "Name=\"single\"", handed) : std::string{};
    const std::string places = blocks.array("Float64", "NumberOfComponents=\"3\"", points);
    const std::string connectivity = blocks.array("Int32", "Name=\"connectivity\"", corners);
    const std::string offsets = blocks.array("Int32", "Name=\"offsets\"", ends);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\""
        << points.size() / 3
        << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" << ends.size()
        << "\">\n<CellData Scalars=\"speed_mps\">\n"
        << number << speed << volume << single << "</CellData>\n<Points>\n"
        << places << "</Points>\n<Polys>\n"
        << connectivity << offsets << "</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_"
        << blocks.bytes() << "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace coupling::collapse
