// File > Export film: what is asked, and what becomes of it beside the window's loop.
#pragma once

#include <string>

#include "panels/film_form.hpp"

namespace sphereview {

struct ViewerState;
struct FilmRequest;

// Asks for a file, a size and the rest, and before it overwrites.
void ask_for_film(ViewerState& state);

// What is to be made of the view as it is now, of these choices, at `path`: a film's, or pictures' with {frame}. Throws InputError
// for choices that cannot be.
FilmRequest film_request(ViewerState& state, const FilmForm& form, const std::string& path, PictureSize size);

// Begins to make it; none may be on its way.
void start_film(ViewerState& state, const FilmRequest& request);

// Nothing is left of a film; of pictures those that are written. What has ended already is left to finish_work().
void cancel_film(ViewerState& state);

}  // namespace sphereview
