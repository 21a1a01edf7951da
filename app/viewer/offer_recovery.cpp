#include "viewer/offer_recovery.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "viewer/recovery.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/scene_saving.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

void take_over(ViewerState& state, const Recovery& recovery) {
    // Now they are this process's to keep: until they are, their file stays.
    if (state.autosave.keep(state.document, edited_file(state))) remove_recovery(recovery.file);
    announce(state, "Recovered the unsaved changes of " + on_one_line(state.name()));
}

void recover_alone(ViewerState& state, const Recovery& recovery, LoadedScene kept) {
    const std::string& path = recovery.original.path;
    if (!path.empty()) kept.format = format_of_name(path);
    adopt(state, std::move(kept), path);
    state.document.mark_unsaved();
    take_over(state, recovery);
}

}  // namespace

void recover(ViewerState& state, const Recovery& recovery) {
    const auto accept = [&state, recovery](LoadedScene loaded) {
        const auto& [path, frame] = recovery.original;
        const FileStates stamp = file_states(path);
        if (!frame || edited_frame(stamp, frame->number, frame->has_numbers) != frame) {
            return recover_alone(state, recovery, std::move(loaded));
        }
        const auto kept = std::make_shared<LoadedScene>(std::move(loaded));
        const auto over_frame = [&state, recovery, kept, stamp](LoadedScene as_read) {
            adopt(state, std::move(as_read), recovery.original.path);
            state.frame = recovery.original.frame->number;
            state.stamp = state.read_stamp = stamp;
            apply_recovered(state, std::move(kept->scene), recovery.original.frame->has_numbers);
            take_over(state, recovery);
        };
        const auto alone = [&state, recovery, kept](const std::string&) { recover_alone(state, recovery, std::move(*kept)); };
        start_loading(state, {path, load_options(state, path, frame->number), over_frame, alone, [alone] { alone(""); }});
    };
    const auto fail = [&state](const std::string& why) { report_error(state, "The changes cannot be recovered", why); };
    start_loading(state, {.path = recovery.file, .accept = accept, .fail = fail});
}

void offer_recovery(ViewerState& state) {
    std::vector<Recovery> recoveries = list_recoveries();
    std::ranges::reverse(recoveries);  // the last question is asked first: of the latest changes
    for (const Recovery& recovery : recoveries) {
        Question question;
        question.id = "recover";
        question.title = "Recover unsaved changes?";
        question.text = in_words(recovery);
        question.answers = {"Recover", "Discard", "Later"};
        question.cancel = 2;
        question.answer = [&state, recovery](int answer) {
            // What was recovered before may not be saved yet.
            if (answer == 0) with_edits_safe(state, [&state, recovery] { recover(state, recovery); });
            if (answer == 1) remove_recovery(recovery.file);
        };
        state.dialogs.push_back(std::move(question));
    }
    if (const std::vector<std::string> unclear = unclear_recoveries(); !unclear.empty()) {
        const std::string others = unclear.size() > 1 ? " and " + in_groups(unclear.size() - 1) + " more" : "";
        say("sphereview: " + unclear.front() + others +
            ": these unsaved changes are not offered, because it cannot be told whether their window still runs; open them as "
            "scenes");
    }
}

}  // namespace sphereview
