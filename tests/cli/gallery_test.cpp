// burnish gallery as a person runs it: ids, files, the page, what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "burnish/image_io.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

// Every figure and the table of the two papers, by the numbers they bear there.
TEST(Gallery, ListsEveryFigureOfThePapers) {
    const Outcome outcome = run_burnish({"gallery", "--list"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    std::set<std::string> listed;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);)
        listed.insert(line.substr(0, line.find(' ')));
    std::set<std::string> papers = {"k12-table1", "b12-models", "b12-measured"};
    for (int i = 1; i <= 15; ++i) papers.insert("k11-fig" + std::to_string(i));
    for (int i = 1; i <= 10; ++i) papers.insert("k12-fig" + std::to_string(i));
    EXPECT_EQ(listed, papers);
}

TEST(Gallery, PageShowsWhatItWroteAndNothingFromElsewhere) {
    const Folder folder;
    const std::string out = folder.path("pages/gallery");
    const Outcome outcome = run_burnish({"gallery", "k12-fig4", "k11-fig7", "--quick", "-o", out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    std::istringstream lines(outcome.output);
    std::set<std::string> written, there;
    for (std::string line; std::getline(lines, line);)
        written.insert(std::filesystem::path(line).filename().string());
    for (const auto& entry : std::filesystem::directory_iterator(out))
        there.insert(entry.path().filename().string());
    EXPECT_EQ(written, there);

    const std::string html = contents_of(out + "/index.html");
    EXPECT_LT(html.find("id=\"k11-fig7\""), html.find("id=\"k12-fig4\""));  // the papers' order
    const std::regex reference("(src|href)=\"([^\"]*)\"");
    for (std::sregex_iterator at(html.begin(), html.end(), reference), end; at != end; ++at) {
        const std::string target = (*at)[2];
        if (target.starts_with("#"))
            EXPECT_NE(html.find("id=\"" + target.substr(1) + "\""), std::string::npos) << target;
        else
            EXPECT_TRUE(std::filesystem::exists(out + "/" + target)) << target;
    }
    EXPECT_EQ(html.find("<script"), std::string::npos);

    const auto json = nlohmann::json::parse(contents_of(out + "/gallery.json"));
    ASSERT_EQ(json.at("figures").size(), 2u);
    for (const auto& figure : json.at("figures")) {
        EXPECT_FALSE(figure.at("claim").get<std::string>().empty());
        EXPECT_FALSE(figure.at("measured").empty());
        EXPECT_EQ(figure.at("verdict"), "borne out");
    }
}

// The command beside a figure makes what stands in it.
TEST(Gallery, CommandsOfAFigureRun) {
    const Folder folder;
    const std::string out = folder.path("gallery");
    ASSERT_EQ(run_burnish({"gallery", "k11-fig2", "k11-fig3", "--quick", "-o", out}).exit_code, 0);
    const auto json = nlohmann::json::parse(contents_of(out + "/gallery.json"));
    int run = 0;
    for (const auto& figure : json.at("figures")) {
        for (const std::string command : figure.at("commands")) {
            std::vector<std::string> words;
            std::istringstream stream(command);
            for (std::string word; stream >> word;) {
                std::erase(word, '\'');
                words.push_back(word == "OUT.png" ? folder.path("out.png") : word);
            }
            ASSERT_EQ(words.front(), "burnish");
            words.erase(words.begin());
            const Outcome outcome = run_burnish(words);
            EXPECT_EQ(outcome.exit_code, 0) << command << ": " << outcome.complaint;
            EXPECT_FALSE(read_image(folder.path("out.png")).empty());
            ++run;
        }
    }
    EXPECT_EQ(run, 6);
}

TEST(Gallery, RefusesWhatItCannotDo) {
    const Folder folder;
    expect_complaint(run_burnish({"gallery", "k11-fig16", "-o", folder.path("out")}), 2,
                     {"k11-fig16", "did you mean"});
    expect_complaint(run_burnish({"gallery", "k11-fig2"}), 2, {"-o", "folder"});
    std::ofstream(folder.path("file")) << "kept";
    expect_complaint(run_burnish({"gallery", "k11-fig2", "-o", folder.path("file")}), 1, {"file"});
    EXPECT_EQ(contents_of(folder.path("file")), "kept");
    expect_complaint(run_burnish({"gallery", "b12-measured", "--measured", folder.path("none"),
                                  "-o", folder.path("out")}),
                     1, {"none"});
}

}  // namespace
}  // namespace burnish::test
