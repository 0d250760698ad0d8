package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sami.spn.protocol.Token;

/**
 * One sub-mission instance as its parent sees it. Tokens are named as the parent names them.
 */
public final class Instance {
    /** How far the instance is. */
    public enum Status {
        RUNNING,
        COMPLETE,
        ABORTED
    }

    /** The visit of the parent that started it; null for a static instance. */
    public final @Nullable Visit visit;
    /** The place of the parent. */
    public final PlaceState place;

    public final int specIndex;
    public Status status = Status.RUNNING;
    /** The mission while it runs, else null. */
    public @Nullable MissionState child;
    /** Starting tokens that were not withdrawn; for a static instance those that have not returned. */
    public final List<Token> starting;
    /** Tokens in the end places when it completed, that no firing has used. */
    public final List<Token> returned = new ArrayList<>(0);

    public String returnValue = "";

    public Instance(@Nullable Visit visit, PlaceState place, int specIndex, List<Token> starting) {
        this.visit = visit;
        this.place = place;
        this.specIndex = specIndex;
        this.starting = new ArrayList<>(starting);
    }

    /** The id of the plan that it runs. */
    public String plan() {
        return (isShared() ? place.place.shared : place.place.dynamic)
                .get(specIndex)
                .plan();
    }

    /** The visit of the parent that started it; not for a static instance. */
    public Visit startedBy() {
        return Objects.requireNonNull(visit, "the visit of a static instance");
    }

    public boolean isShared() {
        return visit == null;
    }
}
