#pragma once
// Shows and changes the fields of what is selected, or of the level when nothing is. Follows gestures live; what is
// entered becomes one history entry a field.

#include "editor/editing/document.h"
#include "editor/panels/form.h"

#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QWidget>

namespace spacetow {

class Inspector : public QWidget {
    Q_OBJECT

  public:
    /// The document must outlive the inspector.
    explicit Inspector(Document& document, QWidget* parent = nullptr);
    ~Inspector() override;

    /// The form in sight.
    const Form& form() const { return m_document.selection().empty() ? m_levelForm : m_objectForm; }

    /// Never so narrow that a field would be cut off.
    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return {310, 480}; }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void refresh();
    void changeObjects(const QString& id, const std::function<void(Object&)>& change);
    void enter(const QString& id, const FieldValue& value);
    void switchTag(const QString& id, int index, bool on);
    void defineTag(int index, const QString& name, const QColor& color);
    void watch(Form& form);

    Document& m_document;
    QVBoxLayout m_column;
    QLabel m_title;
    QStackedWidget m_pages;
    QScrollArea m_levelPage;
    QScrollArea m_objectPage;
    Form m_levelForm;
    Form m_objectForm;
    int m_listener = 0;
};

} // namespace spacetow
