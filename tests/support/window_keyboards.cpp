#include "tests/support/keyboards.h"

#include <algorithm>
#include <iterator>

namespace spacetow::test {

const std::string_view usPlaces = "1234567890-=QWERTYUIOP[]ASDFGHJKL;'`\\ZXCVBNM,./";

namespace {

// clang-format off
const Keyboard all[] = {
    {"us", u"1234567890-=qwertyuiop[]asdfghjkl;'`\\zxcvbnm,./",
           u"!@#$%^&*()_+QWERTYUIOP{}ASDFGHJKL:\"~|ZXCVBNM<>?",
           u"                                               ", u""},
    {"de", u"1234567890ß´qwertzuiopü+asdfghjklöä^#yxcvbnm,.-",
           u"!\"§$%&/()=?`QWERTZUIOPÜ*ASDFGHJKLÖÄ°'YXCVBNM;:_",
           u"      {[]}\\ @          ~                       ", u"´`^"},
    {"fr", u"&é\"'(-è_çà)=azertyuiop^$qsdfghjklmù²*wxcvbn,;:!",
           u"1234567890°+AZERTYUIOP¨£QSDFGHJKLM%³µWXCVBN?./§",
           u" ~#{[|`\\^@]}                                   ", u"^¨"},
    {"ru", u"1234567890-=йцукенгшщзхъфывапролджэё\\ячсмитьбю.",
           u"!\"№;%:?*()_+ЙЦУКЕНГШЩЗХЪФЫВАПРОЛДЖЭЁ/ЯЧСМИТЬБЮ,",
           u"                                               ", u""},
    {"se", u"1234567890+´qwertyuiopå¨asdfghjklöä§'zxcvbnm,.-",
           u"!\"#¤%&/()=?`QWERTYUIOPÅ^ASDFGHJKLÖÄ½*ZXCVBNM;:_",
           u" @£$  {[]}\\           ~                        ", u"´`¨^"},
};
// clang-format on

/// As XKB counts: the scan codes of the four rows, plus eight.
quint32 codeOf(std::size_t index) {
    constexpr quint32 rowStarts[] = {10, 24, 38, 51};
    const std::size_t starts[] = {0, 12, 24, 36};
    const auto row = static_cast<std::size_t>(std::upper_bound(starts, starts + 4, index) - starts) - 1;
    return rowStarts[row] + static_cast<quint32>(index - starts[row]);
}

int qtKey(char16_t letter, const char16_t* dead) {
    if (std::u16string_view(dead).find(letter) != std::u16string_view::npos) {
        switch (letter) {
        case u'´':
            return Qt::Key_Dead_Acute;
        case u'`':
            return Qt::Key_Dead_Grave;
        case u'^':
            return Qt::Key_Dead_Circumflex;
        default:
            return Qt::Key_Dead_Diaeresis;
        }
    }
    return QChar(letter).toUpper().unicode();
}

} // namespace

bool Keyboard::has(char place, KeyLevel level) const {
    return level != KeyLevel::AltGr || third[usPlaces.find(place)] != u' ';
}

Stroke Keyboard::press(char place, Qt::KeyboardModifiers modifiers, bool altGr) const {
    const std::size_t index = usPlaces.find(place);
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    const char16_t letter = altGr ? third[index] : shift ? shifted[index] : plain[index];
    const int key = qtKey(letter, dead);
    const int base = altGr ? key : qtKey(plain[index], dead);
    Stroke stroke{key, modifiers, codeOf(index), QString(QChar(letter)), {QKeyCombination(modifiers, Qt::Key(base))}};
    if (shift && key != base) {
        stroke.candidates << QKeyCombination(modifiers & ~Qt::ShiftModifier, Qt::Key(key));
    }
    return stroke;
}

std::span<const Keyboard> keyboards() {
    return all;
}

const Keyboard& keyboardNamed(const QString& name) {
    return *std::ranges::find_if(all, [&name](const Keyboard& board) { return name == QLatin1String(board.name); });
}

} // namespace spacetow::test
