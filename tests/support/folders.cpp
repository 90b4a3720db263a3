#include "tests/support/folders.h"

namespace spacetow::test {

QString sourceFolder() {
    return QStringLiteral(SPACETOW_SOURCE_DIR);
}

QString binaryFolder() {
    return QStringLiteral(SPACETOW_BINARY_DIR);
}

} // namespace spacetow::test
