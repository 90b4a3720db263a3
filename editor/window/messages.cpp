#include "editor/window/messages.h"

#include "editor/window/messages_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <string_view>

namespace spacetow {

namespace {

template <class Text>
const Text* textOf(std::span<const Text> texts, const std::string& code) {
    const auto found = std::ranges::find_if(texts, [&code](const Text& text) { return code == text.code; });
    return found == texts.end() ? nullptr : &*found;
}

/// In one pass, so that a percent sign within an argument stays one.
QString filled(const QString& text, const std::vector<std::string>& arguments) {
    QString out;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const int number = text[i] == u'%' && i + 1 < text.size() ? text[i + 1].digitValue() : 0;
        if (number >= 1) {
            ++i;
            if (static_cast<std::size_t>(number) <= arguments.size()) {
                out += QString::fromStdString(arguments[static_cast<std::size_t>(number) - 1]);
            }
        } else {
            out += text[i];
        }
    }
    return out;
}

/// "set-friction" → "Set friction".
QString spokenCode(const std::string& code) {
    QString text = QString::fromStdString(code).replace('-', ' ');
    if (!text.isEmpty()) {
        text[0] = text[0].toUpper();
    }
    return text;
}

QString sentenceOf(std::span<const MessageText> texts, const std::string& code,
                   const std::vector<std::string>& arguments) {
    const MessageText* text = textOf(texts, code);
    return text == nullptr ? spokenCode(code) : filled(QCoreApplication::translate("messages", text->text), arguments);
}

/// "3 times, in lines 4, 7 …": how often something came up in a file, and where.
QString placesOf(const std::string& count, const std::string& lines) {
    const int times = QString::fromStdString(count).toInt();
    const QString often = times == 1 ? QCoreApplication::translate("messages", "once")
                                     : QCoreApplication::translate("messages", "%n times", nullptr, times);
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
    const std::string unnamed = problem.code + "-unnamed";
    const std::vector<std::string>& arguments = problem.arguments;
    if (arguments.size() < 2 || !arguments[0].empty() || textOf(problemTexts(), unnamed) == nullptr) {
        return sentenceOf(problemTexts(), problem.code, arguments);
    }
    std::vector<std::string> told = arguments;
    told[1] = sentenceOf(problemTexts(), arguments[1], {}).toStdString(); // a code itself: what kind of thing it is
    return sentenceOf(problemTexts(), unnamed, told);
}

QString sentence(const Error& error) {
    if (textOf(explainTexts(), error.code) != nullptr) {
        return sentenceOf(explainTexts(), error.code, error.arguments);
    }
    if (textOf(exchangeTexts(), error.code) == nullptr) {
        return sentenceOf(problemTexts(), error.code, error.arguments);
    }
    std::vector<std::string> told = error.arguments;
    if (told.size() == 3) { // what a report has of each kind
        told.push_back(placesOf(told[0], told[1]).toStdString());
    }
    return sentenceOf(exchangeTexts(), error.code, told);
}

QString sentence(const Hint& hint) {
    return hint.code.empty() ? QString() : sentenceOf(hintTexts(), hint.code, hint.arguments);
}

QString sentence(const Label& label) {
    const LabelText* text = textOf(labelTexts(), label.code);
    if (text == nullptr) {
        return spokenCode(label.code);
    }
    // A text without a number has no plural to be looked up by.
    const bool counts = std::string_view(text->many).find("%n") != std::string_view::npos;
    return label.count == 1 ? QCoreApplication::translate("messages", text->one)
                            : QCoreApplication::translate("messages", text->many, nullptr, counts ? label.count : -1);
}

bool hasSentence(const std::string& code) {
    return textOf(problemTexts(), code) != nullptr || textOf(exchangeTexts(), code) != nullptr ||
           textOf(hintTexts(), code) != nullptr || textOf(explainTexts(), code) != nullptr;
}

bool hasLabel(const std::string& code) {
    return textOf(labelTexts(), code) != nullptr;
}

} // namespace spacetow
