#include "editor/canvas/entry_box.h"

#include "editor/canvas/palette.h"
#include "editor/editing/measure.h"

#include <QHBoxLayout>
#include <QKeyEvent>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int besidePointer = 18; // px
constexpr int fieldDigits = 8;

/// The digits of any script as those that expressions are made of.
std::string withAsciiDigits(QString text) {
    for (QChar& letter : text) {
        if (letter.isDigit()) {
            letter = QChar(u'0' + letter.digitValue());
        } else if (letter == QChar(0x2212)) {
            letter = u'-';
        } else if (letter == QChar(0x066b)) {
            letter = u'.';
        }
    }
    return text.toStdString();
}

} // namespace

EntryBox::EntryBox(Toolbox& toolbox, QWidget& canvas) : QFrame(&canvas), m_toolbox(toolbox) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(6, 4, 6, 4);
    row->setSpacing(4);
    for (Field& field : m_fields) {
        field.text.setFixedWidth(field.text.fontMetrics().horizontalAdvance(QLatin1Char('0')) * fieldDigits + 12);
        field.text.installEventFilter(this);
        field.name.setBuddy(&field.text);
        row->addWidget(&field.name);
        row->addWidget(&field.text);
        row->addWidget(&field.unit);
        connect(&field.text, &QLineEdit::textEdited, this, [this] { send(); });
    }
    setFocusProxy(&m_fields[0].text);
    hide();
}

void EntryBox::begin(const QString& text) {
    m_fields[0].text.setText(text);
    m_fields[1].text.clear();
    send();
    m_fields[0].text.setFocus();
    m_fields[0].text.end(false);
}

void EntryBox::send() {
    m_toolbox.type({withAsciiDigits(m_fields[0].text.text()), withAsciiDigits(m_fields[1].text.text())});
}

void EntryBox::follow(const QPoint& pointer) {
    const std::optional<TypedEntry>& typing = m_toolbox.typing();
    if (!typing) {
        if (isVisible()) {
            const bool hadFocus = m_fields[0].text.hasFocus() || m_fields[1].text.hasFocus();
            hide();
            if (hadFocus) {
                parentWidget()->setFocus();
            }
        }
        return;
    }
    showKind(typing->kind);
    showFaults(typing->faulty);
    if (const std::optional<TypedMeasures> pointed = m_toolbox.measures()) {
        m_fields[0].text.setPlaceholderText(QString::fromStdString(lengthText(pointed->first)));
        m_fields[1].text.setPlaceholderText(QString::fromStdString(
            isTypedAngle(typing->kind, 1) ? degreesText(pointed->second) : lengthText(pointed->second)));
    }
    adjustSize();
    moveBeside(pointer);
    show();
    raise();
}

void EntryBox::showKind(TypedKind kind) {
    const bool speed = kind == TypedKind::SpeedAngle;
    const bool angle = isTypedAngle(kind, 1);
    const QString first = speed                            ? tr("Speed")
                          : kind == TypedKind::WidthHeight ? tr("Width")
                          : kind == TypedKind::Radius      ? tr("Radius")
                                                           : tr("Length");
    m_fields[0].name.setText(first);
    m_fields[0].unit.setText(speed ? QStringLiteral("m/s") : QStringLiteral("m"));
    m_fields[1].name.setText(angle ? tr("Angle") : tr("Height"));
    m_fields[1].unit.setText(angle ? QStringLiteral("°") : QStringLiteral("m"));
    for (Field& field : m_fields) {
        field.text.setAccessibleName(field.name.text());
    }
    const bool both = typedFields(kind) > 1;
    m_fields[1].name.setVisible(both);
    m_fields[1].text.setVisible(both);
    m_fields[1].unit.setVisible(both);
}

void EntryBox::showFaults(int faulty) {
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        QPalette colors = palette();
        if (static_cast<int>(i) == faulty) {
            colors.setColor(QPalette::Text, markColors(shadeOf(colors)).error);
        }
        m_fields[i].text.setPalette(colors);
    }
}

/// Below and to the right of the pointer, on its other side where there is no room; never under it.
void EntryBox::moveBeside(const QPoint& pointer) {
    const QSize room = parentWidget()->size();
    QPoint corner = pointer + QPoint(besidePointer, besidePointer);
    if (corner.x() + width() > room.width()) {
        corner.setX(std::max(0, pointer.x() - besidePointer - width()));
    }
    if (corner.y() + height() > room.height()) {
        corner.setY(std::max(0, pointer.y() - besidePointer - height()));
    }
    move(corner);
}

bool EntryBox::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) {
        return QFrame::eventFilter(watched, event);
    }
    const auto& stroke = *static_cast<QKeyEvent*>(event);
    const bool enters = stroke.key() == Qt::Key_Return || stroke.key() == Qt::Key_Enter;
    const bool nothingLeft =
        stroke.key() == Qt::Key_Backspace && m_fields[0].text.text().isEmpty() && m_fields[1].text.text().isEmpty();
    if (!enters && stroke.key() != Qt::Key_Escape && !nothingLeft) {
        return QFrame::eventFilter(watched, event);
    }
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
    } else if (enters) {
        m_toolbox.enterTyped();
    } else {
        m_toolbox.stopTyping();
    }
    return true;
}

/// Tab goes round in the box.
bool EntryBox::focusNextPrevChild(bool) {
    Field& other = m_fields[m_fields[0].text.hasFocus() && m_fields[1].text.isVisible() ? 1 : 0];
    other.text.setFocus(Qt::TabFocusReason);
    other.text.selectAll();
    return true;
}

} // namespace spacetow
