#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/level/describe.h"

namespace spacetow {

int schemaCommand(const QStringList& arguments) {
    if (arguments.size() > 1) {
        complain(QStringLiteral("schema takes no arguments"));
        return exit_status::unusable;
    }
    printText(QString::fromStdString(levelSchemaText()).trimmed());
    return exit_status::good;
}

int fieldsCommand(const QStringList& arguments) {
    const std::string table = arguments.size() == 2 ? fieldTable(arguments[1].toStdString()) : std::string();
    if (table.empty()) {
        QStringList parts;
        for (const std::string_view part : describedParts()) {
            parts << QString::fromUtf8(part.data(), static_cast<qsizetype>(part.size()));
        }
        complain(QStringLiteral("fields wants one of ") + parts.join(QStringLiteral(", ")));
        return exit_status::unusable;
    }
    printText(QString::fromStdString(table).trimmed());
    return exit_status::good;
}

} // namespace spacetow
