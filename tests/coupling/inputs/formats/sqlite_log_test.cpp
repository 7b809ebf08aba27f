// What a GeoPackage shows while a program has it open: its file and its write-ahead log together.

#include "coupling/inputs/formats/sqlite_log.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "coupling/inputs/formats/geopackage_layer.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"
#include "tests/coupling/inputs/formats/open_package.hpp"

namespace coupling::sqlite_log_test {
namespace {

std::string species_of(const std::string& main, const std::string& log) {
    const config::Table table = formats::read_geopackage(main, "trees", "map.gpkg", {log, {}}).layer.table;
    std::string text;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        text += table.text(row, "species") + ";";
    }
    return text;
}

std::string log_refused(const std::string& main, const std::string& log) {
    return refusal_of([&] { species_of(main, log); });
}

TEST(WriteAheadLog, HoldsWhatWasSaved) {
    const OpenPackage package;
    package.run("DELETE FROM trees WHERE fid = 2");
    package.run("UPDATE trees SET species = 'Lärche' WHERE fid = 1");
    EXPECT_NE(species_of(package.main(), ""), package.species());
    EXPECT_EQ(species_of(package.main(), package.log()), package.species());
    EXPECT_TRUE(formats::read_geopackage(package.main(), "trees", "map.gpkg", {package.log(), {}}).has_log);
}

TEST(WriteAheadLog, CountsUpToTheLastChangeThatIsFinished) {
    const OpenPackage package;
    package.run("UPDATE trees SET species = 'Fichte'");
    const std::string before = package.species();
    package.run("PRAGMA cache_size = 1");
    package.run("BEGIN");
    package.run("UPDATE trees SET species = hex(zeroblob(3000))");  // spills into the log
    EXPECT_EQ(species_of(package.main(), package.log()), before);
    package.run("ROLLBACK");
}

TEST(WriteAheadLog, ThatWasFoldedInChangesNothing) {
    const OpenPackage package;
    package.run("UPDATE trees SET species = 'Fichte'");
    package.run("PRAGMA wal_checkpoint(PASSIVE)");
    EXPECT_EQ(species_of(package.main(), ""), package.species());
    EXPECT_EQ(species_of(package.main(), package.log()), package.species());
    // The next change restarts the log over the old one.
    package.run("UPDATE trees SET species = 'Tanne' WHERE fid = 1");
    EXPECT_EQ(species_of(package.main(), package.log()), package.species());
}

// Any series of changes: what SQLite shows is what is read.
RC_GTEST_PROP(WriteAheadLog, GivesWhatSqliteShows, ()) {
    const OpenPackage package;
    const auto changes = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 6));
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const std::string number = std::to_string(i);
        switch (changes[i]) {
            case 0:
                package.run("INSERT INTO trees (species) VALUES ('new " + number + "')");
                break;
            case 1:
                package.run("DELETE FROM trees WHERE fid % 3 = " + std::to_string(i % 3));
                break;
            case 2:
                package.run("UPDATE trees SET species = '" + std::string(1 + 700 * (i % 5), 'x') + "'");
                break;
            case 3:
                package.run("PRAGMA wal_checkpoint(PASSIVE)");
                break;
            case 4:
                package.run("CREATE TABLE more_" + number + " (a)");
                break;
            default:
                package.run("VACUUM");
        }
    }
    RC_ASSERT(species_of(package.main(), package.log()) == package.species());
}

TEST(WriteAheadLog, IsRefusedWhereItIsDamaged) {
    const OpenPackage package;
    package.run("UPDATE trees SET species = 'Fichte'");
    const std::string main = package.main();
    const std::string log = package.log();
    EXPECT_EQ(log_refused(main, log.substr(0, log.size() - 7)),
              "map.gpkg: found a write-ahead log (-wal) beside it that is cut off, expected the log of this "
              "GeoPackage, which holds its last changes; close it in other programs, which folds the log in, "
              "and copy it again; delete the -wal only where it was left by another file of this name");
    std::string damaged = log;
    damaged[damaged.size() / 2] ^= 0x40;
    EXPECT_NE(log_refused(main, damaged).find("a damaged write-ahead log"), std::string::npos);
    EXPECT_NE(log_refused(main, "no log at all, but text of some length").find("no write-ahead log"),
              std::string::npos);
    std::string other = main;
    other[16] = 0x20;  // pages of another size
    EXPECT_NE(log_refused(other, log), "");
    EXPECT_NE(log_refused(given_file("layers.gpkg"), log).find("although it is written without one"),
              std::string::npos);
}

TEST(WriteAheadLog, NeverCrashesOnAnyBytes) {
    const OpenPackage package;
    package.run("UPDATE trees SET species = 'Fichte'");
    const std::string main = package.main();
    const std::string log = package.log();
    for (std::size_t at = 0; at < log.size(); at += 97) {
        std::string changed = log;
        changed[at] = static_cast<char>(changed[at] + 1);
        const std::string refused = log_refused(main, changed);
        EXPECT_TRUE(refused.empty() || refused.find("-wal") != std::string::npos) << at << ": " << refused;
        log_refused(main, log.substr(0, at));
    }
}

TEST(RollbackJournal, IsRefusedUnlessItIsFinished) {
    const auto refused = [](const std::string& journal) {
        return refusal_of([&] {
            formats::read_geopackage(given_file("layers.gpkg"), "trees", "map.gpkg", {{}, journal});
        });
    };
    EXPECT_EQ(refused(""), "");
    EXPECT_EQ(refused(std::string(512, '\0')), "");  // as journal_mode = PERSIST leaves it
    EXPECT_NE(refused("\xD9\xD5\x05\xF9\x20\xA1\x63\xD7 and more").find("a change is not finished"),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::sqlite_log_test
