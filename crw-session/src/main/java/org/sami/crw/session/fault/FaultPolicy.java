package org.sami.crw.session.fault;

import java.util.Objects;

/**
 * What is to happen when a session's engine or its journal fails.
 *
 * @param boats what boats do meanwhile
 * @param patienceMillis how long the engine waits for a journal that cannot be written before it stops for good
 */
public record FaultPolicy(BoatsAtFault boats, long patienceMillis) {
    /** Somebody is there who can make room on a disk: the engine waits for as long as it takes, and boats hold their places. */
    public static final FaultPolicy ATTENDED = new FaultPolicy(BoatsAtFault.HOLD, Long.MAX_VALUE);

    /** Nobody is there: a minute, in which others may give room back, and whoever started it learns it from its exit code. */
    public static final FaultPolicy ALONE = new FaultPolicy(BoatsAtFault.HOLD, 60_000);

    public FaultPolicy {
        Objects.requireNonNull(boats, "boats");
    }

    /** The same with something else that boats do. */
    public FaultPolicy with(BoatsAtFault others) {
        return new FaultPolicy(others, patienceMillis);
    }
}
