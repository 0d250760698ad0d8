package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.protocol.Token;

/**
 * One sub-mission instance as its parent sees it. Tokens are named as the parent names them.
 */
final class Instance {
    /** How far the instance is. */
    enum Status {
        RUNNING,
        COMPLETE,
        ABORTED
    }

    /** The visit of the parent that started it; null for a static instance. */
    final Visit visit;
    /** The place of the parent. */
    final PlaceState place;

    final int specIndex;
    Status status = Status.RUNNING;
    /** The mission while it runs, else null. */
    Mission child;
    /** Starting tokens that were not withdrawn; for a static instance those that have not returned. */
    final List<Token> starting;
    /** Tokens in the end places when it completed, that no firing has used. */
    final List<Token> returned = new ArrayList<>(0);

    String returnValue = "";

    Instance(Visit visit, PlaceState place, int specIndex, List<Token> starting) {
        this.visit = visit;
        this.place = place;
        this.specIndex = specIndex;
        this.starting = new ArrayList<>(starting);
    }

    boolean isShared() {
        return visit == null;
    }
}
