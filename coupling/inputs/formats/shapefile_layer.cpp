#include "coupling/inputs/formats/shapefile_layer.hpp"

#include <shapefil.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/encoding.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/wkb.hpp"

namespace coupling::formats {
namespace {

using config::joined;

constexpr const char* export_shapes_again =
    "export the layer again (QGIS: Save features as), best as GeoPackage";

[[noreturn]] void refuse_parts(const std::string& file, std::string found, std::string expected,
                               std::string advice = export_shapes_again) {
    config::fail(config::ExitCode::data, {file}, std::move(found), std::move(expected), std::move(advice));
}

/// A part of the Shapefile while the library reads it. It knows files by name only and hands nothing else
/// through, so the parts of the one that is being read are found here.
struct OpenPart {
    std::string_view bytes;
    SAOffset at = 0;
};
thread_local const ShapefileParts* parts_being_read = nullptr;

OpenPart& part_of(SAFile file) {
    return *reinterpret_cast<OpenPart*>(file);
}

SAFile open_part(const char* name, const char*) {
    const std::string ending = std::string{name}.substr(std::strlen(name) - 3);
    const ShapefileParts& parts = *parts_being_read;
    const std::string_view bytes = ending == "shp"   ? parts.shp
                                   : ending == "shx" ? parts.shx
                                   : ending == "dbf" ? parts.dbf
                                                     : std::string_view{};
    return bytes.empty() ? nullptr : reinterpret_cast<SAFile>(new OpenPart{bytes, 0});
}

SAOffset read_part(void* to, SAOffset size, SAOffset count, SAFile file) {
    OpenPart& part = part_of(file);
    const SAOffset left = part.bytes.size() - std::min<SAOffset>(part.at, part.bytes.size());
    const SAOffset whole = size == 0 ? 0 : std::min(count, left / size);
    if (whole > 0) {
        std::memcpy(to, part.bytes.data() + part.at, whole * size);
        part.at += whole * size;
    }
    return whole;
}

SAOffset write_no_part(void*, SAOffset, SAOffset, SAFile) {
    return 0;
}

SAOffset seek_in_part(SAFile file, SAOffset offset, int from) {
    OpenPart& part = part_of(file);
    part.at = from == SEEK_SET ? offset : from == SEEK_CUR ? part.at + offset : part.bytes.size() + offset;
    return 0;
}

SAOffset place_in_part(SAFile file) {
    return part_of(file).at;
}

int flush_no_part(SAFile) {
    return 0;
}

int close_part(SAFile file) {
    delete &part_of(file);
    return 0;
}

int remove_no_part(const char*) {
    return -1;
}

void say_nothing_of_parts(const char*) {}

SAHooks hooks_of_parts() {
    SAHooks hooks{};
    SASetupDefaultHooks(&hooks);
    hooks.FOpen = open_part;
    hooks.FRead = read_part;
    hooks.FWrite = write_no_part;
    hooks.FSeek = seek_in_part;
    hooks.FTell = place_in_part;
    hooks.FFlush = flush_no_part;
    hooks.FClose = close_part;
    hooks.Remove = remove_no_part;
    hooks.Error = say_nothing_of_parts;
    return hooks;
}

struct CloseShapes {
    void operator()(SHPInfo* shapes) const { SHPClose(shapes); }
    void operator()(DBFInfo* rows) const { DBFClose(rows); }
    void operator()(SHPObject* shape) const { SHPDestroyObject(shape); }
};

bool has_heights(int type) {
    return type == SHPT_POINTZ || type == SHPT_ARCZ || type == SHPT_POLYGONZ || type == SHPT_MULTIPOINTZ;
}

/// The plain kind: 1 points, 3 lines, 5 polygons, 8 several points; the others are these with heights (10
/// more) or measures (20 more).
int plain_kind(int type) {
    return type % 10;
}

void write_part(const SHPObject& shape, int begin, int end, WktText& text) {
    for (int i = begin; i < end; ++i) {
        has_heights(shape.nSHPType) ? text.point(shape.padfX[i], shape.padfY[i], shape.padfZ[i])
                                    : text.point(shape.padfX[i], shape.padfY[i]);
    }
}

bool is_finite(const SHPObject& shape) {
    for (int i = 0; i < shape.nVertices; ++i) {
        if (!std::isfinite(shape.padfX[i]) || !std::isfinite(shape.padfY[i]) ||
            (has_heights(shape.nSHPType) && !std::isfinite(shape.padfZ[i]))) {
            return false;
        }
    }
    return true;
}

std::string wkt_of(const SHPObject& shape) {
    if (shape.nSHPType == SHPT_NULL || shape.nVertices == 0) {
        return {};
    }
    const std::string dimension = has_heights(shape.nSHPType) ? " Z " : " ";
    const int kind = plain_kind(shape.nSHPType);
    if (kind == SHPT_POINT || kind == SHPT_MULTIPOINT) {
        WktText text{(kind == SHPT_POINT ? "POINT" : "MULTIPOINT") + dimension};
        text.open();
        write_part(shape, 0, shape.nVertices, text);
        text.close();
        return text.text();
    }
    // Rings of a polygon follow one another, whatever they go round: what an odd number goes round is inside.
    const bool is_one_line = kind == SHPT_ARC && shape.nParts < 2;
    WktText text{(kind == SHPT_POLYGON ? "POLYGON"
                  : is_one_line        ? "LINESTRING"
                                       : "MULTILINESTRING") +
                 dimension};
    if (!is_one_line) {
        text.open();
    }
    for (int part = 0; part < std::max(shape.nParts, 1); ++part) {
        const int begin = shape.nParts > 0 ? shape.panPartStart[part] : 0;
        const int end = part + 1 < shape.nParts ? shape.panPartStart[part + 1] : shape.nVertices;
        text.open();
        write_part(shape, begin, end, text);
        text.close();
    }
    if (!is_one_line) {
        text.close();
    }
    return text.text();
}

/// How the texts of the table are written.
config::Encoding encoding_of(const ShapefileParts& parts, const std::string& file) {
    if (const std::string_view name = config::trimmed(parts.cpg); !name.empty()) {
        const auto known = config::encoding_named(name);
        if (!known) {
            refuse_parts(file, joined("texts in the encoding ", config::in_quotes(name), " (.cpg)"),
                         "UTF-8, ISO-8859-1 or Windows-1252", "export the layer again with encoding UTF-8");
        }
        return *known;
    }
    constexpr std::size_t at_language = 29;
    constexpr std::array<unsigned char, 2> windows_1252{0x03, 0x57};
    const auto mark = parts.dbf.size() > at_language ? static_cast<unsigned char>(parts.dbf[at_language])
                                                     : static_cast<unsigned char>(0);
    const bool is_windows = std::find(windows_1252.begin(), windows_1252.end(), mark) != windows_1252.end();
    // Many programs write the mark of Windows and UTF-8 nevertheless.
    return is_windows && !config::is_utf8(parts.dbf.substr(std::min<std::size_t>(parts.dbf.size(), 32)))
               ? config::Encoding::windows_1252
               : config::Encoding::unknown;
}

std::string attribute(DBFInfo* rows, int row, int column, const std::string& file) {
    if (DBFIsAttributeNULL(rows, row, column) != 0) {
        return {};
    }
    const char* text = DBFReadStringAttribute(rows, row, column);
    if (text == nullptr) {
        refuse_parts(file, joined("a table (.dbf) that ends at row ", std::to_string(row + 1)),
                     "a complete table");
    }
    std::string value{config::trimmed(text)};
    if (DBFGetNativeFieldType(rows, column) == 'L') {
        return value == "T" || value == "t" || value == "Y" || value == "y" ? "yes"
               : value == "?"                                               ? ""
                                                                            : "no";
    }
    return value;
}

/// While it lives the library finds the parts; it has no other way.
class PartsInUse {
public:
    explicit PartsInUse(const ShapefileParts& parts) { parts_being_read = &parts; }
    ~PartsInUse() { parts_being_read = nullptr; }
    PartsInUse(const PartsInUse&) = delete;
    PartsInUse& operator=(const PartsInUse&) = delete;
};

}  // namespace

bool is_shapefile(std::string_view bytes) {
    constexpr std::string_view file_code{"\0\0\x27\x0A", 4};
    return bytes.starts_with(file_code);
}

Layer read_shapefile(const ShapefileParts& parts, const std::string& file) {
    const PartsInUse in_use{parts};
    const SAHooks hooks = hooks_of_parts();
    const std::unique_ptr<SHPInfo, CloseShapes> shapes{
        SHPOpenLL("parts.shp", "rb", const_cast<SAHooks*>(&hooks))};
    if (!shapes) {
        refuse_parts(file, "shapes (.shp, .shx) that cannot be read", "a complete Shapefile");
    }
    const std::unique_ptr<DBFInfo, CloseShapes> rows{
        DBFOpenLL("parts.dbf", "rb", const_cast<SAHooks*>(&hooks))};
    if (!rows) {
        refuse_parts(file, "a table (.dbf) that cannot be read", "a complete Shapefile");
    }
    int shape_count = 0;
    int type = 0;
    SHPGetInfo(shapes.get(), &shape_count, &type, nullptr, nullptr);
    const int row_count = DBFGetRecordCount(rows.get());
    if (type == SHPT_MULTIPATCH || plain_kind(type) == 0 || type > SHPT_MULTIPOINTM) {
        refuse_parts(file, joined("shapes of the type ", SHPTypeName(type)), "points, lines or polygons");
    }
    if (shape_count != row_count) {
        refuse_parts(file,
                     joined(std::to_string(shape_count), " shapes and ", std::to_string(row_count), " rows"),
                     "a row for each shape");
    }
    const auto table_bytes =
        static_cast<std::uint64_t>(rows->nHeaderLength) +
        static_cast<std::uint64_t>(rows->nRecordLength) * static_cast<std::uint64_t>(row_count);
    if (parts.dbf.size() < table_bytes) {
        refuse_parts(
            file, joined("a table (.dbf) of ", std::to_string(parts.dbf.size()), " bytes, cut off"),
            joined(std::to_string(table_bytes), " bytes for its ", std::to_string(row_count), " rows"));
    }
    const config::Encoding encoding = encoding_of(parts, file);
    const int columns = DBFGetFieldCount(rows.get());
    config::Features features{.file = file, .columns = {}, .cells = {}, .numbers = {}};
    for (int column = 0; column < columns; ++column) {
        std::array<char, XBASE_FLDNAME_LEN_READ + 1> name{};
        DBFGetFieldInfo(rows.get(), column, name.data(), nullptr, nullptr);
        features.add_column(config::to_utf8(name.data(), encoding));
    }
    features.columns.emplace_back("wkt");
    config::Problems problems;
    constexpr std::size_t most_problems = 100;
    for (int row = 0; row < row_count && problems.list().size() < most_problems; ++row) {
        if (DBFIsRecordDeleted(rows.get(), row) != 0) {
            continue;
        }
        std::vector<std::string>& cells = features.cells.emplace_back();
        features.numbers.push_back(static_cast<std::uint32_t>(row + 1));
        for (int column = 0; column < columns; ++column) {
            cells.push_back(config::to_utf8(attribute(rows.get(), row, column, file), encoding));
        }
        const std::unique_ptr<SHPObject, CloseShapes> shape{SHPReadObject(shapes.get(), row)};
        cells.emplace_back();
        if (!shape || !is_finite(*shape)) {
            problems.add(config::ExitCode::data, {file, features.numbers.back(), features.columns.size()},
                         shape ? "a coordinate that is no number" : "a shape that cannot be read",
                         "points, lines or polygons", export_shapes_again);
            continue;
        }
        cells.back() = wkt_of(*shape);
    }
    problems.throw_if_any();
    return {config::Table::of(std::move(features)), std::string{config::trimmed(parts.prj)}};
}

}  // namespace coupling::formats
