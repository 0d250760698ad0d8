package org.sami.journal.postgres;

import java.net.InetAddress;
import java.net.UnknownHostException;

/** How this process is called to others that use the same database: by its host and its number there. */
public final class ProcessName {
    private ProcessName() {}

    /** The name, such as {@code laptop-1 (process 4711)}; asks the system for the host's name, which may take a while. */
    public static String ofThisProcess() {
        String host;
        try {
            host = InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException unnamed) {
            host = "a computer without a name";
        }
        return host + " (process " + ProcessHandle.current().pid() + ")";
    }
}
