// levelc: looks at levels from the command line.

#include <QCoreApplication>

#include <cstdio>

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    std::fputs("usage: levelc COMMAND\n", stderr);
    return 2;
}
