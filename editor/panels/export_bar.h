#pragma once
// A bar above the canvas that says how the level is to become a picture: what of it, how large, on which ground.

#include "editor/editing/document.h"
#include "editor/panels/fault_label.h"
#include "editor/panels/number_field.h"
#include "editor/panels/scrub_label.h"
#include "editor/panels/wrapping_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSize>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <functional>
#include <optional>

namespace spacetow {

struct ExportSettings {
    bool wholeLevel = true;     // else what is in view
    double pixelsPerMetre = 66; // as at 100 %
    bool transparent = false;
    bool grid = false;
};

class ExportBar : public QWidget {
    Q_OBJECT

  public:
    explicit ExportBar(QWidget* parent = nullptr);

    /// How large a picture becomes, in pixels; nothing when it is too large or shows nothing.
    void setMeasure(std::function<std::optional<QSize>(const ExportSettings&)> measure) {
        m_measure = std::move(measure);
    }
    void setWords(const std::function<QString(const Error&)>& words) { m_scale.words = words; }

    void begin();
    const ExportSettings& settings() const { return m_settings; }
    /// How large it would be, or why not.
    QString summary() const { return m_size.text().isEmpty() ? m_fault.text() : m_size.text(); }
    void apply();
    void cancel();

  Q_SIGNALS:
    /// A file is to be chosen for a picture with these settings.
    void wanted();
    void closed();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void refresh();

    std::function<std::optional<QSize>(const ExportSettings&)> m_measure;
    ExportSettings m_settings;
    QVBoxLayout m_column;
    WrappingRow m_top, m_fields;
    QLabel m_title, m_size;
    QComboBox m_area;
    NumberField m_scale;
    ScrubLabel m_scaleLabel;
    QCheckBox m_transparent, m_grid;
    QToolButton m_apply, m_cancel;
    FaultLabel m_fault;
};

} // namespace spacetow
