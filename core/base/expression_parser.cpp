#include "core/base/expression_parser.h"

#include "core/base/codes.h"
#include "core/base/decimal.h"
#include "core/base/expression_functions.h"

#include <array>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr int deepest = 64; // parentheses, signs and powers within each other

std::optional<Quantity> constantNamed(std::string_view name) {
    if (name == "pi" || name == "Pi" || name == "PI" || name == "π") {
        return plainNumber(std::numbers::pi);
    }
    if (name == "tau") {
        return plainNumber(2 * std::numbers::pi);
    }
    return name == "e" ? std::optional(plainNumber(std::numbers::e)) : std::nullopt;
}

/// Recursive descent. After the first error nothing that is answered counts.
class Parser {
  public:
    Parser(std::span<const Token> tokens, const ExpressionReading& reading) : m_tokens(tokens), m_reading(reading) {}

    Result<Quantity> whole() {
        if (next().kind == Token::Kind::End) {
            return Error{BaseCode("expression-empty"), {}};
        }
        const Quantity value = sum();
        if (!m_error && next().kind != Token::Kind::End) {
            unexpected();
        }
        return m_error ? Result<Quantity>(std::move(*m_error)) : Result<Quantity>(value);
    }

  private:
    const Token& next() const { return m_tokens[m_at]; }
    bool isNext(char sign) const { return next().kind == Token::Kind::Sign && next().text.front() == sign; }
    bool took(char sign) {
        const bool is = isNext(sign);
        m_at += is ? 1 : 0;
        return is;
    }
    void fail(BaseCode code, std::vector<std::string> arguments = {}) {
        if (!m_error) {
            m_error = Error{code, std::move(arguments)};
        }
    }
    void unexpected() {
        if (next().kind == Token::Kind::End) {
            fail("expression-unfinished");
        } else {
            fail("expression-unexpected", {next().text});
        }
    }

    Quantity sum() {
        Quantity value = product();
        while (!m_error && (isNext('+') || isNext('-'))) {
            const bool minus = took('-');
            if (!minus) {
                ++m_at;
            }
            Quantity more = product();
            more.number = minus ? -more.number : more.number;
            value = added(value, more);
        }
        return value;
    }

    Quantity product() {
        Quantity value = factor();
        while (!m_error) {
            if (took('*')) {
                value = value * factor();
            } else if (took('/')) {
                const Quantity by = factor();
                if (!m_error && by.number == 0) {
                    fail("expression-divided-by-zero");
                }
                value = value / by;
            } else if (nextIsUnit()) {
                value = value * poweredUnit();
            } else {
                break;
            }
        }
        return value;
    }

    Quantity factor() {
        if (isNext('+') || isNext('-')) {
            const double sign = took('-') ? -1 : (++m_at, 1);
            Quantity value = nested([this] { return factor(); });
            value.number *= sign;
            return value;
        }
        Quantity value = power();
        while (!m_error && m_reading.binding == UnitBinding::ToFactor && nextIsUnit()) {
            value = value * poweredUnit();
        }
        return value;
    }

    Quantity power() {
        Quantity value = atom();
        return !m_error && took('^') ? raised(value, exponent()) : value;
    }

    Quantity exponent() {
        return nested([this] {
            const bool minus = took('-');
            Quantity value = power();
            value.number = minus ? -value.number : value.number;
            return value;
        });
    }

    bool nextIsUnit() const {
        return next().kind == Token::Kind::Name && unitNamed(next().text).has_value() && !isCall();
    }
    bool isCall() const {
        return m_at + 1 < m_tokens.size() && m_tokens[m_at + 1].kind == Token::Kind::Sign &&
               m_tokens[m_at + 1].text == "(" && isFunction(next().text);
    }

    Quantity poweredUnit() {
        const Quantity unit = unitNamed(m_tokens[m_at++].text).value_or(Quantity());
        return took('^') ? raised(unit, exponent()) : unit;
    }

    Quantity atom() {
        const Token& token = next();
        if (token.kind == Token::Kind::Number) {
            ++m_at;
            return plainNumber(token.number);
        }
        if (token.kind == Token::Kind::Name) {
            return named();
        }
        if (took('(')) {
            const Quantity value = nested([this] { return sum(); });
            close();
            return value;
        }
        unexpected();
        return {};
    }

    Quantity named() {
        if (isCall()) {
            return call();
        }
        const std::string& name = next().text;
        const std::optional<Quantity> constant = constantNamed(name);
        const std::optional<Quantity> value = constant ? constant : unitNamed(name);
        if (!value) {
            fail("expression-unknown", {name});
        }
        ++m_at;
        return value.value_or(Quantity());
    }

    Quantity call() {
        const std::string name = next().text;
        m_at += 2;
        std::vector<Quantity> arguments;
        do {
            arguments.push_back(nested([this] { return sum(); }));
        } while (!m_error && took(';'));
        close();
        if (m_error) {
            return {};
        }
        const Result<Quantity> value = functionValue(name, arguments);
        if (!value) {
            fail(BaseCode(value.error().code), value.error().arguments);
            return {};
        }
        return value.value();
    }

    void close() {
        if (m_error || took(')')) {
            return;
        }
        if (next().kind == Token::Kind::End) {
            fail("expression-unclosed");
        } else {
            unexpected();
        }
    }

    template <class Parse>
    Quantity nested(Parse parse) {
        if (m_depth >= deepest) {
            fail("expression-too-deep");
            return {};
        }
        ++m_depth;
        const Quantity value = parse();
        --m_depth;
        return value;
    }

    Quantity added(Quantity a, Quantity b) {
        const Dimension& wanted = m_reading.plainUnit.dimension;
        if (a.dimension.isNone() && b.dimension == wanted) {
            a = wanted.isNone() ? a : a * m_reading.plainUnit;
        } else if (b.dimension.isNone() && a.dimension == wanted) {
            b = b * m_reading.plainUnit;
        }
        if (!(a.dimension == b.dimension)) {
            fail("expression-units-differ");
            return {};
        }
        if (a.over == b.over && a.under == b.under) {
            a.number = decimalSum(a.number, b.number);
            return a;
        }
        return {decimalSum(a.si(), b.si()), 1, 1, a.dimension};
    }

    Quantity raised(const Quantity& base, const Quantity& by) {
        if (m_error) {
            return {};
        }
        const double n = by.si();
        if (!by.dimension.isNone() || (!base.dimension.isNone() && (n != std::floor(n) || std::abs(n) > 8))) {
            fail("expression-units-differ");
            return {};
        }
        if (base.dimension.isNone() && base.over == base.under) {
            return finite(std::pow(base.number, n));
        }
        Quantity value = plainNumber(1);
        for (int i = 0; i < std::abs(static_cast<int>(n)); ++i) {
            value = n > 0 ? value * base : value / base;
        }
        return value;
    }

    Quantity finite(double number) {
        if (!std::isfinite(number)) {
            fail("expression-not-finite");
        }
        return plainNumber(number);
    }

    std::span<const Token> m_tokens;
    const ExpressionReading& m_reading;
    std::size_t m_at = 0;
    int m_depth = 0;
    std::optional<Error> m_error;
};

} // namespace

Result<Quantity> parsedExpression(std::span<const Token> tokens, const ExpressionReading& reading) {
    return Parser(tokens, reading).whole();
}

} // namespace spacetow
