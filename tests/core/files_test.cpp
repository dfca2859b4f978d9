#include "core/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// Files of this process may grow to `bytes` while this lives; more is an error, not a signal.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : old_action_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, old_action_);
    }

  private:
    rlimit old_{};
    void (*old_action_)(int);
};

TEST(ReadFile, ReadsBackWhatWasWritten) {
    const TemporaryFolder folder;
    const std::string text("line\n\0\xff end", 11);
    write_text_file(folder / "a.txt", text);
    EXPECT_EQ(read_text_file(folder / "a.txt"), text);
    EXPECT_EQ(read_file(folder / "a.txt").size(), text.size());
    EXPECT_EQ(read_file_head(folder / "a.txt", 4).size(), 4U);
    EXPECT_EQ(read_file_head(folder / "a.txt", 4000).size(), text.size());
    write_text_file(folder / "empty", "");
    EXPECT_TRUE(read_file(folder / "empty").empty());
}

TEST(ReadFile, NamesTheFileAndTheReason) {
    const TemporaryFolder folder;
    const std::string missing = (folder / "missing.txt").string();
    EXPECT_EQ(error_of([&] { read_file(missing); }),
              missing + ": expected a readable file, found no such file or folder");
    EXPECT_TRUE(contains(error_of([&] { read_file(folder.path()); }), "found a folder"));
    EXPECT_TRUE(contains(error_of([&] { read_file("/dev/zero"); }), "found a device"));
    write_text_file(folder / "big", std::string(1001, 'x'));
    EXPECT_NO_THROW(read_file(folder / "big", 1001));
    EXPECT_TRUE(contains(error_of([&] { read_file(folder / "big", 1000); }), "at most 1000 bytes"));
}

TEST(ReadFile, ReadsFilesThatHaveNoSize) {
    EXPECT_FALSE(read_text_file("/proc/self/status").empty());
    // A pipe that nobody writes to must not hang.
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_TRUE(read_file(folder / "pipe").empty());
    // One with a writer, as the shell's <(command) makes it.
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ASSERT_EQ(::write(ends[1], "hello", 5), 5);
    ::close(ends[1]);
    EXPECT_EQ(read_text_file("/dev/fd/" + std::to_string(ends[0])), "hello");
    ::close(ends[0]);
}

TEST(WriteFile, ReplacesTheOldFileAndLeavesNothingElse) {
    const TemporaryFolder folder;
    const fs::path path = folder / "out.txt";
    write_text_file(path, "old");
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    write_file_whole(path, [&](const fs::path& temporary) {
        EXPECT_EQ(temporary.parent_path(), folder.path());
        EXPECT_EQ(temporary.extension(), ".txt");
        EXPECT_EQ(read_text_file(path), "old");  // until the very end
        std::ofstream(temporary) << "new";
    });
    EXPECT_EQ(read_text_file(path), "new");
    EXPECT_EQ(fs::status(path).permissions(), fs::perms(0640));
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(WriteFile, GivesNewFilesTheUsualPermissions) {
    const TemporaryFolder folder;
    const mode_t mask = ::umask(0027);
    write_text_file(folder / "new.txt", "x");
    ::umask(mask);
    EXPECT_EQ(fs::status(folder / "new.txt").permissions(), fs::perms(0640));
}

TEST(WriteFile, KeepsTheOldFileWhenTheWriterThrows) {
    const TemporaryFolder folder;
    const fs::path path = folder / "out.txt";
    write_text_file(path, "old");
    const auto failing = [&] {
        write_file_whole(path, [](const fs::path& temporary) {
            std::ofstream(temporary) << "half";
            throw Interrupted();
        });
    };
    EXPECT_THROW(failing(), Interrupted);
    EXPECT_EQ(read_text_file(path), "old");
    EXPECT_EQ(folder.entries(), 1U);
}

// The temporary's name would tell nobody which file it was, and is gone.
TEST(WriteFile, ErrorsNameTheFileThatWasAskedFor) {
    const TemporaryFolder folder;
    try {
        write_file_whole(folder / "new.txt", [](const fs::path& temporary) {
            write_file_whole(temporary, [](const fs::path& inner) {
                throw Error(inner.string(), "", "room", "none");
            });
        });
        ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  (folder / "new.txt").string() + ": expected room, found none");
    }
}

TEST(WriteFiles, AllOrNone) {
    const TemporaryFolder folder;
    const fs::path first = folder / "first", second = folder / "second";
    write_text_file(first, "old");
    const auto text = [](const char* words) {
        return [words](const fs::path& path) { write_text_file(path, words); };
    };
    const auto fails = [](const fs::path&) { throw Error("no"); };
    EXPECT_THROW(write_files_whole(std::vector<FileToWrite>{{first, text("a")}, {second, fails}}),
                 Error);
    EXPECT_EQ(read_text_file(first), "old");
    EXPECT_FALSE(fs::exists(second));
    // A folder in the way of the first is seen before anything has a name.
    fs::create_directory(folder / "in the way");
    EXPECT_THROW(write_files_whole(std::vector<FileToWrite>{{folder / "in the way", text("a")},
                                                            {second, text("b")}}),
                 Error);
    EXPECT_FALSE(fs::exists(second));
    write_files_whole(std::vector<FileToWrite>{{first, text("a")}, {second, text("b")}});
    EXPECT_EQ(read_text_file(first), "a");
    EXPECT_EQ(read_text_file(second), "b");
}

TEST(WriteFile, FollowsLinksToTheirFile) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "there");
    write_text_file(folder / "there/real.txt", "old");
    fs::create_symlink(folder / "there/real.txt", folder / "link.txt");
    write_text_file(folder / "link.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
    EXPECT_EQ(read_text_file(folder / "there/real.txt"), "new");
}

TEST(WriteFile, KeepsTheOldFileWhenTheSizeLimitIsHit) {
    const TemporaryFolder folder;
    const fs::path text = folder / "out.txt", picture = folder / "out.png";
    write_text_file(text, "old");
    write_text_file(picture, "old");
    const Image image = sample_picture(200, 200, 3);
    std::string text_error, picture_error;
    {
        const FileSizeLimit limit(4096);
        text_error = error_of([&] { write_text_file(text, std::string(5000, 'x')); });
        picture_error = error_of([&] { write_image(picture, image, {}); });
    }
    EXPECT_EQ(text_error, text.string() +
                              ": expected a file that can be written, found the file "
                              "size limit is reached");
    EXPECT_TRUE(contains(picture_error, picture.string())) << picture_error;
    EXPECT_EQ(read_text_file(text), "old");
    EXPECT_EQ(read_text_file(picture), "old");
    EXPECT_EQ(folder.entries(), 2U);
}

TEST(WriteFile, NoticesAFullDevice) {
    EXPECT_TRUE(contains(error_of([] { write_text_file("/dev/full", "x"); }),
                         "no space left on the device"));
    EXPECT_NO_THROW(write_text_file("/dev/null", "x"));
    EXPECT_TRUE(contains(error_of([] {
                             write_file_whole("/dev/full", [](const fs::path& temporary) {
                                 std::ofstream(temporary) << "text";
                             });
                         }),
                         "no space left on the device"));
    // Through a name with an ending, as an image needs one.
    const TemporaryFolder folder;
    fs::create_symlink("/dev/full", folder / "full.png");
    const Image image = sample_picture(8, 8, 3);
    EXPECT_TRUE(contains(error_of([&] { write_image(folder / "full.png", image, {}); }),
                         "no space left on the device"));
    EXPECT_TRUE(fs::is_symlink(folder / "full.png"));
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(WriteFile, StreamsIntoPipes) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    write_text_file("/dev/fd/" + std::to_string(ends[1]), "through the pipe");
    ::close(ends[1]);
    EXPECT_EQ(read_text_file("/dev/fd/" + std::to_string(ends[0])), "through the pipe");
    ::close(ends[0]);
}

TEST(WriteFile, RefusesFoldersAndMissingFolders) {
    const TemporaryFolder folder;
    const fs::path nowhere = folder / "no/out.png";
    for (const fs::path& path : {nowhere, folder.path(), fs::path()}) {
        EXPECT_THROW(write_text_file(path, "x"), Error) << path;
        EXPECT_THROW(require_writable(path), Error) << path;
    }
    EXPECT_TRUE(contains(error_of([&] { require_writable(nowhere); }), "no folder"));
    EXPECT_NO_THROW(require_writable(folder / "out.png"));
    EXPECT_NO_THROW(require_writable("/dev/null"));
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(WriteFile, RefusesWriteProtectedFiles) {
    if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write everything";
    const TemporaryFolder folder;
    write_text_file(folder / "protected.txt", "old");
    fs::permissions(folder / "protected.txt", fs::perms(0444));
    EXPECT_THROW(write_text_file(folder / "protected.txt", "new"), Error);
    EXPECT_EQ(read_text_file(folder / "protected.txt"), "old");
}

}  // namespace
}  // namespace burnish::test
