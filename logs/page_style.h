#pragma once

#include <string>

namespace citrine::logs {

/// The beginning of a page that needs nothing from outside, to the headline and with it; light or dark as the
/// reader has it.
std::string PageHead(const std::string& title);

/// The styles of the parts of figures.
std::string SvgStyle();

}  // namespace citrine::logs
