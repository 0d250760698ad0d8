package org.sami.mavlink.testing;

import java.util.List;
import java.util.Optional;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;

/** Decides about lists that ground stations send, and learns of them. */
public interface ListKeeper {
    /** The refusal of an item that the vehicle cannot carry out. */
    enum Refusal {
        /** It has no such command. */
        UNSUPPORTED,
        /** It knows no such frame. */
        UNSUPPORTED_FRAME,
        /** A parameter cannot be. */
        INVALID
    }

    /** Why an item is refused; empty where it is taken. Called as each comes; nothing is changed by it. */
    Optional<Refusal> whyNot(HeldKind kind, MissionItem item);

    /** A whole list came, or one was emptied; it takes the place of the one before. */
    void changed(HeldKind kind, List<MissionItem> items);
}
