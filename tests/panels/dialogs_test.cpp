#include <gtest/gtest.h>

#include "image/image.hpp"
#include "panels/harness.hpp"
#include "panels/widgets.hpp"
#include "support/temporary_folder.hpp"

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
    for (const auto& [step, answer] : {std::pair{0, 0}, {1, 1}, {-1, 2}}) {
        harness.put(save_changes());
        if (step != 0) harness.step(step);
        harness.enter();
        ASSERT_FALSE(answers.empty());
        EXPECT_EQ(answers.back(), answer);
    }
    harness.put(save_changes());
    harness.escape();
    EXPECT_EQ(answers, (Answers{0, 1, 2, 2}));
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

class ExportDialog : public testing::Test {
protected:
    test::TemporaryFolder folder;
    DialogHarness harness;
    std::vector<std::string> accepted;  // "PATH WIDTHxHEIGHT"

    FileBrowser form() {
        FileBrowser form;
        form.saving = true;
        form.folder = folder.path();
        form.name = "four.png";
        form.kinds = {{"PNG", {".png"}}};
        form.size = PictureSize{};
        form.accept = [this](const std::string& path, PictureSize size) {
            accepted.push_back(path + " " + std::to_string(size.width) + "x" + std::to_string(size.height));
        };
        return form;
    }
    PictureSize size() { return harness.top<FileBrowser>().size.value(); }
};

std::string fault_with(int width, int height) {
    FileBrowser tried;
    tried.size = PictureSize{width, height};
    return size_fault(tried);
}

using Accepted = std::vector<std::string>;

TEST_F(ExportDialog, GivesNameAndSize) {
    harness.put(form());
    EXPECT_EQ(harness.top_id(), "export");
    harness.type_over("browser name", folder.path("other"));
    harness.type_over("export width", "300");
    harness.type_over("export height", "200");
    harness.click("browser ok");
    EXPECT_EQ(accepted, Accepted{folder.path("other.png") + " 300x200"});
    EXPECT_TRUE(harness.dialogs.empty());
}

TEST_F(ExportDialog, IsUsedByKeyboardAlone) {
    harness.put(form());
    // The name has the focus, and is replaced by what is typed.
    harness.panels.type("typed.png");
    harness.enter();
    EXPECT_EQ(accepted, Accepted{folder.path("typed.png") + " 1000x1000"}) << "a relative name lies beside the one that was there";
    harness.put(form());
    harness.escape();
    EXPECT_EQ(accepted.size(), 1U);
    EXPECT_TRUE(harness.dialogs.empty());
}

TEST_F(ExportDialog, HasPresets) {
    FileBrowser with_view = form();
    with_view.view = PictureSize{1234, 567};
    harness.put(with_view);
    harness.click("export sizes");
    harness.click("export 1920 x 1080");
    EXPECT_EQ(size().width, 1920);
    EXPECT_EQ(size().height, 1080);
    harness.click("export sizes");
    harness.click("export view");
    EXPECT_EQ(size().width, 1234);
    EXPECT_EQ(size().height, 567);
    harness.click("browser cancel");
    EXPECT_TRUE(harness.dialogs.empty());
    EXPECT_TRUE(accepted.empty());
}

TEST_F(ExportDialog, OffersTheMarksThatTheWindowShows) {
    harness.put(form());
    EXPECT_FALSE(harness.panels.has("export marks")) << "the window shows none";
    harness.escape();
    FileBrowser with_marks = form();
    with_marks.marks = std::make_shared<MarksChoice>(MarksChoice{"axes and scale bar", false});
    harness.put(with_marks);
    harness.click("export marks");
    EXPECT_TRUE(with_marks.marks->drawn);
}

TEST_F(ExportDialog, RefusesWhatIsNoPicture) {
    EXPECT_EQ(FileBrowser{}.most_pixels, most_pixels);
    EXPECT_EQ(fault_with(1000, 1000), "");
    EXPECT_EQ(fault_with(1, 429'496'729), "");
    EXPECT_EQ(fault_with(1, 429'496'730), "At most 429,496,729 pixels, please; these are 429,496,730.");
    EXPECT_EQ(fault_with(2'147'483'647, 2'147'483'647), "At most 429,496,729 pixels, please; these are 4,611,686,014,132,420,609.");
    for (const auto& [width, height] : {std::pair{0, 5}, {5, 0}, {-1, -1}, {0, 0}}) {
        EXPECT_EQ(fault_with(width, height), "Each side needs at least 1 pixel.");
    }
    EXPECT_EQ(size_fault(FileBrowser{}), "");
}

TEST_F(ExportDialog, StaysWhileSomethingIsWrong) {
    harness.put(form());
    for (const char* width : {"0", "-5", "99999999999999999999"}) {
        harness.enter_over("export width", width);
        harness.click("browser ok");
        EXPECT_EQ(harness.top_id(), "export") << width;
        EXPECT_NE(size_fault(harness.top<FileBrowser>()), "") << width;
    }
    harness.type_over("export width", "5");
    harness.enter_over("browser name", "");
    EXPECT_EQ(harness.top_id(), "export");
    EXPECT_TRUE(accepted.empty());
    harness.enter_over("browser name", folder.path("good.png"));
    EXPECT_EQ(accepted, Accepted{folder.path("good.png") + " 5x1000"});
}

TEST_F(ExportDialog, HasRoomForEverythingInASmallWindow) {
    const ImVec2 size{800.0F, 600.0F};
    constexpr float text_scale = 2.0F;
    ImGui::GetIO().DisplaySize = size;
    ImGui::GetIO().FontGlobalScale = text_scale * 15.0F / ImGui::GetFontSize();
    apply_style(text_scale);
    harness.panels.scale = text_scale;
    FileBrowser with_marks = form();
    with_marks.marks = std::make_shared<MarksChoice>(MarksChoice{"axes and scale bar", false});
    harness.put(with_marks);
    const auto& widgets = harness.panels.rectangles;
    EXPECT_GT(widgets.at("browser up").top, 50.0F) << "below the title";
    EXPECT_LT(widgets.at("export marks").bottom, widgets.at("browser ok").top);
    EXPECT_LT(widgets.at("browser ok").bottom, size.y);
}

TEST_F(ExportDialog, AsksBeforeItReplaces) {
    folder.write("four.png", "old");
    harness.put(form());
    harness.click("browser ok");
    EXPECT_EQ(harness.top_id(), "replace");
    harness.escape();
    EXPECT_EQ(harness.top_id(), "export") << "another name can be tried";
    harness.enter();
    EXPECT_EQ(harness.top_id(), "replace");
    harness.enter();
    EXPECT_EQ(harness.top_id(), "export") << "two quick presses of Enter replace nothing";
    EXPECT_TRUE(accepted.empty());
    harness.enter();
    harness.click("answer Replace");
    EXPECT_EQ(accepted, Accepted{folder.path("four.png") + " 1000x1000"});
    EXPECT_TRUE(harness.dialogs.empty());
}

TEST_F(ExportDialog, ComesBackWithTheErrorOfWhoWrites) {
    FileBrowser failing = form();
    failing.accept = [this](const std::string& path, PictureSize) {
        FileBrowser again = form();
        again.name = path;
        again.error = "cannot write: the disk is full";
        harness.dialogs.emplace_back(again);
    };
    harness.put(failing);
    harness.enter();
    harness.panels.redraws(4);
    EXPECT_EQ(harness.top_id(), "export");
    EXPECT_NE(harness.panels.text().find("the disk is full"), std::string::npos);
    harness.type_over("browser name", folder.path("other.png"));
    EXPECT_EQ(harness.panels.text().find("the disk is full"), std::string::npos) << "of another name nothing is known yet";
    harness.enter();
    EXPECT_EQ(accepted, Accepted{folder.path("other.png") + " 1000x1000"});
}

}  // namespace

}  // namespace sphereview
