#pragma once
// A line that names another object of the level, by its name, by its kind and place where it has none, or by its key;
// completes what is typed and offers all that suit.

#include "core/level/level.h"

#include <QAction>
#include <QLineEdit>

#include <functional>
#include <optional>

namespace spacetow {

class ObjectField : public QLineEdit {
    Q_OBJECT

  public:
    /// Only objects that `suits` are named. With `mayBeNone` an empty line means no object.
    ObjectField(std::function<bool(const Object&)> suits, bool mayBeNone, QWidget* parent = nullptr);

    /// Without a key several are meant.
    void setValue(std::optional<Key> key);

    /// Forgets what is being typed.
    void revert();

    /// The level that is shown; must be there before anything else.
    std::function<const Level&()> level;
    /// Answers with an objection, empty for none. 0 for no object.
    std::function<QString(Key)> enter;
    /// Shows the object elsewhere; without it nothing happens.
    std::function<void(Key)> showObject;
    const QString& fault() const { return m_fault; }

  Q_SIGNALS:
    void faultChanged();

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    void commit();
    void offerNames();
    void openList();
    QString told(const Object& object) const;
    void setFault(const QString& fault);
    /// The objects whose name or key the text is; two are enough.
    std::vector<Key> meant(const QString& text) const;

    std::function<bool(const Object&)> m_suits;
    bool m_mayBeNone;
    std::optional<Key> m_key;
    QAction* m_show = nullptr; // a button in the line, which owns it
    QString m_fault;
};

} // namespace spacetow
