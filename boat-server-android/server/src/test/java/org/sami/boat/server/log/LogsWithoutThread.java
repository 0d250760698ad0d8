package org.sami.boat.server.log;

import java.io.IOException;

/** Opens logs that begin their new files at once, for tests outside this package. */
public final class LogsWithoutThread {
    private LogsWithoutThread() {}

    /** As {@link CommandLogFile#open}. */
    public static CommandLogFile open(LogPlace place, String bootId, LogEntries earlier) throws IOException {
        return CommandLogFile.open(new LogDisk(), Runnable::run, place, bootId, earlier, new NoFaults());
    }
}
