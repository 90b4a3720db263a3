#include "app/levelc_commands.h"
#include "app/levelc_flight.h"
#include "app/levelc_support.h"
#include "core/level/bounds.h"
#include "editor/canvas/export_picture.h"
#include "editor/canvas/overlay_table.h"
#include "editor/canvas/stage.h"

#include <QPainter>
#include <QRegularExpression>

namespace spacetow {

namespace {

std::optional<QSize> sizeFromText(const QString& text) {
    constexpr int largest = largestPicture;
    static const QRegularExpression pattern(QStringLiteral("^(\\d{1,5})x(\\d{1,5})$"));
    const QRegularExpressionMatch match = pattern.match(text);
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    const bool usable = size.width() > 0 && size.height() > 0 && size.width() <= largest && size.height() <= largest;
    return match.hasMatch() && usable ? std::optional(size) : std::nullopt;
}

std::optional<OverlayFlags> overlaysFromText(const QString& text) {
    OverlayFlags flags;
    for (const QString& name : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const std::optional<OverlayFlags> more = withOverlay(flags, name.toStdString());
        if (!more) {
            return {};
        }
        flags = *more;
    }
    return flags;
}

QString overlayNames() {
    QStringList names;
    for (const OverlayRow& row : overlayRows()) {
        if (!row.ofRuns) {
            names.append(QLatin1String(row.name));
        }
    }
    return names.join(QLatin1Char(','));
}

struct Picture {
    const Level& level;
    QSize size;
    OverlayFlags overlays;
    std::optional<Flight> flight;
};

PictureSpec specOf(const Picture& picture) {
    PictureSpec spec;
    spec.view.size = Vec2(picture.size.width(), picture.size.height());
    spec.view = spec.view.showing(boundsOf(picture.level));
    spec.overlays = picture.overlays;
    spec.title = QString::fromStdString(picture.level.name);
    return spec;
}

void paint(QPainter& painter, const Picture& picture, const PictureSpec& spec) {
    if (!picture.flight) {
        paintPicture(painter, picture.level, spec);
        return;
    }
    const Theme& theme = canvasTheme();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRect(QPoint(0, 0), picture.size), theme.background);
    paintFlight(Stage{painter, spec.view, theme}, *picture.flight, picture.overlays);
}

/// Nothing after complaining, or when no replay is named.
std::optional<Flight> wantedFlight(const Level& level, const QString& file) {
    if (file.isEmpty()) {
        return {};
    }
    const Result<Replay> replay = readReplay(toPath(file), Sources::Any);
    if (!replay) {
        complain(file, replay.error());
        return {};
    }
    return flown(level, replay.value());
}

int write(const QString& file, const Picture& picture) {
    const std::optional<PictureFormat> format = pictureFormat(file);
    if (!format) {
        complain(QStringLiteral("the picture must be named *.png or *.svg"));
        return exit_status::unusable;
    }
    const PictureSpec spec = specOf(picture);
    const QByteArray bytes = pictureBytes(*format, spec, [&](QPainter& painter) { paint(painter, picture, spec); });
    if (bytes.isEmpty()) {
        complain(QStringLiteral("the picture is too large to be drawn"));
        return exit_status::unusable;
    }
    return writeOut(file, {bytes.data(), static_cast<std::size_t>(bytes.size())}) ? exit_status::good
                                                                                  : exit_status::unusable;
}

} // namespace

int renderCommand(const QStringList& arguments) {
    CommandLine line(QStringLiteral("render"), QStringLiteral("Draws a level as a PNG or SVG picture."));
    line.parser.addOption(
        {{QStringLiteral("o"), QStringLiteral("output")}, QStringLiteral("Picture to write."), QStringLiteral("OUT")});
    line.parser.addOption({QStringLiteral("size"), QStringLiteral("Size in pixels; 1600x1200 unless told."),
                           QStringLiteral("WxH"), QStringLiteral("1600x1200")});
    line.parser.addOption(
        {QStringLiteral("overlays"), QStringLiteral("Any of %1.").arg(overlayNames()), QStringLiteral("LIST")});
    line.parser.addOption({QStringLiteral("replay"),
                           QStringLiteral("Draws the end of a recorded flight, and the way that led there."),
                           QStringLiteral("REPLAY")});
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level file."), QStringLiteral("FILE"));
    if (!line.read(arguments, 1, 1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const auto size = sizeFromText(line.parser.value(QStringLiteral("size")));
    const auto overlays = overlaysFromText(line.parser.value(QStringLiteral("overlays")));
    const QString output = line.parser.value(QStringLiteral("output"));
    if (!size || !overlays || output.isEmpty()) {
        complain(!size       ? QStringLiteral("--size needs width and height in pixels, such as 1600x1200")
                 : !overlays ? QStringLiteral("--overlays has a name that is not known; see levelc render --help")
                             : QStringLiteral("the picture to write is missing: -o OUT.png or -o OUT.svg"));
        return exit_status::unusable;
    }
    const std::optional<Level> level = loadedLevel(line.parser.positionalArguments().front());
    if (!level) {
        return exit_status::unusable;
    }
    const QString replay = line.parser.value(QStringLiteral("replay"));
    Picture picture{*level, *size, *overlays, wantedFlight(*level, replay)};
    return replay.isEmpty() || picture.flight ? write(output, picture) : exit_status::unusable;
}

} // namespace spacetow
