// What is chosen of a film before it is exported: below the files of its dialog.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "camera/turntable.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// As a person says it; a window remembers it for the next film.
struct FilmChoices {
    bool takes_frames = true;
    std::string frames = "all";  // as `--frames` says it
    bool turns = false;
    std::int64_t turntable = 360;  // pictures of a whole turn
    TurnAxis axis = TurnAxis::up;
    int samples = 1;  // points a pixel
    std::string rate = "30";
    int quality = 75;  // 1 to 100
    bool transparent = false;
    bool marks = false;

    bool operator==(const FilmChoices&) const = default;
};

// What becomes of them under a name.
struct FilmJudgement {
    std::string summary;  // "1,000 pictures, a film of 33.3 s"
    std::string fault;    // why that cannot be; "" if it can
    bool is_film = true;  // and not several pictures: these have no rate
    bool has_quality = false;
    bool has_alpha = false;
};

struct FilmForm {
    FilmChoices chosen;
    std::int64_t frames = 1;  // of the scene's file; of one that has no others only a turntable is made
    bool counting = false;    // the file may have more frames: it is still looked through
    std::string marks;        // what the window shows over its picture: "axes and scale bar"; "" for nothing
    std::string from_file;    // what the pictures show, in a line: where the file's frames are rendered
    std::string from_window;  // and where it is the scene in the window
    std::function<FilmJudgement(const FilmForm& form, const std::string& path)> judge;
    // Notes how many frames are known by now; whether these are others than before.
    std::function<bool(FilmForm& form)> refresh = [](FilmForm&) { return false; };

    // What the form remembers from redraw to redraw: the judgement, and of what it is.
    FilmJudgement judged;
    std::optional<FilmChoices> judged_choices;
    std::string judged_path;

    bool takes_frames() const { return frames > 1 && chosen.takes_frames; }
    bool turns() const { return frames == 1 || chosen.turns; }
};

// Judges the form anew, if it has changed, frames were found, or the film is to go to another path.
void judge(FilmForm& form, const std::string& path);

// Where in the dialog its fields begin, behind the labels: those of the size as well.
float left_of_film_fields();

// Draws the form, below the size. Widgets: "film takes frames", "film frames", "film turns", "film turntable", "film axis",
// "film axis x", "film samples", "film samples 4", "film rate", "film quality", "film transparent", "film marks".
void draw_film_form(const PanelContext& context, FilmForm& form);
// What becomes of what is chosen, in a line: "film summary".
void draw_film_summary(const PanelContext& context, const FilmForm& form);

}  // namespace sphereview
