// The README's tables of keys and mouse are the program's own.
#include <gtest/gtest.h>

#include "base/input_file.hpp"
#include "panels/commands.hpp"
#include "panels/help.hpp"
#include "support/folders.hpp"

namespace sphereview::test {
namespace {

std::string tables() {
    std::string text = "| mouse | what it does |\n| --- | --- |\n";
    for (const MouseHelp& row : mouse_help()) text += "| " + std::string(row.mouse) + " | " + std::string(row.help) + " |\n";
    text += "\n| key | what it does |\n| --- | --- |\n";
    for (const CommandInfo& command : all_commands()) {
        if (command.shortcut.empty()) continue;
        text += "| " + every_shortcut(command.shortcut) + " | " + std::string(command.label) + ": " + std::string(command.help) +
                " |\n";
    }
    return text;
}

}  // namespace

TEST(Readme, HasTheTablesOfKeysAndMouse) {
    const InputFile readme(source_file("README.md"));
    EXPECT_NE(readme.bytes().find(tables()), std::string_view::npos) << "expected in README.md:\n" << tables();
}

}  // namespace sphereview::test
