// Ctrl-C asks politely: commands finish the file being written and return 130.
#pragma once

namespace fascia {

void catch_interrupts();  // SIGINT and SIGTERM set a flag; SIGPIPE is ignored, so that a dead child process is an error, not an end
bool interrupted();

}  // namespace fascia
