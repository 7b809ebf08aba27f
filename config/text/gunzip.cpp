#include "config/text/gunzip.hpp"

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include "config/errors/input_error.hpp"

namespace config {

bool is_gzip(std::string_view bytes) {
    return bytes.starts_with("\x1F\x8B");
}

std::string gunzip(std::string_view bytes, const std::string& file) {
    namespace io = boost::iostreams;
    if (!is_gzip(bytes)) {
        fail(ExitCode::file, {file}, "another beginning", "a gzip file");
    }
    std::string unpacked;
    try {
        io::filtering_istream in;
        in.push(io::gzip_decompressor{});
        in.push(io::array_source{bytes.data(), bytes.size()});
        in.exceptions(std::ios::badbit);
        io::copy(in, io::back_inserter(unpacked));
    } catch (const io::gzip_error& error) {
        const bool checksum = error.error() == io::gzip::bad_crc;
        fail(ExitCode::file, {file},
             checksum ? "a gzip file whose content does not match its checksum"
                      : "a gzip file that is cut off or broken",
             "a whole one: copy it again");
    } catch (const std::ios::failure&) {
        fail(ExitCode::file, {file}, "a gzip file that is cut off or broken", "a whole one: copy it again");
    }
    return unpacked;
}

}  // namespace config
