// Mathematics as text: signs of the font, numbers with the digits that matter, lines broken at spaces alone.
#pragma once

#include <imgui.h>

#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace sphereview {

// Significant digits of numbers in lists; a tooltip shows all.
inline constexpr int digits_that_matter = 6;

// UTF-8 `text` with ASCII for the signs that ImGui's current font lacks: "√" as "sqrt", "²" as "^2", "·" as ".", "t₁" as "t1".
std::string in_glyphs(std::string_view text);

// The program's ASCII mathematics with proper signs: "n·L", "t₁", "r²", "a − b".
std::string typeset(std::string_view ascii);

// "−63670.2", "1.25 × 10⁻⁷" (for in_glyphs()): digits before the point are never left out of a number that is not written with a
// power of ten, zeros behind it always.
std::string number_text(double value, int digits = digits_that_matter);
// "(54.5564, 44.8335, 270.802)"
std::string vector_text(const glm::dvec3& v, int digits = digits_that_matter);

// The fewest digits, from digits_that_matter to 17, that tell two different numbers apart.
int digits_to_tell(double a, double b);

// Draws the text, after in_glyphs(), on as many lines as the window's width needs; a line ends only where the text has a space. The
// mouse over the text shows `on_hover`, if given. Makes one item of ImGui's.
void draw_words(std::string_view text, std::string_view on_hover = "");
void draw_colored_words(std::string_view text, const ImVec4& color, std::string_view on_hover = "");
void draw_dim_words(std::string_view text);

}  // namespace sphereview
