package org.sami.crw.operator.mission;

import java.util.List;
import java.util.Objects;

/**
 * A mission that cannot go on by itself.
 *
 * @param mission the mission or sub-mission that cannot go on
 * @param root the root mission
 * @param title title of the root mission
 * @param sinceMillis when it was first stuck, on the session's clock
 * @param what why it cannot go on, one sentence without a full stop
 * @param help what the operator can do, one sentence without a full stop
 * @param boats ids of the boats that cannot go on
 * @param again activations that can be delivered again, so that their handlers retry
 */
public record StuckMission(
        long mission,
        long root,
        String title,
        long sinceMillis,
        String what,
        String help,
        List<String> boats,
        List<Long> again) {
    public StuckMission {
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(what, "what");
        Objects.requireNonNull(help, "help");
        boats = List.copyOf(boats);
        again = List.copyOf(again);
    }

    /** The same since another time. */
    public StuckMission since(long millis) {
        return new StuckMission(mission, root, title, millis, what, help, boats, again);
    }

    /** Whether there is something that can be asked of boats or services once more. */
    public boolean canBeSentAgain() {
        return !again.isEmpty();
    }
}
