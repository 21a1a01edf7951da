// Ends that nobody asked for: unsaved changes are kept and offered at the next start.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

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

// Waits until the running window has kept its changes, or has forgotten them.
void wait_for_kept(ViewerWindow& window, const TemporaryFolder& folder, bool kept) {
    window.wait_until(kept ? "changes that are kept" : "no changes that are kept", [&](const Json&) {
        const std::string state = folder.path("home/state/sphereview");
        return kept == (std::filesystem::exists(state) && !std::filesystem::is_empty(state));
    });
}

TEST(Recovery, OffersTheChangesOfAKilledWindow) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    {
        ViewerWindow window(folder, {scene});
        edit(window);
        wait_for_kept(window, folder, true);
        window.send(SIGKILL);
        window.wait_for_end();
    }
    for (int i = 0; i < 2; ++i) {  // what was recovered is not lost either
        ViewerWindow window(folder, {});
        answer(window, "recover", "Recover");
        window.wait_for("spheres", 2);
        window.send(SIGKILL);
        window.wait_for_end();
    }
    ViewerWindow window(folder, {});
    answer(window, "recover", "Recover");
    window.wait_for("spheres", 2);
    window.key("ctrl+s");
    announced(window, "Saved " + scene);
    wait_for_kept(window, folder, false);
    window.send(SIGKILL);
    window.wait_for_end();
    ViewerWindow last(folder, {});
    EXPECT_EQ(last.frame().at("dialogs"), Json::array());
}

}  // namespace sphereview::test
