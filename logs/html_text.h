#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace citrine::logs {

/// Text as it may stand between tags and in quoted attributes.
std::string Escape(const std::string& text);

/// RFC 4648, with padding.
std::string Base64(const std::vector<std::uint8_t>& bytes);

}  // namespace citrine::logs
