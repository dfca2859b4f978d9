// Undo and redo.
#include "viewer/document/history.hpp"

#include <gtest/gtest.h>

#include <random>

namespace burnish::viewer {
namespace {

Document with_exposure(double ev) {
    Document document;
    document.values.set_value("exposure", ev);
    return document;
}

double exposure_of(const Document& document) {
    return document.values.real("exposure");
}

TEST(History, StepsBackAndForthAndForgetsWhatWasUndone) {
    History history(with_exposure(0));
    history.record(with_exposure(1), "", "exposure");
    history.record(with_exposure(2), "", "exposure again");
    EXPECT_EQ(history.undo_name(), "exposure again");
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(exposure_of(history.present()), 1.0);
    EXPECT_EQ(history.redo_name(), "exposure again");
    EXPECT_EQ(exposure_of(*history.redo_document()), 2.0);
    EXPECT_EQ(exposure_of(*history.undo_document()), 0.0);
    history.record(with_exposure(3));
    EXPECT_FALSE(history.can_redo());
    EXPECT_FALSE(history.redo());
    EXPECT_TRUE(history.undo());
    EXPECT_TRUE(history.undo());
    EXPECT_FALSE(history.undo());
    EXPECT_EQ(exposure_of(history.present()), 0.0);
    EXPECT_EQ(history.undo_document(), nullptr);
    EXPECT_EQ(history.undo_name(), "");
}

TEST(History, ADragIsOneStep) {
    History history(with_exposure(0));
    for (int i = 1; i <= 50; ++i) history.record(with_exposure(0.1 * i), "exposure", "exposure");
    EXPECT_EQ(history.undo_count(), 1u);
    history.close();
    history.record(with_exposure(6), "exposure", "exposure");
    EXPECT_EQ(history.undo_count(), 2u);
    history.record(with_exposure(7), "another key");
    history.record(with_exposure(8), "another key");
    EXPECT_EQ(history.undo_count(), 3u);
    history.undo();
    EXPECT_EQ(exposure_of(history.present()), 6.0);
    history.undo();
    EXPECT_EQ(exposure_of(history.present()), 5.0);
    // After an undo the same key begins a step: what was undone to must not be lost.
    history.record(with_exposure(9), "exposure");
    history.undo();
    EXPECT_EQ(exposure_of(history.present()), 5.0);
}

TEST(History, AnEqualDocumentIsNoStep) {
    History history(with_exposure(1));
    history.record(with_exposure(1));
    EXPECT_FALSE(history.can_undo());
    history.record(with_exposure(2));
    history.undo();
    history.record(with_exposure(1));
    EXPECT_TRUE(history.can_redo()) << "nothing was changed: redo stays";
}

TEST(History, KeepsTheLatestThousandSteps) {
    History history(with_exposure(-1));
    constexpr int kSteps = 2500;
    for (int i = 0; i < kSteps; ++i) history.record(with_exposure(0.001 * i));
    EXPECT_EQ(history.undo_count(), History::kMostSteps);
    int undone = 0;
    while (history.undo()) ++undone;
    EXPECT_EQ(undone, 1000);
    EXPECT_DOUBLE_EQ(exposure_of(history.present()), 0.001 * (kSteps - 1 - 1000));
    while (history.redo()) {
    }
    EXPECT_DOUBLE_EQ(exposure_of(history.present()), 0.001 * (kSteps - 1));
}

// Against a plain list of all documents.
TEST(History, DoesAsAListOfDocumentsDoes) {
    std::mt19937 random(18);
    History history(with_exposure(0));
    std::vector<double> list{0.0};
    std::size_t at = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto what = random() % 4;
        if (what < 2) {
            const double ev = static_cast<double>(random() % 1000) / 100.0;
            if (ev != list[at]) {
                list.resize(at + 1);
                list.push_back(ev);
                ++at;
            }
            history.record(with_exposure(ev));
        } else if (what == 2) {
            EXPECT_EQ(history.undo(), at > 0 && list.size() - at <= 1001);
            if (at > 0) --at;
        } else {
            EXPECT_EQ(history.redo(), at + 1 < list.size());
            if (at + 1 < list.size()) ++at;
        }
        ASSERT_EQ(exposure_of(history.present()), list[at]) << i;
        ASSERT_EQ(history.can_redo(), at + 1 < list.size());
    }
}

}  // namespace
}  // namespace burnish::viewer
