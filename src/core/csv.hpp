// Tables in comma-separated values (RFC 4180), read in blocks so that memory stays bounded whatever
// the file. Lines that start with # and blank lines are kept apart from records; a UTF-8 byte-order
// mark, CRLF line ends, quoted fields and a last line without an end are all accepted.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/progress.hpp"

namespace burnish {

inline constexpr std::size_t kLongestCsvRecord = std::size_t{1} << 20;
inline constexpr std::string_view kCsvByteOrderMark = "\xEF\xBB\xBF";

// One record, comment or blank line, byte for byte as in the file.
struct CsvRecord {
    std::string_view text;  // without its line end
    std::string_view end;   // "\n", "\r\n" or "" at the end of the file
    std::size_t line = 0;   // number of its first line, from 1

    bool is_data() const;  // neither a comment nor blank
};

// The place of a record in messages: "line 12".
std::string place_of(const CsvRecord& record);

// Reads a file or, for "-", the standard input. Throws Error for what cannot be read and for a
// record over kLongestCsvRecord, and Interrupted when `cancellable` is cancelled while it waits for
// bytes.
class CsvReader {
  public:
    explicit CsvReader(const std::string& path, Progress cancellable = {});
    CsvReader(const CsvReader&) = delete;
    CsvReader& operator=(const CsvReader&) = delete;
    ~CsvReader();

    // The next whole records; empty at the end of the file. They stay valid until the next call.
    std::span<const CsvRecord> next_block();

    const std::string& name() const { return name_; }  // for messages
    bool has_byte_order_mark() const { return has_byte_order_mark_; }
    double done() const;  // share of the file that has been read, 0..1; 0 for pipes

  private:
    void wait_for_bytes() const;
    void fill();
    void drop_byte_order_mark();

    std::string name_;
    Progress cancellable_;
    int descriptor_ = -1;
    std::size_t file_bytes_ = 0;
    std::size_t read_bytes_ = 0;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;  // of the bytes in the buffer that no block has held yet
    std::size_t end_ = 0;
    bool at_end_of_file_ = false;
    bool has_byte_order_mark_ = false;
    std::size_t next_line_ = 1;
    std::vector<CsvRecord> records_;
};

// Splits a record at its commas into `fields`, which keep their quotes. Returns false for a quoted
// field that is not closed or goes on after its closing quote.
bool split_csv_record(std::string_view text, std::vector<std::string_view>& fields);

// The content of a field, without the spaces around it and its quotes. Doubled quotes inside stay
// doubled: no name and no number contains a quote.
std::string_view csv_content(std::string_view field);

}  // namespace burnish
