#include "panels/messages.hpp"

#include <gtest/gtest.h>

#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

struct MessageHarness {
    Messages messages;
    MessageArea area{100.0F, 50.0F, 600.0F, 500.0F};
    ClosedMessages closed;
    PanelHarness panels{[this](const PanelContext& context) {
                            const ClosedMessages now = draw_messages(context, messages, area);
                            closed.scene_error |= now.scene_error;
                            closed.shader_error |= now.shader_error;
                            closed.work |= now.work;
                        },
                        {},
                        800.0F,
                        600.0F};

    WidgetRectangle rectangle(const std::string& name) {
        panels.frames(4);
        return panels.rectangles.at(name);
    }
    void expect_inside(const std::string& name) {
        const WidgetRectangle r = rectangle(name);
        EXPECT_GE(r.left, area.x) << name;
        EXPECT_GE(r.top, area.y) << name;
        EXPECT_LE(r.right, area.x + area.width) << name;
        EXPECT_LE(r.bottom, area.y + area.height) << name;
    }
};

std::string lines(int count) {
    std::string text;
    for (int i = 1; i <= count; ++i) text += "shade.frag:" + std::to_string(i) + ": error: syntax error, unexpected '}'\n";
    return text;
}

}  // namespace

TEST(MessagesPanel, DrawsNothingWithoutAMessage) {
    MessageHarness harness;
    EXPECT_EQ(harness.panels.vertices(), 0);
    EXPECT_TRUE(harness.panels.rectangles.empty());
}

TEST(MessagesPanel, AnnouncesAtTheBottom) {
    MessageHarness harness;
    harness.messages.announcement = "Saved /home/a/b.png";
    harness.expect_inside("message announcement");
    const WidgetRectangle r = harness.rectangle("message announcement");
    EXPECT_GT(r.top, 450.0F);
    EXPECT_NEAR(0.5F * (r.left + r.right), 400.0F, 2.0F);
    EXPECT_NE(harness.panels.text().find("Saved /home/a/b.png"), std::string::npos);
}

TEST(MessagesPanel, AnnouncementLetsClicksThrough) {
    MessageHarness harness;
    harness.messages.announcement = "Saved /home/a/b.png";
    harness.panels.frames(4);
    harness.panels.move(harness.panels.place("message announcement"));
    EXPECT_FALSE(ImGui::GetIO().WantCaptureMouse);
}

TEST(MessagesPanel, WrapsAVeryLongPath) {
    MessageHarness harness;
    harness.messages.announcement = "Saved /" + std::string(900, 'x') + ".png";
    harness.messages.scene_error = "/" + std::string(900, 'y') + ".toml:3:4: expected %s%n";
    harness.expect_inside("message announcement");
    harness.expect_inside("message scene error");
    const WidgetRectangle error = harness.rectangle("message scene error");
    EXPECT_GT(error.bottom - error.top, 5.0F * ImGui::GetFontSize()) << "on several lines";
}

TEST(MessagesPanel, ShowsWhatIsReadAndCancelsOnlyWhatCanBe) {
    MessageHarness harness;
    harness.messages.work = WorkShown{"Reading /" + std::string(200, 'y') + "%s.txt: 35 of 70 MB", 0.5, true};
    harness.expect_inside("message work");
    harness.expect_inside("cancel work");
    EXPECT_FALSE(harness.closed.work);
    harness.panels.click("cancel work");
    EXPECT_TRUE(harness.closed.work);
    harness.panels.rectangles.clear();
    harness.messages.work = WorkShown{"Saving a.txt", {}, false};
    harness.expect_inside("message work");
    EXPECT_FALSE(harness.panels.rectangles.contains("cancel work"));
}

TEST(MessagesPanel, ShowsWhatIsBrokenUntilItIsClosed) {
    MessageHarness harness;
    harness.messages.scene_error = "four.txt:2:5: expected a number";
    harness.messages.shader_error = lines(500);
    harness.expect_inside("message scene error");
    harness.expect_inside("message shader error");
    EXPECT_GE(harness.rectangle("message shader error").top, harness.rectangle("message scene error").bottom);
    EXPECT_NE(harness.panels.text().find("last good scene is shown"), std::string::npos) << harness.panels.text();
    EXPECT_NE(harness.panels.text().find("four.txt:2:5: expected a number"), std::string::npos);
    EXPECT_FALSE(harness.closed.scene_error);
    harness.panels.click("close scene error");
    EXPECT_TRUE(harness.closed.scene_error);
    EXPECT_FALSE(harness.closed.shader_error);
    harness.panels.click("close shader error");
    EXPECT_TRUE(harness.closed.shader_error);
}

TEST(MessagesPanel, IsAsHighAsAShortErrorNeeds) {
    MessageHarness harness;
    harness.messages.scene_error = "a:1:1: b";
    const WidgetRectangle r = harness.rectangle("message scene error");
    EXPECT_LT(r.bottom - r.top, 6.0F * ImGui::GetFontSize());
}

TEST(MessagesPanel, SurvivesATinyArea) {
    MessageHarness harness;
    harness.messages = {"Saved", "a:1:1: b", lines(3)};
    harness.area = {0.0F, 0.0F, 0.0F, 0.0F};
    harness.panels.frames(4);
    EXPECT_GT(harness.panels.vertices(), 0);
}

}  // namespace sphereview
