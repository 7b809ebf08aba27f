#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace coupling::formats {

/// Whether a file beside a database (its name with `-journal` behind it) holds changes that were not
/// finished: an empty one and one whose head was zeroed hold none.
bool is_unfinished_journal(std::string_view journal);

/// A database of SQLite with the changes of its write-ahead log (its name with `-wal` behind it), as SQLite
/// itself would read both: what was committed counts, what came later does not. Both stay as they are.
///
/// Follows the published format (sqlite.org/fileformat2.html#walformat), version 3007000. A log that SQLite
/// would leave aside in silence is refused here: edits would be lost. Throws std::invalid_argument with what
/// was found: another format, other pages than the database, checksums that are wrong, frames that are cut
/// off, more than 8 GiB of pages.
std::string with_write_ahead_log(std::string_view database, std::string_view log);

}  // namespace coupling::formats
