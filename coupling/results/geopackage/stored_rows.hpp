#pragma once

#include <string>
#include <vector>

#include "coupling/results/geopackage/package.hpp"
#include "coupling/results/geopackage/stored_geometry.hpp"

namespace coupling::geopackage {

/// The rows of a layer of a GeoPackage, one after the other as they were added, for files that hold the same
/// in another format.
///
///     for (StoredRows rows{database, plan}; rows.next();) { rows.fields() ... rows.geometry() }
class StoredRows {
public:
    /// Requires a layer with places.
    StoredRows(Database& database, const Plan& plan);

    bool next();
    /// As many as columns: numbers as the shortest text that reads back the same, empty where nothing is
    /// known.
    [[nodiscard]] const std::vector<std::string>& fields() const { return fields_; }
    [[nodiscard]] const StoredGeometry& geometry() const { return geometry_; }

private:
    const Plan& plan_;
    Statement rows_;
    std::vector<std::string> fields_;
    StoredGeometry geometry_;
};

}  // namespace coupling::geopackage
