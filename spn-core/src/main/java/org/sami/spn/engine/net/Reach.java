package org.sami.spn.engine.net;

import org.sami.spn.vocabulary.EventRole;

/** How far a firing reaches into what sub-mission instances hold. */
public enum Reach {
    /** Not what instances hold; of a static place only what an unused return brought back. */
    FREE,
    /** Also what aborted instances left behind. */
    ABORTED,
    /** Everything: interrupts, abort and complete. */
    ALL;

    /** How far an input event lets a firing reach. */
    public static Reach of(EventRole role) {
        if (role.isPress()) {
            return ALL;
        }
        return role == EventRole.SUB_MISSION_ABORTED ? ABORTED : FREE;
    }
}
