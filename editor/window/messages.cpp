#include "editor/window/messages.h"

#include "core/base/codes.h"
#include "editor/panels/form_rows.h"
#include "editor/panels/number_text.h"
#include "editor/window/messages_compare.h"
#include "editor/window/messages_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <string_view>

namespace spacetow {

namespace {

std::string_view spelled(Code code) {
    return code.text();
}

std::string_view spelled(const char* code) {
    return code;
}

template <class Text>
const Text* textOf(std::span<const Text> texts, std::string_view code) {
    const auto found = std::ranges::find_if(texts, [code](const Text& text) { return spelled(text.code) == code; });
    return found == texts.end() ? nullptr : &*found;
}

/// In one pass, so that a percent sign within an argument stays one.
QString filled(const QString& text, const QStringList& arguments) {
    QString out;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const int number = text[i] == u'%' && i + 1 < text.size() ? text[i + 1].digitValue() : 0;
        if (number >= 1) {
            ++i;
            out += arguments.value(number - 1);
        } else {
            out += text[i];
        }
    }
    return out;
}

/// "set-friction" → "Set friction".
QString spokenCode(std::string_view code) {
    QString text = QString::fromUtf8(code).replace('-', ' ');
    if (!text.isEmpty()) {
        text[0] = text[0].toUpper();
    }
    return text;
}

QString translated(const char* text) {
    return QCoreApplication::translate("messages", text);
}

/// What the system gives for a reason, in the user's words.
QString reasonText(const std::string& reason) {
    const auto found = std::ranges::find(systemReasons(), std::string_view(reason), &ReasonText::reason);
    return found == systemReasons().end() ? QString::fromStdString(reason) : translated(found->text);
}

/// As the user spells numbers and sizes.
QStringList told(const std::vector<std::string>& arguments, ArgumentKinds kinds) {
    QStringList out;
    for (const std::string& argument : arguments) {
        const char kind = *kinds == '\0' ? '-' : *kinds++;
        bool isWhole = false;
        const qlonglong bytes = QString::fromStdString(argument).toLongLong(&isWhole);
        out << (kind == 'n'              ? localNumberText(argument)
                : kind == 'b' && isWhole ? sizeText(bytes)
                : kind == 'r'            ? reasonText(argument)
                                         : QString::fromStdString(argument));
    }
    return out;
}

/// Names and what was typed stand in quotation marks.
QStringList toldInHint(const Hint& hint, const char* text) {
    QStringList out;
    for (const std::string& argument : hint.arguments) {
        const QString quoted = QStringLiteral("“%%1”").arg(out.size() + 1);
        out << (QString::fromUtf8(text).contains(quoted) ? QString::fromStdString(argument)
                                                         : localNumberText(argument));
    }
    return out;
}

QString sentenceOf(std::span<const MessageText> texts, std::string_view code,
                   const std::vector<std::string>& arguments) {
    const MessageText* text = textOf(texts, code);
    return text == nullptr ? spokenCode(code) : filled(translated(text->text), told(arguments, text->kinds));
}

/// Its arguments are a line, and the code and the arguments of what is wrong there.
bool wrapsAnother(const Error& error) {
    constexpr std::array<SentenceCode, 2> codes{"not-sound-json", "capsule-bad-level"};
    return std::ranges::find(codes, SentenceCode(error.code)) != codes.end() && error.arguments.size() >= 2;
}

/// "Change “Angle” of 3 objects".
QString fieldSentence(const Label& label) {
    const bool ofLevel = label.code == LabelCode("change-level");
    const QString text =
        ofLevel ? QCoreApplication::translate("messages", "Change “%1” of the level")
        : label.count == 1
            ? QCoreApplication::translate("messages", "Change “%1”")
            : counted(QCoreApplication::translate("messages", "Change “%1” of %n objects", nullptr, label.count),
                      label.count);
    return text.arg(fieldName(ofLevel ? levelRows() : objectRows(), label.field));
}

/// "3 times, in lines 4, 7 …": how often something came up in a file, and where.
QString placesOf(const std::string& count, const std::string& lines) {
    const int times = QString::fromStdString(count).toInt();
    const QString often = times == 1
                              ? QCoreApplication::translate("messages", "once")
                              : counted(QCoreApplication::translate("messages", "%n times", nullptr, times), times);
    if (lines.empty()) {
        return often;
    }
    const bool isOne = lines.find_first_not_of("0123456789") == std::string::npos;
    return (isOne ? QCoreApplication::translate("messages", "%1, in line %2")
                  : QCoreApplication::translate("messages", "%1, in lines %2"))
        .arg(often, QString::fromStdString(lines));
}

} // namespace

QString sentence(const Problem& problem) {
    const std::vector<std::string>& arguments = problem.arguments;
    const MessageText* const text = textOf(problemTexts(), problem.code.text());
    if (text == nullptr || text->unnamed == nullptr || arguments.size() < 2 || !arguments[0].empty()) {
        return sentenceOf(problemTexts(), problem.code.text(), arguments);
    }
    QStringList words = told(arguments, text->kinds);
    words[1] = sentenceOf(problemTexts(), arguments[1], {}); // a code itself: what kind of thing it is
    return filled(translated(text->unnamed), words);
}

bool namesItsFile(const Error& error) {
    return std::ranges::find(fileCodes, error.code.text()) != std::ranges::end(fileCodes);
}

QString sentence(const QString& file, const Error& error) {
    // Put together, as a file name may hold what looks like a place for an argument.
    return namesItsFile(error) ? sentence(error)
                               : QCoreApplication::translate("messages", "%1 cannot be opened.").arg(file) +
                                     QLatin1Char('\n') + sentence(error);
}

QString sentence(const Error& error) {
    const std::string_view code = error.code.text();
    if (wrapsAnother(error)) {
        const std::vector<std::string> rest(error.arguments.begin() + 2, error.arguments.end());
        return sentenceOf(problemTexts(), code,
                          {error.arguments[0], sentenceOf(problemTexts(), error.arguments[1], rest).toStdString()});
    }
    if (textOf(explainTexts(), code) != nullptr) {
        return sentenceOf(explainTexts(), code, error.arguments);
    }
    if (textOf(exchangeTexts(), code) == nullptr) {
        return sentenceOf(problemTexts(), code, error.arguments);
    }
    std::vector<std::string> arguments = error.arguments;
    if (arguments.size() == 3) { // what a report has of each kind
        arguments.push_back(placesOf(arguments[0], arguments[1]).toStdString());
    }
    return sentenceOf(exchangeTexts(), code, arguments);
}

QString sentence(const Hint& hint) {
    const HintText* const text = textOf(hintTexts(), hint.code);
    return text == nullptr ? spokenCode(hint.code) : filled(translated(text->text), toldInHint(hint, text->text));
}

QString sentence(const Label& label) {
    if (!label.field.empty()) {
        return fieldSentence(label);
    }
    const LabelText* text = textOf(labelTexts(), label.code.text());
    if (text == nullptr) {
        return spokenCode(label.code.text());
    }
    // A text without a number has no plural to be looked up by.
    const bool counts = std::string_view(text->many).find("%n") != std::string_view::npos;
    return label.count == 1
               ? translated(text->one)
               : counted(QCoreApplication::translate("messages", text->many, nullptr, counts ? label.count : -1),
                         label.count);
}

bool hasSentence(std::string_view code) {
    return textOf(problemTexts(), code) != nullptr || textOf(exchangeTexts(), code) != nullptr ||
           textOf(hintTexts(), code) != nullptr || textOf(explainTexts(), code) != nullptr;
}

bool hasLabel(std::string_view code) {
    return textOf(labelTexts(), code) != nullptr;
}

} // namespace spacetow
