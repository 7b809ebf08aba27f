#pragma once

#include <sqlite3.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling {

/// A GeoPackage that a program has open and has written to: nothing of its log is folded in.
class OpenPackage {
public:
    OpenPackage() {
        project_.write("map.gpkg", given_file("layers.gpkg"));
        sqlite3* opened = nullptr;
        sqlite3_open(project_.file("map.gpkg").c_str(), &opened);
        database_.reset(opened);
        run("PRAGMA journal_mode = WAL");
        run("PRAGMA wal_autocheckpoint = 0");
        // Triggers of GeoPackages call functions that SQLite alone does not have.
        for (const std::string& trigger : names_of("SELECT name FROM sqlite_master WHERE type = 'trigger'")) {
            run("DROP TRIGGER \"" + trigger + "\"");
        }
    }
    void run(const std::string& sql) const {
        if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
            throw std::runtime_error{sql + ": " + sqlite3_errmsg(database_.get())};
        }
    }
    [[nodiscard]] std::string main() const { return project_.read("map.gpkg"); }
    [[nodiscard]] std::string log() const { return project_.read("map.gpkg-wal"); }
    /// The species of all trees, as SQLite itself reads them.
    [[nodiscard]] std::string species() const {
        std::string text;
        for (const std::string& name : names_of("SELECT species FROM trees ORDER BY fid")) {
            text += name + ";";
        }
        return text;
    }

private:
    [[nodiscard]] std::vector<std::string> names_of(const char* sql) const {
        std::vector<std::string> names;
        sqlite3_exec(
            database_.get(), sql,
            [](void* all, int, char** values, char**) {
                static_cast<std::vector<std::string>*>(all)->emplace_back(values[0] == nullptr ? ""
                                                                                               : values[0]);
                return 0;
            },
            &names, nullptr);
        return names;
    }

    struct Close {
        void operator()(sqlite3* database) const { sqlite3_close(database); }
    };
    SampleProject project_;
    std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace coupling
