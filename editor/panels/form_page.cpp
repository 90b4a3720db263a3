#include "editor/panels/form_page.h"

#include <QScrollBar>
#include <QStyle>

#include <algorithm>

namespace spacetow {

FormPage::FormPage(std::span<const FormRow> rows, FormTarget target, QWidget* parent)
    : QScrollArea(parent), m_form(rows, std::move(target)) {
    setWidget(&m_form);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // it is never narrower than narrowWidth
    keepScrolled();
    connect(&m_form, &Form::faultShown, this, &FormPage::reveal);
}

FormPage::~FormPage() {
    takeWidget(); // a member, not a child to be deleted
}

int FormPage::fullWidth() const {
    return m_form.fullWidth() + style()->pixelMetric(QStyle::PM_ScrollBarExtent);
}

int FormPage::narrowWidth() const {
    return m_form.narrowWidth() + style()->pixelMetric(QStyle::PM_ScrollBarExtent);
}

void FormPage::resizeEvent(QResizeEvent* event) {
    m_form.setNarrow(width() < fullWidth());
    QScrollArea::resizeEvent(event);
}

void FormPage::keepScrolled() {
    QScrollBar* const bar = verticalScrollBar();
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) {
        const bool isCutShort = value == bar->maximum() && m_wanted > value;
        m_wanted = isCutShort ? m_wanted : value;
    });
    connect(bar, &QScrollBar::rangeChanged, this, [this, bar](int, int most) {
        if (bar->value() != m_wanted) {
            bar->setValue(std::min(m_wanted, most));
        }
    });
}

/// Once it has a place. What is typed stands right above it.
void FormPage::reveal(QWidget* sentence) {
    QMetaObject::invokeMethod(
        sentence, [this, sentence] { ensureWidgetVisible(sentence, 0, sentence->fontMetrics().height() * 2); },
        Qt::QueuedConnection);
}

} // namespace spacetow
