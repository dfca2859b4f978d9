// What `mdf eval` and `brdf eval` share: the table in, the table out, and everything that can be
// wrong with either.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "jobs/models/eval.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

constexpr const char* kHeader = "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz";

// Exponents 0: D = 1/(2 pi) everywhere above n~, and normalised to Int D (n.h) dw = 1 twice that.
constexpr const char* kFlatRow = "ashikhmin-shirley,0,0,none,0,0,1,0,0,1";
constexpr const char* kFlatValues = ",0.15915494309189535,0.3183098861837907,0.3183098861837907";
constexpr const char* kAdded = ",D,D_proj,D_conserving";

class Table : public testing::Test {
  protected:
    Outcome eval(const std::string& text, const std::string& out = "-") {
        return run_burnish({"mdf", "eval", "--in", folder_.write("in.csv", text), "--out", out});
    }

    void expect_refused(const std::string& text, const std::vector<std::string>& parts) {
        const EvalRequest request{folder_.write("in.csv", text), folder_.path("refused.csv")};
        expect_parts(refusal_of([&] { eval_mdf_table(request, Progress()); }), parts);
        EXPECT_EQ(folder_.names(), (std::vector<std::string>{"in.csv"}));
    }

    void expect_row_error(const std::string& row, const std::vector<std::string>& parts) {
        SCOPED_TRACE(row);
        std::vector<std::string> all{"in.csv: line 2"};
        all.insert(all.end(), parts.begin(), parts.end());
        expect_refused(std::string(kHeader) + "\n" + row + "\n", all);
    }

    Folder folder_;
};

TEST_F(Table, EverythingElseStaysAsItIs) {
    const std::string row = kFlatRow;
    const Outcome outcome = eval("# before\n\n" + std::string(kHeader) +
                                 ",note\n"
                                 "# between, \"with an open quote\n" +
                                 row + ",\"a, \"\"quoted\"\" note\"\n   \n" + row +
                                 ",\"two\nlines\"\n" + row + ",  spaces \n" + row + ",end");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    const std::string values = kFlatValues;
    EXPECT_EQ(outcome.output, "# before\n\n" + std::string(kHeader) + ",note" + kAdded +
                                  "\n# between, \"with an open quote\n" + row +
                                  ",\"a, \"\"quoted\"\" note\"" + values + "\n   \n" + row +
                                  ",\"two\nlines\"" + values + "\n" + row + ",  spaces " + values +
                                  "\n" + row + ",end" + values);
    EXPECT_EQ(outcome.complaint, "");
}

TEST_F(Table, WindowsFilesAreKept) {
    const Outcome outcome =
        eval("\xEF\xBB\xBF" + std::string(kHeader) + "\r\n#c\r\n" + kFlatRow + "\r\n\r\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(outcome.output, "\xEF\xBB\xBF" + std::string(kHeader) + kAdded + "\r\n#c\r\n" +
                                  kFlatRow + kFlatValues + "\r\n\r\n");
}

TEST_F(Table, ColumnsInAnyOrderQuotedOrNot) {
    const Outcome outcome = eval(
        "hz,id,\"mdf\", p0 ,p1,nz,ny,nx,hy,hx,method\n"
        "1,7,\"ashikhmin-shirley\", 0 ,+0,1,0,\"0\",0,0,none\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_NE(outcome.output.find(std::string("none") + kFlatValues), std::string::npos)
        << outcome.output;
}

TEST_F(Table, HeaderOnlyGivesHeaderOnly) {
    const Outcome outcome = eval(std::string(kHeader) + "\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(outcome.output, std::string(kHeader) + kAdded + "\n");
}

TEST_F(Table, NoHeaderIsAnError) {
    expect_refused("", {"in.csv", "header"});
    expect_refused("# only\n\n# comments\n", {"in.csv", "header"});
    expect_refused("\xEF\xBB\xBF", {"in.csv", "header"});
}

TEST_F(Table, HeaderMustNameEveryColumnOnce) {
    expect_refused("mdf,p0,p1,method,nx,ny,nz,hx,hy\n", {"line 1", "hz", "h"});
    expect_refused("mdf,p0,p1,methods,nx,ny,nz,hx,hy,hz\n",
                   {"a column named method", "\"methods\""});
    expect_refused("mdf,p0,p1,method,nx,ny,nz,hx,hy,hz,hx\n", {"only one column named hx"});
    expect_refused(std::string(kHeader) + ",D_proj\n", {"no column named D_proj"});
    expect_refused("\"mdf,p0\n", {"line 1"});
}

TEST_F(Table, BinaryJunkIsAnError) {
    std::string junk;
    unsigned state = 1;
    for (int i = 0; i < 100000; ++i) {
        state = state * 1664525U + 1013904223U;
        junk += static_cast<char>(state >> 24U);
    }
    expect_refused(junk, {"in.csv"});
    expect_complaint(eval(junk), 1, {"in.csv"});
    expect_refused(std::string("\x89PNG\0\0\0\n", 8), {"binary"});
    expect_refused(std::string(3U << 20U, 'x'), {"at most 1 MiB"});
    expect_refused(std::string(kHeader) + "\n\"" + std::string(3U << 20U, '\n'),
                   {"line 2", "at most 1 MiB"});
    expect_refused(std::string(200000, ',') + "\n", {"a column named mdf"});
}

TEST_F(Table, BadRowsNameLineColumnExpectedAndFound) {
    expect_row_error("ggx,.1,.2,none,0,0,1,0,0", {"expected 10 fields", "found 9"});
    expect_row_error("ggx,.1,.2,none,0,0,1,0,0,1,5", {"expected 10 fields", "found 11"});
    expect_row_error("ggy,.1,.2,none,0,0,1,0,0,1",
                     {"column mdf", "one of ashikhmin-shirley", "\"ggy\"", "did you mean 'ggx'?"});
    expect_row_error(",.1,.2,none,0,0,1,0,0,1", {"column mdf", "found nothing"});
    expect_row_error("ggx,.1,.2,rotate,0,0,1,0,0,1", {"column method", "\"rotate\"", "rotate-arc"});
    expect_row_error("ggx,one,.2,none,0,0,1,0,0,1", {"column p0", "number", "\"one\""});
    expect_row_error("ggx,.1,,none,0,0,1,0,0,1", {"column p1", "alpha_y from 0.001 to 1.5"});
    expect_row_error("ggx,0,.2,none,0,0,1,0,0,1", {"column p0", "alpha_x from 0.001 to 1.5"});
    expect_row_error("ggx,.1,1.6,none,0,0,1,0,0,1", {"column p1", "found \"1.6\""});
    expect_row_error("ashikhmin-shirley,-1,.2,none,0,0,1,0,0,1", {"e_x from 0 to 1000000"});
    expect_row_error("ggx,.1,.2,none,0,0,1,0,0,nan", {"column hz", "finite", "\"nan\""});
    expect_row_error("ggx,.1,.2,none,inf,0,1,0,0,1", {"column nx", "finite", "\"inf\""});
    expect_row_error("ggx,.1,.2,none,1e400,0,1,0,0,1", {"column nx", "finite", "\"1e400\""});
    expect_row_error("ggx,.1,.2,none,0,0,1,0.5x,0,1", {"column hx", "\"0.5x\""});
    expect_row_error("ggx,.1,.2,none,0,0,1,0x1p0,0,1", {"column hx", "\"0x1p0\""});
    expect_row_error("ggx,.1,.2,none,0,0,1,--1,0,1", {"column hx", "\"--1\""});
    expect_row_error("ggx,.1,.2,none,0,0,1,0,0,0", {"column hx", "zero vector"});
    expect_row_error("ggx,.1,.2,none,0,0,0,0,0,1", {"column nx", "zero vector"});
    expect_row_error("ggx,.1,.2,none,1,0,0,0,0,1", {"column nz", "nz > 0", "found \"0\""});
    expect_row_error("ggx,.1,.2,none,0,0,-1,0,0,1", {"column nz", "nz > 0", "found \"-1\""});
    expect_row_error("\"ggx,.1,.2,none,0,0,1,0,0,1", {"closed quotes"});
    expect_row_error("\"ggx\"x,.1,.2,none,0,0,1,0,0,1", {"closed quotes"});
}

TEST_F(Table, NumbersTooSmallToHoldAreZero) {
    const Outcome outcome = eval(std::string(kHeader) + "\nward,.1,.2,none,1e-400,0,1,0,0,1e300\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_NE(outcome.output.find("1e300,1,"), std::string::npos) << outcome.output;
}

TEST_F(Table, TheFirstOfManyBadRowsIsReported) {
    std::string text = std::string(kHeader) + "\n";
    for (int i = 0; i < 20000; ++i) {
        text += i < 7000 ? kFlatRow : "ggx,.1,.2,none,0,0,1,0,0,bad";
        text += '\n';
    }
    for (int again = 0; again < 3; ++again) expect_complaint(eval(text), 1, {"line 7002,"});
}

TEST_F(Table, AFailureLeavesTheOldOutput) {
    const std::string out = folder_.write("out.csv", "old");
    expect_complaint(eval(std::string(kHeader) + "\n" + kFlatRow + "\nbad\n", out), 1, {"line 3"});
    EXPECT_EQ(contents_of(out), "old");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"in.csv", "out.csv"}));
}

TEST_F(Table, OutputMayBeTheInput) {
    const std::string in = folder_.path("in.csv");
    const Outcome outcome = eval(std::string(kHeader) + "\n" + kFlatRow + "\n", in);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(contents_of(in),
              std::string(kHeader) + kAdded + "\n" + kFlatRow + kFlatValues + "\n");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"in.csv"}));
}

TEST_F(Table, StandardInputAndOutput) {
    const std::string text = std::string(kHeader) + "\n" + kFlatRow + "\n";
    const Outcome outcome =
        run_burnish({"mdf", "eval", "--in", "-", "--out", "-"}, {.input = text});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(outcome.output, std::string(kHeader) + kAdded + "\n" + kFlatRow + kFlatValues + "\n");
    expect_complaint(run_burnish({"mdf", "eval", "--in", "-", "--out", "-"}), 1,
                     {"standard input", "header"});
}

TEST_F(Table, InputsThatCannotBeRead) {
    const std::string out = folder_.path("out.csv");
    expect_complaint(run_burnish({"mdf", "eval", "--in", folder_.path("none.csv"), "--out", out}),
                     1, {"none.csv", "no such file"});
    expect_complaint(run_burnish({"mdf", "eval", "--in", folder_.path(""), "--out", out}), 1,
                     {"readable file"});
    expect_complaint(run_burnish({"mdf", "eval", "--in", "/dev/zero", "--out", out}), 1,
                     {"/dev/zero", "at most 1 MiB"});
    EXPECT_TRUE(folder_.names().empty());
}

TEST_F(Table, OutputsThatCannotBeWritten) {
    const std::string text = std::string(kHeader) + "\n" + kFlatRow + "\n";
    expect_complaint(eval(text, "/dev/full"), 1, {"/dev/full", "space"});
    expect_complaint(eval(text, folder_.path("no/such/out.csv")), 1, {"out.csv", "no folder"});
    expect_complaint(eval(text, folder_.path("")), 1, {"can be written"});
    const std::string in = folder_.write("in.csv", text);
    expect_complaint(
        run_burnish({"mdf", "eval", "--in", in, "--out", "-"}, {.output_file = "/dev/full"}), 1,
        {"standard output", "space"});
}

TEST_F(Table, AFileSizeLimitIsAnErrorNotADeath) {
    std::string text = std::string(kHeader) + "\n";
    for (int i = 0; i < 4000; ++i) text += std::string(kFlatRow) + "\n";
    const std::string in = folder_.write("in.csv", text);
    const std::string out = folder_.write("out.csv", "old");
    expect_complaint(
        run_burnish({"mdf", "eval", "--in", in, "--out", out}, {.file_size_limit = 65536}), 1,
        {"out.csv", "file size limit"});
    EXPECT_EQ(contents_of(out), "old");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"in.csv", "out.csv"}));
}

TEST_F(Table, AMillionRows) {
    constexpr std::size_t kRows = 1000000;
    std::string text = std::string(kHeader) + ",row\n";
    for (std::size_t i = 0; i < kRows; ++i) {
        text += "ward,.1,.3,follow-grain,.2,.1,.9,.3,.1,.8," + std::to_string(i) + "\n";
    }
    const std::string out = folder_.path("out.csv");
    const Outcome outcome = eval(text, out);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;

    const std::string result = contents_of(out);
    std::size_t rows = 0, at = result.find('\n') + 1;
    for (; at < result.size(); at = result.find('\n', at) + 1, ++rows) {
        const std::string expected = ",.8," + std::to_string(rows) + ",";
        const std::size_t place = result.find(",.8,", at);
        ASSERT_EQ(result.compare(place, expected.size(), expected), 0) << "row " << rows;
    }
    EXPECT_EQ(rows, kRows);
}

}  // namespace
}  // namespace burnish::test
