#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coupling/results/geopackage/geometry.hpp"

namespace coupling {

/// Draws features into a layer of a GeoPackage, as a GIS does that somebody draws in.
class Pencil {
public:
    explicit Pencil(const std::filesystem::path& drawing) {
        sqlite3* opened = nullptr;
        sqlite3_open_v2(drawing.c_str(), &opened, SQLITE_OPEN_READWRITE, nullptr);
        database_.reset(opened);
        // Triggers of GeoPackages call functions that SQLite alone does not have.
        std::string triggers;
        run("SELECT 'DROP TRIGGER \"' || name || '\";' FROM sqlite_master WHERE type = 'trigger'", &triggers);
        run(triggers);
    }

    using Corners = std::vector<config::Point2>;
    using Fields = std::vector<std::pair<std::string, std::string>>;

    void line(const std::string& layer, const Corners& corners, const Fields& fields = {}) {
        const std::vector<Corners> parts{corners};
        add(layer, geopackage::lines(parts, -1), fields);
    }
    void area(const std::string& layer, Corners corners, const Fields& fields = {}) {
        corners.push_back(corners.front());
        const std::vector<Corners> rings{std::move(corners)};
        add(layer, geopackage::polygons(rings, -1), fields);
    }
    void run(const std::string& sql, std::string* answer = nullptr) {
        const auto collect = [](void* all, int, char** values, char**) {
            static_cast<std::string*>(all)->append(values[0] == nullptr ? "" : values[0]);
            return 0;
        };
        std::string ignored;
        if (sqlite3_exec(database_.get(), sql.c_str(), collect, answer == nullptr ? &ignored : answer,
                         nullptr) != SQLITE_OK) {
            throw std::runtime_error{sql + ": " + sqlite3_errmsg(database_.get())};
        }
    }

private:
    void add(const std::string& layer, const geopackage::Geometry& geometry, const Fields& fields) {
        std::string names = "geom";
        std::string values = "x'";
        for (const std::uint8_t byte : geometry.bytes) {
            constexpr const char* digits = "0123456789abcdef";
            values += digits[byte >> 4U];
            values += digits[byte & 15U];
        }
        values += "'";
        for (const auto& [name, value] : fields) {
            names += ", " + name;
            values += ", '" + value + "'";
        }
        run("INSERT INTO " + layer + " (" + names + ") VALUES (" + values + ")");
    }

    struct Close {
        void operator()(sqlite3* database) const { sqlite3_close(database); }
    };
    std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace coupling
