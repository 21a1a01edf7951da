// File > Export film: the dialog, and the film's job beside the window's loop.
#pragma once

#include <string>

#include "panels/film_form.hpp"

namespace sphereview {

struct ViewerState;
struct FilmRequest;

// Asks for a file, a size and the rest; asks before it overwrites.
void ask_for_film(ViewerState& state);

// The request for a film of the present view with these choices at `path`, or for pictures if `path` has {frame}. Throws InputError
// for impossible choices.
FilmRequest film_request(ViewerState& state, const FilmForm& form, const std::string& path, PictureSize size);

// Begins to make the film; no other may be in progress.
void start_film(ViewerState& state, const FilmRequest& request);

// Cancels. A film leaves nothing, written pictures stay. A job that has ended already is left to finish_work().
void cancel_film(ViewerState& state);

}  // namespace sphereview
