#include "config/data/shipped_tables.hpp"

#include <stdexcept>

#include "config/table/table.hpp"

// Each table becomes a pair of symbols around its bytes. The list of tables is written by
// config/CMakeLists.txt.
#define SHIPPED(symbol, name)                                                                      \
    asm(".pushsection .rodata\n"                                                                   \
        ".hidden bannwald_" #symbol "_begin\n.globl bannwald_" #symbol "_begin\nbannwald_" #symbol \
        "_begin:\n.incbin \"" BANNWALD_DATA_DIR "/" name                                           \
        "\"\n"                                                                                     \
        ".hidden bannwald_" #symbol "_end\n.globl bannwald_" #symbol "_end\nbannwald_" #symbol     \
        "_end:\n.popsection\n");                                                                   \
    extern "C" const char bannwald_##symbol##_begin[];                                             \
    extern "C" const char bannwald_##symbol##_end[];
#include "shipped_tables.inc"
#undef SHIPPED

namespace config {

namespace {

struct ShippedTable {
    std::string name;
    std::string_view text;
};

std::vector<ShippedTable> all_tables() {
    std::vector<ShippedTable> tables;
#define SHIPPED(symbol, name) tables.push_back({name, {bannwald_##symbol##_begin, bannwald_##symbol##_end}});
#include "shipped_tables.inc"
#undef SHIPPED
    return tables;
}

}  // namespace

std::string_view shipped_table(std::string_view name) {
    for (const ShippedTable& table : all_tables()) {
        if (table.name == name) {
            return table.text;
        }
    }
    throw std::out_of_range{"no shipped table " + std::string{name}};
}

Table read_shipped_table(std::string_view name) {
    return Table::read(shipped_table(name), std::string{name});
}

std::vector<std::string> shipped_table_names() {
    std::vector<std::string> names;
    for (const ShippedTable& table : all_tables()) {
        names.push_back(table.name);
    }
    return names;
}

}  // namespace config
