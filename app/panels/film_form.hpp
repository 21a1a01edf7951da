// The form for a film, below the files of its dialog.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "camera/turntable.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// The person's choices, which the window remembers for the next film.
struct FilmChoices {
    bool takes_frames = true;
    std::string frames = "all";  // in the syntax of `--frames`
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

// The judgement of a form and a path.
struct FilmJudgement {
    std::string summary;  // "1,000 pictures, a film of 33.3 s"
    std::string fault;    // why there can be no such film; "" if there can
    bool is_film = true;  // else several pictures, which have no rate
    bool has_quality = false;
    bool has_alpha = false;
};

struct FilmForm {
    FilmChoices chosen;
    std::int64_t frames = 1;  // of the scene's file; 1: a turntable alone is possible
    bool counting = false;    // frames are still being counted
    std::string marks;        // the window's marks: "axes and scale bar"; "" for none
    std::string from_file;    // a line about the pictures of the file's frames
    std::string from_window;  // a line about the pictures of the scene in the window
    std::function<FilmJudgement(const FilmForm& form, const std::string& path)> judge;
    // Updates the number of known frames; whether it has changed.
    std::function<bool(FilmForm& form)> refresh = [](FilmForm&) { return false; };

    // The last judgement, and the choices and path that it is of.
    FilmJudgement judged;
    std::optional<FilmChoices> judged_choices;
    std::string judged_path;

    bool takes_frames() const { return frames > 1 && chosen.takes_frames; }
    bool turns() const { return frames == 1 || chosen.turns; }
};

// Judges the form again if choices, known frames or the path have changed.
void judge(FilmForm& form, const std::string& path);

// Where fields begin in the dialog, behind the labels; also those of the size.
float left_of_film_fields();

// Draws the form, below the size. Widgets: "film takes frames", "film frames", "film turns", "film turntable", "film axis",
// "film axis x", "film samples", "film samples 4", "film rate", "film quality", "film transparent", "film marks".
void draw_film_form(const PanelContext& context, FilmForm& form);
// Draws the judgement in a line. Widget: "film summary".
void draw_film_summary(const PanelContext& context, const FilmForm& form);

}  // namespace sphereview
