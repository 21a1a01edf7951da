#include <gtest/gtest.h>

#include "panels/dialog_harness.hpp"

namespace sphereview {

namespace {

class QuestionDialog : public testing::Test {
protected:
    DialogHarness harness;
    std::vector<int> answers;
    std::size_t dialogs_when_told = 0;

    Question save_changes() {
        Question question;
        question.id = "save-changes";
        question.title = "Save changes?";
        question.text = "four.txt has changes.";
        question.answers = {"Save", "Discard", "Cancel"};
        question.cancel = 2;
        question.answer = [this](int number) {
            answers.push_back(number);
            dialogs_when_told = harness.dialogs.size();
        };
        return question;
    }
};

using Answers = std::vector<int>;

}  // namespace

TEST_F(QuestionDialog, IsAnsweredByTheMouse) {
    for (int number = 0; number < 3; ++number) {
        answers.clear();
        harness.put(save_changes());
        EXPECT_EQ(harness.top_id(), "save-changes");
        harness.click("answer " + std::to_string(number));
        EXPECT_EQ(answers, Answers{number});
        EXPECT_EQ(dialogs_when_told, 0U) << "a question is gone before its answer is told";
        EXPECT_EQ(harness.panels.vertices(), 0);
    }
    harness.put(save_changes());
    harness.click("answer Discard");
    EXPECT_EQ(answers, (Answers{2, 1}));
}

TEST_F(QuestionDialog, IsAnsweredByTheKeyboard) {
    harness.put(save_changes());
    harness.enter();
    EXPECT_EQ(answers, Answers{0});
    harness.put(save_changes());
    harness.escape();
    EXPECT_EQ(answers, (Answers{0, 2}));
    harness.put(save_changes());
    harness.step(1);
    harness.enter();
    EXPECT_EQ(answers, (Answers{0, 2, 1}));
    harness.put(save_changes());
    harness.step(-1);
    harness.enter();
    EXPECT_EQ(answers, (Answers{0, 2, 1, 2}));
    EXPECT_TRUE(harness.dialogs.empty());
}

TEST_F(QuestionDialog, IsNotAnsweredByClicksElsewhere) {
    harness.put(save_changes());
    harness.panels.click(ImVec2(5.0F, 5.0F));
    harness.panels.tap(ImGuiKey_Space);
    EXPECT_EQ(answers, Answers{});
    EXPECT_TRUE(harness.panels.has("answer 0"));
}

TEST_F(QuestionDialog, IsCancelledByItsCloseButton) {
    harness.put(save_changes());
    // Just inside of the title bar's right end, above what is widest in the dialog.
    const WidgetRectangle first = harness.panels.rectangles.at("answer 0");
    const ImGuiStyle& style = ImGui::GetStyle();
    const float right = first.left + 440.0F + style.WindowPadding.x - style.FramePadding.x - 0.5F * ImGui::GetFontSize();
    const float line = ImGui::GetFontSize();
    for (float y = first.top - 8.0F * line; y < first.top && answers.empty(); y += 0.5F * line)
        harness.panels.click(ImVec2(right, y));
    EXPECT_EQ(answers, Answers{2});
}

TEST_F(QuestionDialog, LiesAboveTheOneBefore) {
    harness.put(save_changes());
    Question other = save_changes();
    other.id = "other";
    other.answers = {"Yes"};
    other.cancel = 0;
    harness.put(other);
    EXPECT_TRUE(harness.panels.has("answer Yes"));
    EXPECT_FALSE(harness.panels.has("answer Save")) << "what lies below cannot be clicked";
    harness.enter();
    EXPECT_EQ(answers, Answers{0});
    EXPECT_EQ(harness.top_id(), "save-changes");
    harness.click("answer Cancel");
    EXPECT_EQ(answers, (Answers{0, 2}));
}

TEST_F(QuestionDialog, MayLeadToAnotherOfTheSameName) {
    Question first = save_changes();
    first.answer = [this](int) { harness.dialogs.emplace_back(save_changes()); };
    harness.put(first);
    harness.enter();
    EXPECT_EQ(harness.top_id(), "save-changes");
    EXPECT_TRUE(answers.empty()) << "one key press answers one question";
    harness.click("answer Discard");
    EXPECT_EQ(answers, Answers{1});
}

TEST_F(QuestionDialog, HoldsAVeryLongPath) {
    Question question = save_changes();
    question.text = "/" + std::string(4000, 'x') + " has changes.";
    question.title = "##";
    harness.put(question);
    harness.click("answer Save");
    EXPECT_EQ(answers, Answers{0});
}

}  // namespace sphereview
