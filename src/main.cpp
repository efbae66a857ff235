// The program's entry: everything is in app/.
#include "app/command_line.h"

int main(int argc, char** argv) { return tyg::runCommandLine(argc, argv); }
