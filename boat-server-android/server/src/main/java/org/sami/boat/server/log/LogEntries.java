package org.sami.boat.server.log;

import org.sami.boat.link.CommandMessage;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.RememberedCommand;

/** Receives the entries of a boat's log in their order. */
public interface LogEntries {
    /** A command was answered. */
    void answered(LoggedCommand entry);

    /** A server has started. */
    default void started(String bootId) {}

    /** Changes of commander that were not recorded. */
    default void leftOut(String bootId, long timeMs, long count) {}

    /** A command of an earlier file, which is not to be executed again. */
    default void remembered(RememberedCommand command) {}

    /** A command of an earlier file that is in force. */
    default void inForce(String clientId, CommandMessage command) {}

    /** Gives it all back to a boat's server, which has no client yet. */
    static LogEntries restoring(BoatServer boat) {
        return new LogEntries() {
            @Override
            public void answered(LoggedCommand entry) {
                boat.restore(entry.clientId(), entry.command(), entry.answer());
            }

            @Override
            public void remembered(RememberedCommand command) {
                boat.restore(command);
            }

            @Override
            public void inForce(String clientId, CommandMessage command) {
                boat.restoreInForce(clientId, command);
            }
        };
    }
}
