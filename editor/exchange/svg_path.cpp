#include "editor/exchange/svg_path.h"

#include "editor/exchange/svg_arc.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace spacetow {

namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

class PathReader {
  public:
    explicit PathReader(std::string_view text) : m_scanner(text) {}

    PathReading read() {
        char command = 0;
        for (m_scanner.skip(); !m_scanner.atEnd() && m_out.whole; m_scanner.skip()) {
            if (isLetter(m_scanner.peek())) {
                command = m_scanner.take();
            } else if (command == 0 || command == 'Z' || command == 'z') {
                m_out.whole = false;
                break;
            } else if (command == 'M' || command == 'm') {
                command = command == 'M' ? 'L' : 'l'; // further points of a move are lines
            }
            const bool moves = command == 'M' || command == 'm';
            m_out.whole = (m_begun || moves) && run(command);
            m_begun = true;
        }
        endPath(false);
        return std::move(m_out);
    }

  private:
    bool run(char command) {
        m_relative = command >= 'a';
        switch (std::toupper(static_cast<unsigned char>(command))) {
        case 'M':
            return moveTo();
        case 'L':
            return lineTo();
        case 'H':
        case 'V':
            return lineAlong(command == 'H' || command == 'h' ? 0 : 1);
        case 'C':
            return cubicTo(false);
        case 'S':
            return cubicTo(true);
        case 'Q':
            return quadraticTo(false);
        case 'T':
            return quadraticTo(true);
        case 'A':
            return arcTo();
        case 'Z':
            endPath(true);
            return true;
        default:
            return false;
        }
    }

    template <std::size_t n>
    std::optional<std::array<double, n>> numbers() {
        std::array<double, n> values{};
        for (double& value : values) {
            const std::optional<double> number = m_scanner.number();
            if (!number) {
                return {};
            }
            value = *number;
        }
        return values;
    }
    std::optional<Vec2> point() {
        const auto xy = numbers<2>();
        return xy ? std::optional<Vec2>(Vec2((*xy)[0], (*xy)[1]) + origin()) : std::nullopt;
    }
    Vec2 origin() const { return m_relative ? m_at : Vec2(0, 0); }

    bool moveTo() {
        const std::optional<Vec2> to = point();
        if (to) {
            endPath(false);
            m_at = m_path.start = *to;
            m_open = true;
            forgetControls();
        }
        return to.has_value();
    }
    bool lineTo() {
        const std::optional<Vec2> to = point();
        if (to) {
            add(LinePiece{*to});
            forgetControls();
        }
        return to.has_value();
    }
    bool lineAlong(int axis) {
        const std::optional<double> value = m_scanner.number();
        if (value) {
            Vec2 to = m_at;
            to[axis] = *value + origin()[axis];
            add(LinePiece{to});
            forgetControls();
        }
        return value.has_value();
    }
    bool cubicTo(bool isSmooth) {
        const std::optional<Vec2> first = isSmooth ? reflected(m_cubicControl) : point();
        const std::optional<Vec2> second = first ? point() : std::nullopt;
        const std::optional<Vec2> to = second ? point() : std::nullopt;
        if (to) {
            add(CubicPiece{*first, *second, *to});
            forgetControls();
            m_cubicControl = second;
        }
        return to.has_value();
    }
    bool quadraticTo(bool isSmooth) {
        const std::optional<Vec2> control = isSmooth ? reflected(m_quadraticControl) : point();
        const std::optional<Vec2> to = control ? point() : std::nullopt;
        if (to) {
            add(CubicPiece{m_at + 2.0 / 3 * (*control - m_at), *to + 2.0 / 3 * (*control - *to), *to});
            forgetControls();
            m_quadraticControl = control;
        }
        return to.has_value();
    }
    bool arcTo() {
        const auto shape = numbers<3>();
        const std::optional<bool> large = shape ? m_scanner.flag() : std::nullopt;
        const std::optional<bool> sweep = large ? m_scanner.flag() : std::nullopt;
        const std::optional<Vec2> to = sweep ? point() : std::nullopt;
        if (to) {
            if (const auto piece = svgArc(m_at, *to, {(*shape)[0], (*shape)[1], (*shape)[2], *large, *sweep})) {
                add(*piece);
            }
            forgetControls();
        }
        return to.has_value();
    }
    /// The control point on the other side of where the path is; there itself when the last piece had none.
    std::optional<Vec2> reflected(const std::optional<Vec2>& control) const {
        return control ? Vec2(2 * m_at - *control) : m_at;
    }
    void forgetControls() {
        m_cubicControl.reset();
        m_quadraticControl.reset();
    }

    void add(PathPiece piece) {
        if (!m_open) { // after a Z: a new path that begins where the last one did
            m_path.start = m_at;
            m_open = true;
        }
        m_at = std::visit([](const auto& one) -> Vec2 { return one.to; }, piece);
        m_path.pieces.push_back(std::move(piece));
    }
    void endPath(bool isClosed) {
        if (m_open && (isClosed || !m_path.pieces.empty())) {
            m_path.closed = isClosed;
            m_at = isClosed ? m_path.start : m_at;
            const Vec2 start = m_path.start;
            m_out.paths.push_back(std::move(m_path));
            m_path = {start, {}, false};
        }
        m_open = false;
        forgetControls();
    }

    NumberScanner m_scanner;
    PathReading m_out;
    DrawnPath m_path;
    Vec2 m_at{0, 0};
    bool m_open = false;
    bool m_begun = false;
    bool m_relative = false;
    std::optional<Vec2> m_cubicControl, m_quadraticControl;
};

} // namespace

void NumberScanner::skip() {
    while (!m_rest.empty() && (isBlank(m_rest.front()) || m_rest.front() == ',')) {
        m_rest.remove_prefix(1);
    }
}

char NumberScanner::take() {
    const char c = m_rest.front();
    m_rest.remove_prefix(1);
    return c;
}

std::optional<double> NumberScanner::number() {
    skip();
    std::string_view text = m_rest;
    const bool isNegative = text.starts_with('-');
    if (isNegative || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    // What the library takes for a number besides, such as "inf", is none here.
    if (text.empty() || !(isDigit(text[0]) || (text[0] == '.' && text.size() > 1 && isDigit(text[1])))) {
        return {};
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) {
        return {};
    }
    m_rest.remove_prefix(static_cast<std::size_t>(end - m_rest.data()));
    return isNegative ? -value : value;
}

std::optional<bool> NumberScanner::flag() {
    skip();
    if (m_rest.empty() || (m_rest.front() != '0' && m_rest.front() != '1')) {
        return {};
    }
    return take() == '1';
}

std::string_view NumberScanner::word() {
    const auto end = std::ranges::find_if_not(m_rest, [](char c) { return isLetter(c) || c == '%'; });
    const auto size = static_cast<std::size_t>(end - m_rest.begin());
    const std::string_view found = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    return found;
}

PathReading readPathData(std::string_view text) {
    return PathReader(text).read();
}

PathReading readPointList(std::string_view text, bool closed) {
    NumberScanner scanner(text);
    std::vector<Vec2> points;
    for (;;) {
        const std::optional<double> x = scanner.number();
        const std::optional<double> y = x ? scanner.number() : std::nullopt;
        if (!y) {
            scanner.skip();
            PathReading out{{}, scanner.atEnd() && !x};
            if (!points.empty()) {
                out.paths.push_back(polygonPath(std::move(points), closed));
            }
            return out;
        }
        points.emplace_back(*x, *y);
    }
}

} // namespace spacetow
