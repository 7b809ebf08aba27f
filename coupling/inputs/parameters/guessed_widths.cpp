#include "coupling/inputs/parameters/guessed_widths.hpp"

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"

namespace coupling {

std::string text_of_guessed_widths() {
    constexpr const char* of_guess = "0.35";  // [choice] in parameter_widths.csv
    std::string text =
        "# What is not known, as factors on the laws of the fall; width: standard deviation of ln(factor), "
        "0: known.\n"
        "# ground_guess: write 0 once you have checked the ground types; block_size: once you know the sizes "
        "of "
        "the rocks.\n"
        "parameter,width,goes_with,correlation,acts_on\n";
    const config::Table table = config::read_shipped_table("parameter_widths.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& parameter = table.text(row, "parameter");
        const bool is_guess = parameter == "ground_guess" || parameter == "block_size";
        text += config::joined(parameter, ",", is_guess ? of_guess : table.text(row, "width"), ",",
                               table.text(row, "goes_with"), ",", table.text(row, "correlation"), ",",
                               config::csv_field(table.text(row, "acts_on")), "\n");
    }
    return text;
}

}  // namespace coupling
