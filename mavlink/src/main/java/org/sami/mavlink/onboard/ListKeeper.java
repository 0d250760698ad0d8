package org.sami.mavlink.onboard;

import java.util.List;
import java.util.Optional;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/** Decides about lists that ground stations send, and learns of them. */
public interface ListKeeper {
    /** The refusal of a list, or of an item that the vehicle cannot carry out. */
    enum Refusal {
        /** It keeps no such list, or has no such command. */
        UNSUPPORTED,
        /** It knows no such frame. */
        UNSUPPORTED_FRAME,
        /** A parameter cannot be. */
        INVALID,
        /** Not from this station, or not now. */
        DENIED
    }

    /** Why a station may not change a list; empty where it may. Asked at a list's beginning and again at its end; nothing is changed by it. */
    default Optional<Refusal> whyNoList(VehicleId station, HeldKind kind) {
        return Optional.empty();
    }

    /** Why an item is refused; empty where it is taken. Called as each comes; nothing is changed by it. */
    Optional<Refusal> whyNot(HeldKind kind, MissionItem item);

    /** A whole list came, or one was emptied; it takes the place of the one before. */
    void changed(HeldKind kind, List<MissionItem> items);
}
