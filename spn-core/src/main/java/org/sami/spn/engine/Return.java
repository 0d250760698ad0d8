package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.protocol.Token;

/**
 * One return of a sub-mission: of a dynamic instance when its visit is complete, of a static one through an end place. It is
 * one occurrence for all transitions that check its value (SEMANTICS, Sub-missions). Compared by identity.
 */
final class Return {
    final Instance instance;
    /** Of a static instance the tokens that left the child with it, as the parent names them; of a dynamic one none. */
    final List<Token> tokens;

    final String value;
    /** Whether it was used by a firing, or is void. */
    boolean over;

    Return(Instance instance, List<Token> tokens, String value) {
        this.instance = instance;
        this.tokens = new ArrayList<>(tokens);
        this.value = value;
    }

    /** The visit that it completes; null for a static instance. */
    Visit visit() {
        return instance.visit;
    }

    PlaceState place() {
        return instance.place;
    }

    /** Whether no firing can use both: it takes the tokens of one visit, and of a static instance one return. */
    boolean excludes(Return other) {
        if (this == other || instance.isShared() != other.instance.isShared()) {
            return false;
        }
        return instance.isShared() ? instance == other.instance : place() == other.place() && visit() != other.visit();
    }
}
