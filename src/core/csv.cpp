#include "core/csv.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "burnish/error.hpp"
#include "burnish/progress.hpp"
#include "core/files.hpp"

namespace burnish {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{4} << 20;
static_assert(kBlockBytes > kLongestCsvRecord);

constexpr std::string_view kBlanks = " \t";

[[noreturn]] void throw_unreadable(const std::string& name) {
    throw Error(name, "", "a readable file", reason_of(errno));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// The offset behind the closing quote of the quoted field that starts at `begin`; npos when the
// quote is missing. A doubled quote is one quote of the text.
std::size_t end_of_quotes(std::string_view text, std::size_t begin) {
    std::size_t quote = text.find('"', begin + 1);
    while (quote != std::string_view::npos && quote + 1 < text.size() && text[quote + 1] == '"') {
        quote = text.find('"', quote + 2);
    }
    return quote == std::string_view::npos ? quote : quote + 1;
}

bool is_quoted(std::string_view text, std::size_t begin) {
    return begin < text.size() && text[begin] == '"';
}

// Bytes of the record at the front of `text`, its line end included; npos when it is not whole.
std::size_t record_length(std::string_view text) {
    const std::size_t line_end = text.find('\n');
    if (line_end == std::string_view::npos) return line_end;
    const bool quotes = text.substr(0, line_end).find('"') != std::string_view::npos;
    if (!quotes || text.front() == '#') return line_end + 1;

    for (std::size_t begin = 0;;) {
        const std::size_t from = is_quoted(text, begin) ? end_of_quotes(text, begin) : begin;
        if (from == std::string_view::npos) return from;
        const std::size_t end = text.find_first_of(",\n", from);
        if (end == std::string_view::npos) return end;
        if (text[end] == '\n') return end + 1;
        begin = end + 1;
    }
}

CsvRecord record_of(std::string_view whole, std::size_t line) {
    std::size_t length = whole.size();
    if (length > 0 && whole[length - 1] == '\n') --length;
    if (length < whole.size() && length > 0 && whole[length - 1] == '\r') --length;
    return {whole.substr(0, length), whole.substr(length), line};
}

}  // namespace

bool CsvRecord::is_data() const {
    return !text.empty() && text.front() != '#' &&
           text.find_first_not_of(kBlanks) != std::string_view::npos;
}

std::string place_of(const CsvRecord& record) {
    return "line " + std::to_string(record.line);
}

CsvReader::CsvReader(const std::string& path, Progress cancellable)
    : name_(path == "-" ? "standard input" : path),
      cancellable_(std::move(cancellable)),
      descriptor_(path == "-" ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw_unreadable(name_);
    struct stat status {};
    if (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) {
        file_bytes_ = static_cast<std::size_t>(status.st_size);
    }
}

CsvReader::~CsvReader() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

double CsvReader::done() const {
    if (file_bytes_ == 0) return 0.0;
    return static_cast<double>(read_bytes_) / static_cast<double>(file_bytes_);
}

std::span<const CsvRecord> CsvReader::next_block() {
    if (buffer_.empty()) {
        buffer_.resize(kBlockBytes);
        fill();
        drop_byte_order_mark();
    } else {
        fill();
    }

    records_.clear();
    while (begin_ < end_) {
        const std::string_view rest(buffer_.data() + begin_, end_ - begin_);
        std::size_t length = record_length(rest.substr(0, kLongestCsvRecord));
        if (length == std::string_view::npos) {
            if (rest.size() >= kLongestCsvRecord) {
                throw Error(name_, "line " + std::to_string(next_line_),
                            "lines of at most 1 MiB (are quotes closed?)", "a longer one");
            }
            if (!at_end_of_file_) break;
            length = rest.size();
        }
        records_.push_back(record_of(rest.substr(0, length), next_line_));
        const std::string_view whole = rest.substr(0, length);
        next_line_ += static_cast<std::size_t>(std::count(whole.begin(), whole.end(), '\n'));
        begin_ += length;
    }
    return records_;
}

// Waits for bytes in short sleeps: a signal between a look at the token and a read that blocks
// would otherwise go unnoticed until the next bytes come.
void CsvReader::wait_for_bytes() const {
    constexpr int kSleepMs = 100;
    pollfd waiting{descriptor_, POLLIN, 0};
    for (;;) {
        cancellable_.throw_if_cancelled();
        const int ready = ::poll(&waiting, 1, kSleepMs);
        if (ready > 0) return;
        if (ready < 0 && errno != EINTR) throw_unreadable(name_);
    }
}

// Moves the unread bytes to the front and reads until the buffer is full or the file ends.
void CsvReader::fill() {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    while (!at_end_of_file_ && end_ < buffer_.size()) {
        wait_for_bytes();
        const ssize_t count = ::read(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw_unreadable(name_);
        at_end_of_file_ = count == 0;
        end_ += static_cast<std::size_t>(count);
        read_bytes_ += static_cast<std::size_t>(count);
    }
}

void CsvReader::drop_byte_order_mark() {
    has_byte_order_mark_ = std::string_view(buffer_.data(), end_).starts_with(kCsvByteOrderMark);
    if (has_byte_order_mark_) begin_ = kCsvByteOrderMark.size();
}

bool split_csv_record(std::string_view text, std::vector<std::string_view>& fields) {
    fields.clear();
    for (std::size_t begin = 0;;) {
        const bool quoted = is_quoted(text, begin);
        const std::size_t from = quoted ? end_of_quotes(text, begin) : begin;
        if (from == std::string_view::npos) return false;
        const std::size_t end = std::min(text.find(',', from), text.size());
        if (quoted && end != from) return false;
        fields.push_back(text.substr(begin, end - begin));
        if (end == text.size()) return true;
        begin = end + 1;
    }
}

std::string_view csv_content(std::string_view field) {
    if (field.size() >= 2 && field.front() == '"') field = field.substr(1, field.size() - 2);
    return trimmed(field);
}

}  // namespace burnish
