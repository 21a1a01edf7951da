#include "panels/film_form.hpp"

#include <gtest/gtest.h>

#include "panels/harness.hpp"
#include "panels/widgets.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace {

class FilmDialog : public testing::Test {
protected:
    test::TemporaryFolder folder;
    DialogHarness harness;
    std::vector<std::string> accepted;
    std::vector<std::string> judged;  // the paths

    // Of a file of so many frames.
    void put(std::int64_t frames, const std::string& name = "a.mp4") {
        FileBrowser form;
        form.saving = true;
        form.title = "Export film";
        form.folder = folder.path();
        form.name = name;
        form.kinds = {{"Film", {".mp4"}, {}, "a.mp4"},
                      {"Pictures", {".png"}, "{frame", "{name}-{frame:05}.png"},
                      {"Animated", {".png"}, {}, "a.png"}};
        form.only_kinds = true;
        form.size = PictureSize{};
        form.film = std::make_shared<FilmForm>();
        form.film->frames = frames;
        form.film->marks = "axes";
        form.film->from_file = "The frames are the file's.";
        form.film->from_window = "As the window shows it.";
        form.film->judge = [this](const FilmForm& asked, const std::string& path) {
            judged.push_back(path);
            FilmJudgement judgement;
            judgement.summary = asked.chosen.frames + (asked.turns() ? " around" : "");
            judgement.fault = asked.chosen.frames == "9" ? "no frame 9" : "";
            judgement.is_film = path.find("{frame") == std::string::npos;
            judgement.has_quality = judgement.is_film && path.ends_with(".mp4");
            judgement.has_alpha = !judgement.has_quality;
            return judgement;
        };
        form.accept = [this](const std::string& path, PictureSize) { accepted.push_back(path); };
        harness.put(form);
    }
    FilmForm& form() { return *harness.top<FileBrowser>().film; }
    bool says(const std::string& words) {
        harness.panels.move({1.0F, 1.0F});  // no tooltip, which would be the text
        harness.panels.redraws(2);
        return harness.panels.text().find(words) != std::string::npos;
    }
};

using Accepted = std::vector<std::string>;

TEST_F(FilmDialog, GivesWhatIsChosen) {
    put(1000);
    EXPECT_EQ(harness.top_id(), "film");
    harness.type_over("film frames", "0:10:2");
    harness.click("film turns");
    harness.type_over("film turntable", "90");
    harness.click("film axis");
    harness.click("film axis y");
    harness.click("film samples");
    harness.click("film samples 4");
    harness.type_over("film rate", "25");
    harness.click("film marks");
    const FilmChoices chosen = form().chosen;
    EXPECT_EQ(chosen.frames, "0:10:2");
    EXPECT_TRUE(chosen.takes_frames && chosen.turns && chosen.marks);
    EXPECT_EQ(chosen.turntable, 90);
    EXPECT_EQ(chosen.axis, TurnAxis::y);
    EXPECT_EQ(chosen.samples, 4);
    EXPECT_EQ(chosen.rate, "25");
    EXPECT_TRUE(says("0:10:2 around"));
    EXPECT_TRUE(says("The frames are the file's."));
    harness.click("browser ok");
    EXPECT_EQ(accepted, Accepted{folder.path("a.mp4")});
}

TEST_F(FilmDialog, OffersOnlyATurntableOfASceneWithoutOtherFrames) {
    put(1);
    EXPECT_FALSE(harness.panels.has("film frames"));
    EXPECT_FALSE(harness.panels.has("film turns"));
    EXPECT_TRUE(harness.panels.has("film turntable"));
    EXPECT_TRUE(form().turns());
    EXPECT_FALSE(form().takes_frames());
    EXPECT_TRUE(says("As the window shows it."));
}

TEST_F(FilmDialog, HasForEachKindWhatThatCanBe) {
    put(10);
    EXPECT_TRUE(harness.panels.has("film rate") && harness.panels.has("film quality"));
    harness.click("film transparent");
    EXPECT_FALSE(form().chosen.transparent) << "such a film is opaque";
    harness.click("browser kind");
    harness.click("browser kind Pictures (.png)");
    EXPECT_EQ(harness.top<FileBrowser>().name, "{name}-{frame:05}.png");
    EXPECT_FALSE(harness.panels.has("film rate") || harness.panels.has("film quality"));
    EXPECT_EQ(judged.back(), folder.path("{name}-{frame:05}.png"));
    harness.click("film transparent");
    EXPECT_TRUE(form().chosen.transparent);
    harness.click("browser kind");
    harness.click("browser kind Animated (.png)");
    EXPECT_EQ(harness.top<FileBrowser>().name, "a.png");
    EXPECT_TRUE(harness.panels.has("film rate"));
    harness.enter_over("browser name", "b{frame}");
    EXPECT_EQ(accepted, Accepted{folder.path("b{frame}.png")}) << "the kind's ending";
}

TEST_F(FilmDialog, HasTheKindOfTheNameThatIsOffered) {
    put(10, "{name}-{frame:05}.png");
    EXPECT_EQ(harness.top<FileBrowser>().kind, 1U);
}

TEST_F(FilmDialog, EscapeAndEnterAreTheListsWhileItIsOpen) {
    put(10);
    for (const char* list : {"browser kind", "export sizes", "film samples"}) {
        harness.click(list);
        ASSERT_TRUE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
        const bool has_row = harness.panels.has("export 1920 x 1080") || harness.panels.has("browser kind Film (.mp4)") ||
                             harness.panels.has("film samples 4");
        EXPECT_TRUE(has_row) << list;
        harness.keys = {.enter = true};
        harness.panels.redraws(2);
        ASSERT_FALSE(harness.dialogs.empty()) << list;
        harness.keys = {.escape = true};
        harness.panels.tap(ImGuiKey_Escape);
        harness.panels.redraws(3);
        ASSERT_FALSE(harness.dialogs.empty()) << list;
        EXPECT_FALSE(harness.panels.has("export 1920 x 1080") || harness.panels.has("browser kind Film (.mp4)") ||
                     harness.panels.has("film samples 4"))
            << list;
    }
    EXPECT_TRUE(accepted.empty());
    harness.escape();
    EXPECT_TRUE(harness.dialogs.empty());
}

TEST_F(FilmDialog, TakesNoQualityBeyondTheBest) {
    put(10);
    harness.panels.modifiers(true);
    harness.panels.click("film quality");
    harness.panels.modifiers(false);
    harness.panels.type("1000");
    harness.panels.tap(ImGuiKey_Enter);
    EXPECT_EQ(form().chosen.quality, 100);
}

TEST_F(FilmDialog, StaysWhileSomethingIsWrong) {
    put(10);
    harness.type_over("film frames", "9");
    harness.panels.redraws(2);
    EXPECT_TRUE(says("no frame 9"));
    harness.click("browser ok");
    harness.enter();
    EXPECT_TRUE(accepted.empty());
    harness.type_over("film frames", "8");
    harness.enter();
    EXPECT_EQ(accepted.size(), 1U);
}

// In large text as well; where that leaves no room, the form scrolls and the buttons stay.
TEST_F(FilmDialog, HasRoomForEverythingInASmallWindow) {
    struct Case {
        float text_scale;
        ImVec2 window;
        bool scrolls;
    };
    const float usual = ImGui::GetFontSize();
    for (const auto& [text_scale, size, scrolls] :
         {Case{1.0F, {800.0F, 600.0F}, false}, {2.0F, {1280.0F, 800.0F}, false}, {3.0F, {1280.0F, 800.0F}, true}}) {
        SCOPED_TRACE(text_scale);
        ImGui::GetIO().DisplaySize = size;
        ImGui::GetIO().FontGlobalScale = text_scale * 15.0F / usual;
        apply_style(text_scale);
        harness.panels.scale = text_scale;
        put(10);
        const auto& widgets = harness.panels.rectangles;
        const WidgetRectangle ok = widgets.at("browser ok");
        EXPECT_LT(ok.bottom, size.y);
        EXPECT_LT(widgets.at("film summary").bottom, ok.top);
        const float lowest = widgets.at("film marks").bottom;
        EXPECT_EQ(lowest > ok.top, scrolls);
        for (const auto& [name, at] : widgets) EXPECT_LT(at.right, size.x) << name;
        harness.escape();
    }
}

}  // namespace

}  // namespace sphereview
