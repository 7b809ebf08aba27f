#include "coupling/program/line/manual.hpp"

#include <sstream>
#include <string>

#include "coupling/program/line/help.hpp"

namespace coupling {
namespace {

constexpr const char* head = R"(.TH BANNWALD 1 "" "Bannwald" "User Commands"
.SH NAME
bannwald \- how well a forest protects from rockfall
.SH SYNOPSIS
.B bannwald
.I COMMAND
.RI [ ARGUMENTS ]
.RI [ OPTIONS ]
.SH DESCRIPTION
)";

constexpr const char* foot = R"(.SH FILES
Examples, parameter tables and validation cases are built into the program.
.BR "bannwald info" " and " "bannwald init"
print them.
.SH SEE ALSO
.BR mpirun (1)
.PP
.I /usr/share/doc/bannwald/README.md
)";

/// Lines as they are: hyphens stay hyphens, and no line is taken for an order to `man`.
void write_lines(const std::string& text, std::ostream& out) {
    out << ".nf\n";
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) {
            out << "\\&";
        }
        begins = c == '\n';
        if (c == '\\') {
            out << "\\e";
        } else if (c == '-') {
            out << "\\-";
        } else {
            out << c;
        }
    }
    out << ".fi\n";
}

}  // namespace

void write_man_page(const std::vector<Command>& commands, std::ostream& out) {
    out << head;
    std::ostringstream help;
    write_short_help(commands, help);
    write_lines(help.str(), out);
    out << ".SH COMMANDS\n";
    for (const Command& command : commands) {
        out << ".SS " << command.name << '\n';
        std::ostringstream of_command;
        write_help(command, of_command);
        write_lines(of_command.str(), out);
    }
    out << foot;
}

}  // namespace coupling
