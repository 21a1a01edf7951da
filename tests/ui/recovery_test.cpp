// Ends that nobody asked for: unsaved changes are kept and offered at the next start.
#include <gtest/gtest.h>

#include <csignal>

#include "support/text_match.hpp"
#include "ui/file_steps.hpp"

namespace sphereview::test {

TEST(Recovery, OffersTheChangesOfALostDisplay) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    {
        ViewerWindow window(folder, {scene});
        edit(window);
        window.server().kill();
        const Outcome outcome = window.wait_for_end();
        EXPECT_EQ(outcome.status, 3) << outcome;
        ASSERT_EQ(lines(outcome.errors).size(), 1u) << outcome;
        EXPECT_TRUE(contains(outcome.errors, "sphereview render"));
        EXPECT_TRUE(contains(outcome.errors, "doctor"));
        EXPECT_TRUE(contains(outcome.errors, "unsaved changes of scene.txt are kept"));
        EXPECT_EQ(folder.read("scene.txt"), one_sphere);
    }
    {
        ViewerWindow window(folder, {});
        answer(window, "recover", "Recover");
        window.wait_for("spheres", 2);
        EXPECT_EQ(window.frame().at("path"), scene);
        EXPECT_EQ(window.frame().at("changed"), true);
        window.key("ctrl+s");
        announced(window, "Saved " + scene);
        EXPECT_EQ(lines(folder.read("scene.txt")).front(), "2");
        window.press_close_button();
        EXPECT_EQ(window.wait_for_end().status, 0);
    }
    ViewerWindow window(folder, {scene});
    EXPECT_EQ(window.frame().at("dialogs"), Json::array());
}

TEST(Recovery, OffersTheChangesOfATerminatedWindowUntilTheyAreDiscarded) {
    const TemporaryFolder folder;
    {
        ViewerWindow window(folder, {});
        edit(window);
        window.send(SIGTERM);
        EXPECT_EQ(window.wait_for_end().status, 143);
    }
    {
        ViewerWindow window(folder, {});
        answer(window, "recover", "Later");
        wait_for_no_dialogs(window);
        window.send(SIGTERM);  // nothing new to keep
        EXPECT_EQ(window.wait_for_end().errors, "");
    }
    {
        ViewerWindow window(folder, {});
        answer(window, "recover", "Discard");
        wait_for_no_dialogs(window);
        EXPECT_EQ(window.frame().at("spheres"), 0);
        window.press_close_button();
        EXPECT_EQ(window.wait_for_end().status, 0);
    }
    ViewerWindow window(folder, {});
    EXPECT_EQ(window.frame().at("dialogs"), Json::array());
}

}  // namespace sphereview::test
