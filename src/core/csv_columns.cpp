#include "core/csv_columns.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <optional>
#include <type_traits>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "core/output_stream.hpp"
#include "core/parallel.hpp"
#include "core/text.hpp"

namespace burnish {
namespace {

// Rows of one task of the parallel loop: enough to outweigh the cost of a task, and few enough that
// a block has many tasks.
constexpr std::size_t kRowsAtOnce = 512;

std::string listed(std::span<const std::string_view> names) {
    std::string list;
    for (const std::string_view name : names) {
        if (!list.empty()) list += ' ';
        list += name;
    }
    return list;
}

std::string with_nearest(std::string found, std::span<const std::string_view> names,
                         std::string_view name) {
    const std::string_view nearest = nearest_name(names, name);
    if (!nearest.empty()) found.append("; did you mean '").append(nearest).append("'?");
    return found;
}

// ---- the header ---------------------------------------------------------------------------------

using Names = std::span<const std::string_view>;

[[noreturn]] void throw_missing(std::string_view column, Names names, const std::string& file,
                                const CsvRecord& header) {
    std::string found = "the header " + shown(header.text);
    const std::string_view nearest = nearest_name(names, column);
    if (!nearest.empty()) found = "none, but one named " + shown(nearest);
    if (header.text.find('\0') != std::string_view::npos) found = "binary data";
    throw Error(file, place_of(header), "a column named " + std::string(column), found);
}

std::size_t place_of_column(std::string_view column, Names names, const std::string& file,
                            const CsvRecord& header) {
    const auto found = std::find(names.begin(), names.end(), column);
    if (found == names.end()) return CsvLayout::kAbsent;
    if (std::find(found + 1, names.end(), column) != names.end()) {
        throw Error(file, place_of(header), "only one column named " + std::string(column),
                    "several");
    }
    return static_cast<std::size_t>(found - names.begin());
}

CsvLayout layout_of(const CsvRecord& header, const std::string& file, const CsvTask& task) {
    std::vector<std::string_view> names;
    if (!split_csv_record(header.text, names)) {
        throw Error(file, place_of(header), "closed quotes", shown(header.text));
    }
    std::transform(names.begin(), names.end(), names.begin(), csv_content);

    CsvLayout layout{file, {}, names.size()};
    for (const std::string_view column : task.required) {
        const std::size_t place = place_of_column(column, names, file, header);
        if (place == CsvLayout::kAbsent) throw_missing(column, names, file, header);
        layout.columns.push_back({column, place});
    }
    for (const std::string_view column : task.optional) {
        layout.columns.push_back({column, place_of_column(column, names, file, header)});
    }
    for (const std::string_view added : task.adds) {
        if (std::find(names.begin(), names.end(), added) == names.end()) continue;
        throw Error(file, place_of(header), "no column named " + std::string(added),
                    "one (it is to be added)");
    }
    return layout;
}

// ---- the rows -----------------------------------------------------------------------------------

// Consecutive rows, which one task of the parallel loop evaluates.
struct Chunk {
    std::string text;
    std::exception_ptr error;
};

void append_fields(const CsvRecord& record, const CsvLayout& layout,
                   std::vector<std::string_view>& row_fields,
                   std::vector<std::string_view>& fields) {
    if (!split_csv_record(record.text, row_fields)) {
        throw Error(layout.file, place_of(record), "closed quotes", shown(record.text));
    }
    if (row_fields.size() != layout.field_count) {
        throw Error(layout.file, place_of(record),
                    std::to_string(layout.field_count) + " fields, as in the header",
                    std::to_string(row_fields.size()));
    }
    fields.insert(fields.end(), row_fields.begin(), row_fields.end());
}

// The text to add to each data record before `bad`, the first record with broken fields.
std::vector<std::string> added_to(std::span<const CsvRecord> records, const CsvLayout& layout,
                                  const CsvTask& task, std::exception_ptr& bad) {
    std::vector<std::string_view> fields, row_fields;
    std::vector<const CsvRecord*> data;
    try {
        for (const CsvRecord& record : records) {
            if (!record.is_data()) continue;
            append_fields(record, layout, row_fields, fields);
            data.push_back(&record);
        }
    } catch (...) {
        bad = std::current_exception();
    }
    std::vector<CsvRow> rows;
    rows.reserve(data.size());
    const std::span<const std::string_view> all(fields);
    for (std::size_t i = 0; i < data.size(); ++i) {
        rows.emplace_back(layout, *data[i],
                          all.subspan(i * layout.field_count, layout.field_count));
    }
    std::vector<std::string> added(rows.size());
    task.evaluate(rows, added);
    return added;
}

void evaluate_rows(std::span<const CsvRecord> records, const CsvLayout& layout, const CsvTask& task,
                   Chunk& chunk) {
    chunk.text.clear();
    try {
        std::exception_ptr bad;
        const std::vector<std::string> added = added_to(records, layout, task, bad);
        if (bad) std::rethrow_exception(bad);
        std::size_t next = 0;
        for (const CsvRecord& record : records) {
            chunk.text += record.text;
            if (record.is_data()) chunk.text += added[next++];
            chunk.text += record.end;
        }
    } catch (...) {
        // Kept until all tasks have ended: an earlier row may have failed as well.
        chunk.error = std::current_exception();
    }
}

void evaluate_block(std::span<const CsvRecord> records, const CsvLayout& layout,
                    const CsvTask& task, std::vector<Chunk>& chunks, OutputStream& output) {
    chunks.resize((records.size() + kRowsAtOnce - 1) / kRowsAtOnce);
    parallel_for(records.size(), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
        evaluate_rows(records.subspan(begin, end - begin), layout, task,
                      chunks[begin / kRowsAtOnce]);
    });
    for (const Chunk& chunk : chunks) {
        if (chunk.error) std::rethrow_exception(chunk.error);
        output.write(chunk.text);
    }
}

// Copies the records before the header, and the header with the added names. Returns the rest of
// the block.
std::span<const CsvRecord> take_header(std::span<const CsvRecord> records, const CsvReader& reader,
                                       const CsvTask& task, std::optional<CsvLayout>& layout,
                                       OutputStream& output) {
    for (std::size_t i = 0; i < records.size(); ++i) {
        const CsvRecord& record = records[i];
        std::string line(record.text);
        if (record.is_data()) {
            layout = layout_of(record, reader.name(), task);
            for (const std::string_view added : task.adds) line.append(",").append(added);
        }
        output.write(line.append(record.end));
        if (layout) return records.subspan(i + 1);
    }
    return {};
}

void require_header(const std::optional<CsvLayout>& layout, const CsvReader& reader) {
    if (layout) return;
    throw Error(reader.name(), "", "a header line that names the columns",
                "nothing but comments and blank lines");
}

void transform_table(CsvReader& reader, const CsvTask& task, OutputStream& output,
                     const Progress& progress) {
    constexpr std::string_view kStage = "evaluate";
    progress.step(kStage, 0.0);
    std::optional<CsvLayout> layout;
    std::vector<Chunk> chunks;
    for (auto block = reader.next_block(); !block.empty(); block = reader.next_block()) {
        if (!layout) {
            if (reader.has_byte_order_mark()) output.write(kCsvByteOrderMark);
            block = take_header(block, reader, task, layout, output);
        }
        if (layout) evaluate_block(block, *layout, task, chunks, output);
        progress.step(kStage, reader.done());
    }
    require_header(layout, reader);
    output.finish();
    progress.step(kStage, 1.0);
}

// A number out of range, for which std::from_chars gives no value: infinity when it is too large,
// zero or a subnormal number when it is too small.
template <typename Float>
Float too_large_or_too_small(const std::string& digits) {
    if constexpr (std::is_same_v<Float, float>) {
        return std::strtof(digits.c_str(), nullptr);
    } else {
        return std::strtod(digits.c_str(), nullptr);
    }
}

}  // namespace

std::string_view CsvRow::text(std::size_t column) const {
    const std::size_t place = layout_->columns[column].place;
    return place == CsvLayout::kAbsent ? std::string_view() : csv_content(fields_[place]);
}

template <typename Float>
Float CsvRow::number(std::size_t column) const {
    const std::string_view written = text(column);
    const bool plus = written.size() > 1 && written[0] == '+' && written[1] != '-';
    const char* const begin = written.data() + (plus ? 1 : 0);
    const char* const end = written.data() + written.size();
    Float value{};
    const auto [stopped, status] = std::from_chars(begin, end, value);
    if (status == std::errc::result_out_of_range && stopped == end) {
        value = too_large_or_too_small<Float>(std::string(begin, end));
    } else if (status != std::errc{} || stopped != end) {
        fail(column, "a number", written.empty() ? "nothing" : shown(written));
    }
    if (!std::isfinite(value)) {
        fail(column, sizeof(Float) == 4 ? "a finite number in single precision" : "a finite number",
             shown(written));
    }
    return value;
}

template float CsvRow::number<float>(std::size_t) const;
template double CsvRow::number<double>(std::size_t) const;

std::size_t CsvRow::choice(std::size_t column, std::span<const std::string_view> names) const {
    const std::string_view name = text(column);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        fail(column, "one of " + listed(names),
             name.empty() ? "nothing" : with_nearest(shown(name), names, name));
    }
    return static_cast<std::size_t>(found - names.begin());
}

void CsvRow::fail(std::size_t column, std::string_view expected, std::string_view found) const {
    throw Error(layout_->file,
                place_of(*record_) + ", column " + std::string(layout_->columns[column].name),
                expected, found);
}

void read_csv_rows(const std::string& input, std::span<const std::string_view> columns,
                   const std::function<void(const CsvRow&)>& visit, const Progress& progress) {
    CsvReader reader(input, progress);
    const CsvTask task{columns, {}, {}, {}};
    std::optional<CsvLayout> layout;
    std::vector<std::string_view> row_fields, fields;
    for (auto block = reader.next_block(); !block.empty(); block = reader.next_block()) {
        progress.step("read", reader.done());
        for (const CsvRecord& record : block) {
            if (!record.is_data()) continue;
            if (!layout) {
                layout = layout_of(record, reader.name(), task);
                continue;
            }
            fields.clear();
            append_fields(record, *layout, row_fields, fields);
            visit(CsvRow(*layout, record, fields));
        }
    }
    require_header(layout, reader);
}

void add_csv_columns(const std::string& input, const std::string& output, const CsvTask& task,
                     const Progress& progress) {
    CsvReader reader(input, progress);
    if (output == "-") {
        OutputStream stream = OutputStream::standard_output(progress);
        transform_table(reader, task, stream, progress);
        return;
    }
    write_file_whole(output, [&](const std::filesystem::path& temporary) {
        OutputStream stream(temporary, output, progress);
        transform_table(reader, task, stream, progress);
    });
}

}  // namespace burnish
