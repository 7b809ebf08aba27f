#include "coupling/results/vectors/shapefiles.hpp"

#include <shapefil.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include "config/errors/input_error.hpp"
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
using ShapeKind = StoredGeometry::Kind;

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = std::numeric_limits<std::int32_t>::max();
constexpr double no_measure = -1e39;  // less than -1e38, as the format wants it

/// 1, 3, 5: points, lines, areas; 10 more with heights, 20 more with measures alone.
int type_of(ShapeKind kind, Dimensions dimensions) {
    const int plain = kind == ShapeKind::point  ? SHPT_POINT
                      : kind == ShapeKind::line ? SHPT_ARC
                                                : SHPT_POLYGON;
    return plain + (dimensions.z ? SHPT_POINTZ - SHPT_POINT : dimensions.m ? SHPT_POINTM - SHPT_POINT : 0);
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

using Shape = std::unique_ptr<SHPObject, decltype(&SHPDestroyObject)>;

/// A feature as the library takes it, rings turned as the format wants them.
Shape shape_of(const StoredGeometry& geometry) {
    const bool has_measures =
        geometry.dimensions.m || (geometry.kind == ShapeKind::point && geometry.dimensions.z);
    std::vector<int> begins;
    std::vector<double> x_m, y_m, z_m, measures;
    for (const StoredGeometry::Part& part : geometry.parts) {
        begins.push_back(static_cast<int>(x_m.size()));
        std::vector<Vertex> corners = part.corners;
        if (geometry.kind == ShapeKind::area && (turning(corners) > 0.0) != part.is_hole) {
            std::reverse(corners.begin(), corners.end());
        }
        for (const Vertex& corner : corners) {
            x_m.push_back(corner.x_m);
            y_m.push_back(corner.y_m);
            z_m.push_back(corner.z_m);
            measures.push_back(geometry.dimensions.m ? corner.measure : no_measure);
        }
    }
    const bool is_point = geometry.kind == ShapeKind::point;
    return {SHPCreateObject(type_of(geometry.kind, geometry.dimensions), -1,
                            is_point ? 0 : static_cast<int>(begins.size()),
                            is_point ? nullptr : begins.data(), nullptr, static_cast<int>(x_m.size()),
                            x_m.data(), y_m.data(), geometry.dimensions.z ? z_m.data() : nullptr,
                            has_measures ? measures.data() : nullptr),
            &SHPDestroyObject};
}

/// Bytes that a feature takes at most.
std::uint64_t most_bytes_of(const StoredGeometry& geometry) {
    constexpr std::uint64_t head = 8 + 44 + 2 * 16;  // of the record and the shape, limits of z and m
    std::uint64_t bytes = head + 4 * geometry.parts.size();
    for (const StoredGeometry::Part& part : geometry.parts) {
        bytes += 4 * sizeof(double) * part.corners.size();
    }
    return bytes;
}

/// What a first pass through a layer finds of its features of one kind.
struct Measured {
    explicit Measured(const Written& layer) : fields{layer.plan.columns, layer.decimals} {}
    DbfFields fields;
    Dimensions dimensions;
    std::uint64_t rows = 0;
    std::uint64_t shape_bytes = 0;  ///< at most
};

std::map<ShapeKind, Measured> measured(geopackage::Database& database, const Written& layer) {
    std::map<ShapeKind, Measured> kinds;
    for (StoredRows rows{database, layer.plan}; rows.next();) {
        const StoredGeometry& geometry = rows.geometry();
        Measured& of_kind = kinds.try_emplace(geometry.kind, layer).first->second;
        of_kind.fields.add_row(rows.fields());
        of_kind.dimensions = geometry.dimensions;
        of_kind.shape_bytes += most_bytes_of(geometry);
        ++of_kind.rows;
    }
    return kinds;
}

/// Why this thread's files could not be written; 0: they could. The library does not look at each write.
int& lost_by() {
    thread_local int reason = 0;
    return reason;
}

/// The library's own access to files.
const SAHooks& library_hooks() {
    static const SAHooks hooks = [] {
        SAHooks own;
        SASetupDefaultHooks(&own);
        return own;
    }();
    return hooks;
}

/// The same with an eye on what is lost.
SAHooks& checked_writes() {
    static SAHooks hooks = [] {
        SAHooks checked = library_hooks();
        checked.FOpen = [](const char* name, const char* access) {
            const SAFile file = library_hooks().FOpen(name, access);
            lost_by() = file == nullptr ? errno : lost_by();
            return file;
        };
        checked.FWrite = [](void* from, SAOffset size, SAOffset count, SAFile file) {
            const SAOffset written = library_hooks().FWrite(from, size, count, file);
            lost_by() = written < count ? errno : lost_by();
            return written;
        };
        checked.FClose = [](SAFile file) {
            const int result = library_hooks().FClose(file);
            lost_by() = result != 0 ? errno : lost_by();
            return result;
        };
        checked.Error = [](const char*) {};  // what it would print is thrown
        return checked;
    }();
    return hooks;
}

/// The three files of one kind of features and the name of their encoding, written by the library.
class ShapefileWriter {
public:
    ShapefileWriter(const fs::path& place, ShapeKind kind, const Measured& found)
        : place_{place.string()},
          found_{found},
          shapes_{SHPCreateLL(file(".shp").c_str(), type_of(kind, found.dimensions), &checked_writes())},
          rows_{DBFCreateLL(file(".dbf").c_str(), "UTF-8", &checked_writes())} {
        refuse_if_lost();
        DBFSetLastModifiedDate(rows_.get(), 100, 1, 1);  // the same bytes on every day
        for (const DbfField& field : found.fields.fields()) {
            DBFAddNativeFieldType(rows_.get(), field.name.c_str(), field.type, field.width, field.decimals);
        }
    }
    void add(const StoredRows& row) {
        const Shape shape = shape_of(row.geometry());
        const int number = SHPWriteObject(shapes_.get(), -1, shape.get());
        std::string words = found_.fields.row(row.fields());
        if (number < 0 || DBFWriteTuple(rows_.get(), number, words.data()) == 0) {
            lost_by() = lost_by() == 0 ? EIO : lost_by();  // the library gave up without a failed write
        }
        refuse_if_lost();
    }
    void close() {
        shapes_.reset();
        rows_.reset();
        refuse_if_lost();
    }

private:
    [[nodiscard]] std::string file(const char* ending) const { return place_ + ending; }
    void refuse_if_lost() const {
        if (const int reason = std::exchange(lost_by(), 0); reason != 0) {
            config::fail(config::ExitCode::file, {.file = file(".shp")},
                         joined("cannot be written: ", std::generic_category().message(reason)));
        }
    }

    std::string place_;
    const Measured& found_;
    std::unique_ptr<SHPInfo, decltype([](SHPHandle handle) { SHPClose(handle); })> shapes_;
    std::unique_ptr<DBFInfo, decltype([](DBFHandle handle) { DBFClose(handle); })> rows_;
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
std::string file_name(const Written& layer, ShapeKind kind, bool one_kind) {
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
        const std::map<ShapeKind, Measured> kinds = measured(database, layer);
        std::map<ShapeKind, ShapefileWriter> writers;
        for (const auto& [kind, found] : kinds) {
            const std::string name = file_name(layer, kind, kinds.size() == 1);
            if (is_too_large(found)) {
                fields.add_left_out(name);
                continue;
            }
            fields.add(name, layer.plan, found);
            writers.try_emplace(kind, place / name, kind, found);
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
