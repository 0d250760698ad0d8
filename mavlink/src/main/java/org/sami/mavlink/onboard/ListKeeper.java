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
        /** It keeps fewer items than that. */
        NO_SPACE,
        /** Not from this station, or not now. */
        DENIED
    }

    /**
     * Why a station may not change a list; empty where it may. Asked at a list's beginning and again at its end; nothing is changed by it.
     *
     * @param items how many items the list is to have
     */
    default Optional<Refusal> whyNoList(VehicleId station, HeldKind kind, int items) {
        return Optional.empty();
    }

    /** Why an item is refused; empty where it is taken. Called as each comes; nothing is changed by it. */
    Optional<Refusal> whyNot(HeldKind kind, MissionItem item);

    /** A list is refused as the place of an item is not on the earth; the words say which. */
    default void unreadable(HeldKind kind, String why) {}

    /** Why a list is refused whose items were taken one by one; empty where it is taken. Called once all are there; nothing is changed by it. */
    default Optional<Refusal> whyNotWhole(HeldKind kind, List<MissionItem> items) {
        return Optional.empty();
    }

    /** A whole list came, or one was emptied; it takes the place of the one before. */
    void changed(HeldKind kind, List<MissionItem> items);
}
