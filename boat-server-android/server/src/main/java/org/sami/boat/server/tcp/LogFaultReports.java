package org.sami.boat.server.tcp;

import java.io.IOException;
import java.nio.file.Path;
import org.sami.boat.server.log.LogFaults;

/** Reports on a boat's console when its log cannot be written or continued, and when that is over. */
public final class LogFaultReports implements LogFaults {
    private final Path file;
    private final TcpServerListener listener;

    /** For a log. */
    public LogFaultReports(Path file, TcpServerListener listener) {
        this.file = file;
        this.listener = listener;
    }

    @Override
    public void unwritable(IOException cause) {
        listener.failed("the log " + file + " cannot be written; the boat goes on, and tries again", cause);
    }

    @Override
    public void oversized(IOException cause) {
        listener.failed("no new file of the log " + file + " can be written: it grows beyond its size", cause);
    }

    @Override
    public void mended() {
        listener.recovered("the log " + file + " is written again");
    }
}
