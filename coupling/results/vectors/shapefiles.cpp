#include "coupling/results/vectors/shapefiles.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <map>

#include "config/text/joined.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/geopackage/stored_rows.hpp"
#include "coupling/results/vectors/dbf_fields.hpp"
#include "coupling/results/vectors/layer_columns.hpp"

namespace coupling::vectors {
namespace {

using config::joined;
using geopackage::Dimensions;
using geopackage::StoredGeometry;
using geopackage::StoredRows;
using geopackage::Vertex;
using geopackage::Written;
using Kind = StoredGeometry::Kind;

namespace fs = std::filesystem;

constexpr std::size_t head_bytes = 100;
constexpr std::uint64_t most_bytes = std::numeric_limits<std::int32_t>::max();
constexpr double no_measure = -1e39;  // less than -1e38, as the format wants it

/// Bytes in the two orders that the format mixes.
class MixedBytes {
public:
    void big(std::uint64_t value) {
        for (int i = 3; i >= 0; --i) {
            bytes_ += static_cast<char>(value >> (8 * i) & 0xFFU);
        }
    }
    void little(std::uint64_t value, int size = 4) {
        for (int i = 0; i < size; ++i) {
            bytes_ += static_cast<char>(value >> (8 * i) & 0xFFU);
        }
    }
    void number(double value) { little(std::bit_cast<std::uint64_t>(value), 8); }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Smallest and largest value; 0 to 0 where there is none.
struct Limits {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void write(MixedBytes& bytes) const {
        bytes.number(low > high ? 0.0 : low);
        bytes.number(low > high ? 0.0 : high);
    }
};

struct Box {
    Limits x, y, z, m;

    void add(const Vertex& corner) {
        x.add(corner.x_m);
        y.add(corner.y_m);
        z.add(corner.z_m);
        m.add(corner.measure);
    }
    void write_plan(MixedBytes& bytes) const {
        bytes.number(x.low > x.high ? 0.0 : x.low);
        bytes.number(y.low > y.high ? 0.0 : y.low);
        bytes.number(x.low > x.high ? 0.0 : x.high);
        bytes.number(y.low > y.high ? 0.0 : y.high);
    }
};

/// 1, 3, 5: points, lines, areas; 10 more with heights, 20 more with measures alone.
std::uint32_t type_of(Kind kind, Dimensions dimensions) {
    const std::uint32_t plain = kind == Kind::point ? 1 : kind == Kind::line ? 3 : 5;
    return plain + (dimensions.z ? 10U : dimensions.m ? 20U : 0U);
}

/// Twice the area of a ring, positive where it goes round against the clock.
double turning(const std::vector<Vertex>& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        sum += (ring[i].x_m - ring.front().x_m) * (ring[i + 1].y_m - ring.front().y_m) -
               (ring[i + 1].x_m - ring.front().x_m) * (ring[i].y_m - ring.front().y_m);
    }
    return sum;
}

/// The corners of all parts in the order of the format.
std::vector<std::vector<Vertex>> parts_of(const StoredGeometry& geometry) {
    std::vector<std::vector<Vertex>> parts;
    for (const StoredGeometry::Part& part : geometry.parts) {
        parts.push_back(part.corners);
        if (geometry.kind == Kind::area && (turning(part.corners) > 0.0) != part.is_hole) {
            std::reverse(parts.back().begin(), parts.back().end());
        }
    }
    return parts;
}

/// The content of a record.
std::string record_of(const StoredGeometry& geometry) {
    const Dimensions dimensions = geometry.dimensions;
    MixedBytes bytes;
    bytes.little(type_of(geometry.kind, dimensions));
    if (geometry.kind == Kind::point) {
        const Vertex& corner = geometry.parts.front().corners.front();
        bytes.number(corner.x_m);
        bytes.number(corner.y_m);
        if (dimensions.z) {
            bytes.number(corner.z_m);
        }
        if (dimensions.z || dimensions.m) {
            bytes.number(dimensions.m ? corner.measure : no_measure);
        }
        return bytes.bytes();
    }
    const std::vector<std::vector<Vertex>> parts = parts_of(geometry);
    Box box;
    std::size_t corners = 0;
    for (const std::vector<Vertex>& part : parts) {
        corners += part.size();
        std::for_each(part.begin(), part.end(), [&](const Vertex& corner) { box.add(corner); });
    }
    box.write_plan(bytes);
    bytes.little(parts.size());
    bytes.little(corners);
    std::size_t begin = 0;
    for (const std::vector<Vertex>& part : parts) {
        bytes.little(begin);
        begin += part.size();
    }
    const auto each_corner = [&](const auto& write) {
        for (const std::vector<Vertex>& part : parts) {
            std::for_each(part.begin(), part.end(), write);
        }
    };
    each_corner([&](const Vertex& corner) {
        bytes.number(corner.x_m);
        bytes.number(corner.y_m);
    });
    if (dimensions.z) {
        box.z.write(bytes);
        each_corner([&](const Vertex& corner) { bytes.number(corner.z_m); });
    }
    if (dimensions.m) {
        box.m.write(bytes);
        each_corner([&](const Vertex& corner) { bytes.number(corner.measure); });
    }
    return bytes.bytes();
}

/// What a first pass through a layer finds of its features of one kind.
struct Measured {
    explicit Measured(const Written& layer) : fields{layer.plan.columns, layer.decimals} {}
    DbfFields fields;
    Dimensions dimensions;
    std::uint64_t rows = 0;
    std::uint64_t shape_bytes = head_bytes;
    Box box;
};

std::map<Kind, Measured> measured(geopackage::Database& database, const Written& layer) {
    std::map<Kind, Measured> kinds;
    for (StoredRows rows{database, layer.plan}; rows.next();) {
        const StoredGeometry& geometry = rows.geometry();
        Measured& of_kind = kinds.try_emplace(geometry.kind, layer).first->second;
        of_kind.fields.add_row(rows.fields());
        of_kind.dimensions = geometry.dimensions;
        of_kind.shape_bytes += 8 + record_of(geometry).size();
        ++of_kind.rows;
        for (const StoredGeometry::Part& part : geometry.parts) {
            for (const Vertex& corner : part.corners) {
                of_kind.box.add(corner);
            }
        }
    }
    return kinds;
}

/// The head of .shp and .shx, of so many bytes.
std::string head_of(std::uint64_t bytes_of_file, Kind kind, const Measured& found) {
    constexpr std::uint64_t file_code = 9994;
    MixedBytes bytes;
    bytes.big(file_code);
    for (int i = 0; i < 5; ++i) {
        bytes.big(0);
    }
    bytes.big(bytes_of_file / 2);
    bytes.little(1000);  // version
    bytes.little(type_of(kind, found.dimensions));
    found.box.write_plan(bytes);
    (found.dimensions.z ? found.box.z : Limits{}).write(bytes);
    (found.dimensions.m ? found.box.m : Limits{}).write(bytes);
    return bytes.bytes();
}

/// The three files of one kind of features.
class ShapefileWriter {
public:
    ShapefileWriter(const fs::path& place, Kind kind, const Measured& found)
        : found_{found},
          shapes_{file(place, ".shp")},
          index_{file(place, ".shx")},
          rows_{file(place, ".dbf")} {
        shapes_.stream() << head_of(found.shape_bytes, kind, found);
        index_.stream() << head_of(head_bytes + 8 * found.rows, kind, found);
        rows_.stream() << found.fields.head(found.rows);
    }
    void add(const StoredRows& row) {
        const std::string record = record_of(row.geometry());
        MixedBytes entry;
        entry.big(at_ / 2);
        entry.big(record.size() / 2);
        index_.stream() << entry.bytes();
        MixedBytes head;
        head.big(++number_);
        head.big(record.size() / 2);
        shapes_.stream() << head.bytes() << record;
        rows_.stream() << found_.fields.row(row.fields());
        at_ += 8 + record.size();
    }
    void close() {
        rows_.stream() << '\x1a';
        shapes_.close();
        index_.close();
        rows_.close();
    }

private:
    static fs::path file(const fs::path& place, const char* ending) { return place.string() + ending; }

    const Measured& found_;
    OutFile shapes_;
    OutFile index_;
    OutFile rows_;
    std::uint64_t number_ = 0;
    std::uint64_t at_ = head_bytes;
};

void write_text(const fs::path& file, const std::string& text) {
    OutFile out{file};
    out.stream() << text;
    out.close();
}

bool is_too_large(const Measured& found) {
    return found.shape_bytes > most_bytes || found.rows * found.fields.row_bytes() > most_bytes;
}

/// What a layer's features of a kind are called, where it has features of several.
std::string file_name(const Written& layer, Kind kind, bool one_kind) {
    constexpr std::array endings{"_points", "_lines", "_areas"};
    return joined(layer.plan.name, one_kind ? "" : endings[static_cast<std::size_t>(kind)]);
}

/// The table of fields, row by row.
class FieldTable {
public:
    explicit FieldTable(std::ostream& out) : row_{out, 6} {
        for (const char* name : {"file", "field", "column", "unit", "meaning", "cut"}) {
            row_.text(name);
        }
        row_.end();
    }
    void add(const std::string& file, const geopackage::Plan& plan, const Measured& found) {
        for (std::size_t i = 0; i < plan.columns.size(); ++i) {
            const geopackage::Column& column = plan.columns[i];
            const DbfField& field = found.fields.fields()[i];
            row_.text(file).text(field.name).text(column.name).text(unit_of(column)).text(column.meaning);
            row_.text(field.is_cut ? "words longer than 254 bytes" : "no").end();
        }
    }
    void add_left_out(const std::string& file) {
        row_.text(file)
            .empty()
            .empty()
            .empty()
            .text("left out: 2 GB or more; it is in results.gpkg")
            .empty()
            .end();
    }

private:
    CsvRow row_;
};

}  // namespace

WrittenFile write_shapefiles(const fs::path& folder, geopackage::Database& database,
                             std::span<const Written> layers, const std::string& projection,
                             const WriteWatch& watch) {
    const fs::path place = folder / "shapefiles";
    make_folder(place);
    OutFile table{place / "fields.csv"};
    FieldTable fields{table.stream()};
    for (const Written& layer : layers) {
        if (layer.plan.form == geopackage::Form::none || layer.rows == 0) {
            continue;
        }
        watch(joined("shapefiles/", layer.plan.name));
        const std::map<Kind, Measured> kinds = measured(database, layer);
        std::map<Kind, ShapefileWriter> writers;
        for (const auto& [kind, found] : kinds) {
            const std::string name = file_name(layer, kind, kinds.size() == 1);
            if (is_too_large(found)) {
                fields.add_left_out(name);
                continue;
            }
            fields.add(name, layer.plan, found);
            writers.try_emplace(kind, place / name, kind, found);
            write_text(place / (name + ".cpg"), "UTF-8");
            if (!projection.empty()) {
                write_text(place / (name + ".prj"), projection);
            }
        }
        for (StoredRows rows{database, layer.plan}; rows.next();) {
            if (const auto writer = writers.find(rows.geometry().kind); writer != writers.end()) {
                writer->second.add(rows);
            }
        }
        for (auto& [kind, writer] : writers) {
            writer.close();
        }
    }
    table.close();
    return {"shapefiles/fields.csv", "The layers of results.gpkg as Shapefiles; which column each field is."};
}

}  // namespace coupling::vectors
