package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.spn.protocol.Token;

/**
 * One return of a sub-mission: of a dynamic instance when its visit is complete, of a static one through an end place. It is
 * one occurrence for all transitions that check its value (R-RET-1). Compared by identity.
 */
public final class Return {
    public final Instance instance;
    /** Of a static instance the tokens that left the child with it, as the parent names them; of a dynamic one none. */
    public final List<Token> tokens;

    public final String value;
    /** Whether it was used by a firing, or is void. */
    public boolean over;

    public Return(Instance instance, List<Token> tokens, String value) {
        this.instance = instance;
        this.tokens = new ArrayList<>(tokens);
        this.value = value;
    }

    /** The visit that it completes; null for a static instance. */
    public @Nullable Visit visit() {
        return instance.visit;
    }

    public PlaceState place() {
        return instance.place;
    }

    /** Whether no firing can use both: it takes the tokens of one visit, and of a static instance one return. */
    public boolean excludes(Return other) {
        if (this == other || instance.isShared() != other.instance.isShared()) {
            return false;
        }
        return instance.isShared() ? instance == other.instance : place() == other.place() && visit() != other.visit();
    }
}
