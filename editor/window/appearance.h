#pragma once
// Light or dark: the program's style and palette, as the user prefers them or as the desktop has them. Changes take
// effect at once.

#include "editor/canvas/palette.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <optional>

class QDBusVariant;

namespace spacetow {

enum class Appearance : std::uint8_t { System, Light, Dark };

/// What the desktop says without being asked: the theme that was chosen for other programs, else the palette that the
/// toolkit took over from it.
Shade desktopShade(const QByteArray& gtkTheme, const QPalette& toolkit);

/// Dresses the whole application, for as long as it lives, and listens to the desktop.
class Wardrobe : public QObject {
    Q_OBJECT

  public:
    explicit Wardrobe(Appearance appearance);

    Appearance appearance() const { return m_appearance; }
    void setAppearance(Appearance appearance);
    Shade shade() const;

  private Q_SLOTS:
    void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

  private:
    void dress() const;
    void askDesktop();
    void desktopSays(unsigned scheme);

    Appearance m_appearance;
    std::optional<Shade> m_desktop; // by the desktop's own word
};

/// The one of all windows, as the preferences have it when the first of them opens.
std::shared_ptr<Wardrobe> wardrobe();

} // namespace spacetow
