package org.sami.crw.proxy.command;

import java.util.Objects;
import org.sami.spn.protocol.Priority;

/** What every command must have. */
final class CommandChecks {
    /** Leaves room for what the proxy appends within the link's bound on ids. */
    private static final int MAX_ID_LENGTH = 120;

    private CommandChecks() {}

    static void check(String commandId, Priority priority) {
        if (commandId.isEmpty() || commandId.length() > MAX_ID_LENGTH) {
            throw new IllegalArgumentException("a command id of " + commandId.length() + " characters");
        }
        Objects.requireNonNull(priority, "priority");
    }
}
