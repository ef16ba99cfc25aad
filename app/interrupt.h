// Ctrl-C asks politely: commands finish the file being written and return 130.
#pragma once

namespace fascia {

/// SIGINT and SIGTERM set a flag; the second one ends the program at once. SIGPIPE and SIGXFSZ are ignored: a dead child process or a
/// file that may not grow is an error with a message, not an end without one.
void catch_interrupts();
bool interrupted();

}  // namespace fascia
