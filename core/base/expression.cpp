#include "core/base/expression.h"

#include "core/base/codes.h"
#include "core/base/decimal.h"
#include "core/base/expression_parser.h"
#include "core/base/expression_tokens.h"

#include <array>
#include <cmath>
#include <span>
#include <string>

namespace spacetow {

namespace {

constexpr std::size_t longest = 1000; // characters

/// A unit is an expression of units; none for the empty one.
Quantity unitOf(std::string_view unit) {
    if (unit.empty()) {
        return plainNumber(1);
    }
    const Result<std::vector<Token>> tokens = expressionTokens(unit);
    EXPECTS(static_cast<bool>(tokens));
    const Result<Quantity> parsed = parsedExpression(tokens.value(), {UnitBinding::ToProduct, plainNumber(1)});
    EXPECTS(static_cast<bool>(parsed));
    return parsed.value();
}

Error wrongUnit(std::string_view unit) {
    return unit.empty() ? Error{BaseCode("expression-needs-no-unit"), {}}
                        : Error{BaseCode("expression-wrong-unit"), {std::string(unit)}};
}

Result<double> finite(double number) {
    return std::isfinite(number) ? Result<double>(number)
                                 : Result<double>(Error{BaseCode("expression-not-finite"), {}});
}

Result<double> evaluatedTokens(std::span<const Token> tokens, std::string_view unit) {
    const Quantity wanted = unitOf(unit);
    const std::array readings{parsedExpression(tokens, {UnitBinding::ToFactor, wanted}),
                              parsedExpression(tokens, {UnitBinding::ToProduct, wanted})};
    for (const Result<Quantity>& reading : readings) {
        if (reading && reading.value().dimension == wanted.dimension && !wanted.dimension.isNone()) {
            return finite(reading.value().in(wanted));
        }
    }
    for (const Result<Quantity>& reading : readings) {
        if (reading && reading.value().dimension.isNone()) {
            const Quantity& value = reading.value();
            const bool isInUnit =
                value.over == wanted.over && value.under == wanted.under; // as 50% where % is the unit
            return finite(isInUnit ? value.number : value.si());
        }
    }
    return readings[0] ? wrongUnit(unit) : readings[0].error();
}

Result<std::vector<Token>> tokensOf(std::string_view text) {
    return text.size() > longest ? Error{BaseCode("expression-too-deep"), {}} : expressionTokens(text);
}

bool isSign(const Token& token, char sign) {
    return token.kind == Token::Kind::Sign && token.text.front() == sign;
}

} // namespace

Result<double> evaluated(std::string_view text, std::string_view unit) {
    const Result<std::vector<Token>> tokens = tokensOf(text);
    return tokens ? evaluatedTokens(tokens.value(), unit) : tokens.error();
}

Result<NumberChange> numberChange(std::string_view text, std::string_view unit) {
    using Kind = NumberChange::Kind;
    const Result<std::vector<Token>> tokens = tokensOf(text);
    if (!tokens) {
        return tokens.error();
    }
    std::span<const Token> rest = tokens.value();
    NumberChange change;
    if (rest.size() > 1 && isSign(rest[1], '=')) {
        constexpr std::array signs{std::pair('+', Kind::Add), std::pair('-', Kind::Subtract),
                                   std::pair('*', Kind::Multiply), std::pair('/', Kind::Divide)};
        for (const auto& [sign, kind] : signs) {
            if (isSign(rest[0], sign)) {
                change.kind = kind;
                rest = rest.subspan(2);
                break;
            }
        }
    }
    const bool isFactor = change.kind == Kind::Multiply || change.kind == Kind::Divide;
    const Result<double> operand = evaluatedTokens(rest, isFactor ? std::string_view() : unit);
    if (!operand) {
        return operand.error();
    }
    change.operand = operand.value();
    if (change.kind == Kind::Divide && change.operand == 0) {
        return Error{BaseCode("expression-divided-by-zero"), {}};
    }
    return change;
}

double applied(const NumberChange& change, double number) {
    switch (change.kind) {
    case NumberChange::Kind::Add:
        return decimalSum(number, change.operand);
    case NumberChange::Kind::Subtract:
        return decimalSum(number, -change.operand);
    case NumberChange::Kind::Multiply:
        return number * change.operand;
    case NumberChange::Kind::Divide:
        return number / change.operand;
    case NumberChange::Kind::Set:
        break;
    }
    return change.operand;
}

} // namespace spacetow
