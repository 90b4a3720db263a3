#include "core/base/expression_tokens.h"

#include "core/base/codes.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace spacetow {

namespace {

struct Spelling {
    std::string_view typed;
    std::string_view meant;
};

constexpr std::array spellings{
    Spelling{"×", "*"},      Spelling{"·", "*"},     Spelling{"÷", "/"},      Spelling{"−", "-"},
    Spelling{"–", "-"},      Spelling{"²", "^2"},    Spelling{"³", "^3"},     Spelling{"٫", "."},
    Spelling{"μ", "µ"},      Spelling{"٪", "%"},     Spelling{"\u00a0", " "}, Spelling{"\u202f", " "},
    Spelling{"\u2009", " "}, Spelling{"\u200e", ""}, Spelling{"\u200f", ""},  Spelling{"\u061c", ""}};

std::string plain(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const auto found =
            std::ranges::find_if(spellings, [text](const Spelling& s) { return text.starts_with(s.typed); });
        if (found != spellings.end()) {
            out += found->meant;
            text.remove_prefix(found->typed.size());
        } else {
            out += text.front();
            text.remove_prefix(1);
        }
    }
    return out;
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isDecimalSign(char c) {
    return c == '.' || c == ',';
}

/// Letters, and every byte of a character beyond ASCII.
bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

std::size_t digitsAt(std::string_view text, std::size_t at) {
    std::size_t count = 0;
    while (at + count < text.size() && isDigit(text[at + count])) {
        ++count;
    }
    return count;
}

/// The characters of the number that the text starts with; 0 for a lone decimal sign.
std::size_t numberLength(std::string_view text) {
    std::size_t length = digitsAt(text, 0);
    bool anyDigit = length > 0;
    if (length < text.size() && isDecimalSign(text[length])) {
        const std::size_t decimals = digitsAt(text, length + 1);
        anyDigit = anyDigit || decimals > 0;
        length += 1 + decimals;
    }
    if (!anyDigit) {
        return 0;
    }
    if (length < text.size() && (text[length] == 'e' || text[length] == 'E')) {
        const bool hasSign = length + 1 < text.size() && (text[length + 1] == '-' || text[length + 1] == '+');
        const std::size_t start = length + 1 + (hasSign ? 1 : 0);
        const std::size_t digits = digitsAt(text, start);
        length = digits > 0 ? start + digits : length;
    }
    return length;
}

/// Of the character of the text at `at`, in bytes.
std::size_t characterLength(std::string_view text, std::size_t at) {
    std::size_t length = 1;
    while (at + length < text.size() && (static_cast<unsigned char>(text[at + length]) & 0xc0U) == 0x80U) {
        ++length;
    }
    return length;
}

std::size_t nameLength(std::string_view text) {
    if (text.front() == '%' || text.starts_with("°")) {
        return characterLength(text, 0);
    }
    std::size_t length = 0;
    while (length < text.size() && (isLetter(text[length]) || (length > 0 && isDigit(text[length])))) {
        if (text.substr(length).starts_with("°")) {
            break;
        }
        ++length;
    }
    return length;
}

Result<Token> numberToken(std::string_view spelled) {
    std::string digits(spelled);
    std::ranges::replace(digits, ',', '.');
    Token token{Token::Kind::Number, 0, std::string(spelled)};
    const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), token.number);
    if (failure == std::errc::result_out_of_range) {
        const std::size_t exponent = digits.find_first_of("eE");
        if (exponent == std::string::npos || digits[exponent + 1] != '-') {
            return Error{BaseCode("expression-not-finite"), {}};
        }
        token.number = 0; // too small for a double
    }
    return token;
}

} // namespace

Result<std::vector<Token>> expressionTokens(std::string_view typed) {
    const std::string all = plain(typed);
    std::string_view text = all;
    std::vector<Token> tokens;
    while (!text.empty()) {
        const char first = text.front();
        std::size_t length = 1;
        if (first == ' ' || first == '\t' || first == '\n' || first == '\r') {
            text.remove_prefix(1);
            continue;
        }
        if (isDigit(first) || isDecimalSign(first)) {
            length = numberLength(text);
            if (length == 0) {
                return Error{BaseCode("expression-unexpected"), {std::string(1, first)}};
            }
            Result<Token> token = numberToken(text.substr(0, length));
            if (!token) {
                return token.error();
            }
            tokens.push_back(std::move(token).value());
        } else if (isLetter(first) || first == '%') {
            length = nameLength(text);
            tokens.push_back({Token::Kind::Name, 0, std::string(text.substr(0, length))});
        } else if (std::string_view("+-*/^();=").find(first) != std::string_view::npos) {
            tokens.push_back({Token::Kind::Sign, 0, std::string(1, first)});
        } else {
            return Error{BaseCode("expression-unexpected"), {std::string(text.substr(0, characterLength(text, 0)))}};
        }
        text.remove_prefix(length);
    }
    tokens.emplace_back();
    return tokens;
}

} // namespace spacetow
