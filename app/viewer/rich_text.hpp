// Lesson text: blocks of styled spans, wrapped word by word.
#pragma once

#include "app/lesson/document.hpp"
#include "app/viewer/theme.hpp"

namespace hs::viewer {

void draw_document(const Theme& theme, const lesson::Document& document);

} // namespace hs::viewer
