package org.sami.boat.mavlink;

import java.util.List;
import java.util.Optional;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OnboardState.FenceState;

/** The fence that a ground station gave a boat, and whether the boat is outside of it. It lasts as long as the boat's process. For the boat's thread. */
final class BoatFence {
    /** For so long the boat must be inside until a breach ends, in ms: a boat that keeps its place at the border would leave and come back all the time. */
    static final long BACK_MS = 2_000;

    private static final long NOT_BACK = Long.MIN_VALUE;

    private StationFence fence = StationFence.NONE;
    private boolean isHeld;
    private boolean isNew;
    private boolean isInForce;
    private boolean isBreached;
    private int breaches;
    private long breachMs;
    private long backMs = NOT_BACK;

    /** Takes a fence of which nothing is wrong in place of the one before; without items there is none. */
    void replace(List<MissionItem> items) {
        fence = StationFenceItems.fence(items);
        isHeld = !items.isEmpty();
        isNew = true;
    }

    /** The fence; one that lets the boat be everywhere where none is held. */
    StationFence fence() {
        return fence;
    }

    /**
     * Looks whether the boat is inside.
     *
     * @param here where it is; empty where it does not know: then it is taken to be where it was, inside or outside
     * @param binds whether somebody commands, or may take the command, whom the fence binds
     * @return whether a breach begins or ends by that
     */
    boolean look(Optional<Position> here, boolean binds, long nowMs) {
        isInForce = binds && !fence.zones().isEmpty();
        boolean isOutside = isInForce && here.map(at -> !fence.isInside(at)).orElse(isBreached);
        boolean isOfOther = isNew;
        isNew = false;
        if (isOutside) {
            backMs = NOT_BACK;
            return begin(nowMs);
        }
        if (backMs == NOT_BACK) {
            backMs = nowMs;
        }
        boolean ends = isBreached && (!isInForce || isOfOther || nowMs - backMs >= BACK_MS);
        isBreached &= !ends;
        return ends;
    }

    private boolean begin(long nowMs) {
        if (isBreached) {
            return false;
        }
        isBreached = true;
        breaches++;
        breachMs = nowMs;
        return true;
    }

    boolean isInForce() {
        return isInForce;
    }

    boolean isBreached() {
        return isBreached;
    }

    /** How it is, for stations. */
    FenceState state() {
        return new FenceState(isHeld, isInForce, isBreached, breaches, breachMs);
    }
}
