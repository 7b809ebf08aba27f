#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/figures/colours.hpp"
#include "coupling/results/geopackage/database.hpp"
#include "coupling/results/geopackage/geometry.hpp"
#include "coupling/results/geopackage/packed_index.hpp"
#include "coupling/results/geopackage/spatial_reference.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::geopackage {

using ColumnType = Holds;

struct Column {
    std::string name;
    ColumnType type = ColumnType::number;
    std::string meaning{};
    std::string unit{};  ///< as the dictionary of columns has it; empty: that which the name ends with
};

enum class Form : std::uint8_t { none, point, line, multi_line, polygon, multi_polygon, mixed };

/// How QGIS is to draw the rows with a value in the column `drawn_by`.
struct DrawnClass {
    std::string value;
    std::string label;
    Colour colour;
};

/// A layer, or a table without places.
struct Plan {
    std::string name;
    std::string sentence;  ///< what a row is
    std::vector<Column> columns;
    Form form = Form::none;
    Dimensions dimensions;
    std::string drawn_by{};             ///< column whose values decide the colour; empty: none
    std::vector<DrawnClass> classes{};  ///< of these values
    bool is_for_the_field = false;      ///< what devices in the field show: goes into results.gpx
    bool describes_columns = false;     ///< meanings of the columns stand in the file, for who fills them in
};

/// A layer or table as it was written.
struct Written {
    Plan plan;
    std::uint64_t rows = 0;
    Extent extent;
    std::vector<std::size_t> decimals{};  ///< of each column of numbers, as the fields were handed over
};

/// A GeoPackage being written: OGC 12-128r17, version 1.3, with the R-tree extension.
///
///     GeoPackage package{file, reference};
///     Layer layer{package, plan};   // one at a time
///     layer.add(fields, geometry); ...
///     layer.finish();
///     package.close();              // without it the file is unfinished
///
/// Everything that SQLite refuses throws config::InputError (file).
class GeoPackage {
public:
    GeoPackage(const std::filesystem::path& file, SpatialReference reference);
    /// In memory; `name` is for messages.
    GeoPackage(SpatialReference reference, const std::string& name);

    [[nodiscard]] std::int32_t srs_id() const { return reference_.id; }
    [[nodiscard]] const std::vector<Written>& written() const { return written_; }
    void close();
    /// Instead of `close`: the bytes of the file. Requires one in memory, and no layer that is not finished.
    [[nodiscard]] std::string bytes();

private:
    friend class Layer;

    void begin();

    SpatialReference reference_;
    Database database_;
    std::vector<Written> written_;
};

/// A layer or table being filled.
class Layer {
public:
    Layer(GeoPackage& package, Plan plan);

    /// A row: as many fields as columns, as the tables write them; an empty one is not known. Requires a
    /// geometry where the plan has a form.
    void add(const std::vector<std::string_view>& fields, const Geometry* geometry = nullptr);
    /// Index, triggers and the entries that make it known.
    void finish();

private:
    /// A field as the database takes it: nothing, a number or a text.
    struct Value {
        enum class Kind : std::uint8_t { null, whole, number, text } kind = Kind::null;
        std::int64_t whole = 0;
        double number = 0.0;
        std::string text;
        void take(ColumnType type, std::string_view field);
    };
    /// A row that waits until there are enough for a statement.
    struct Waiting {
        std::vector<Value> values;
        std::vector<std::uint8_t> geometry;
    };
    static void bind(Statement& insert, int parameter, const Value& value);
    /// Binds waiting rows from `first` on to a statement that takes `count` of them, and runs it.
    void insert_rows(Statement& insert, std::size_t first, std::size_t count);

    GeoPackage& package_;
    Written written_;
    std::vector<Waiting> waiting_;  ///< reused from statement to statement
    std::size_t waiting_rows_ = 0;
    std::optional<Statement> insert_many_;
    PackedIndex index_;
};

}  // namespace coupling::geopackage
