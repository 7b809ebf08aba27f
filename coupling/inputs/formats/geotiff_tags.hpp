#pragma once

#include <cstdint>
#include <string>
#include <vector>

struct tiff;

namespace coupling::formats {

/// Throws InputError (data) about a TIFF.
[[noreturn]] void refuse_tiff(const std::string& file, std::string found, std::string expected,
                              std::string advice = "");

/// The text of a tag that libtiff does not know but GDAL writes; empty where it is missing.
std::string text_of_tag(tiff* tiff, std::uint32_t tag);

/// Looks at what else a TIFF says of its cells, so that nothing is dropped in silence. Refused: a scale or an
/// offset, a unit that is no metre but a length, a mask. Remarks name other units, a table of colours and
/// further grids; smaller copies for drawing are passed over.
void look_at_other_parts(tiff* tiff, const std::string& file, std::vector<std::string>& remarks);

}  // namespace coupling::formats
