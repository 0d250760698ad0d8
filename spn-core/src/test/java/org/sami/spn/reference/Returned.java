package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;

/**
 * What one instance gave its parent at one time: a completed visit's, or through an end place of a static one
 * (R-SHR-2, R-RET-1). Compared by identity.
 */
final class Returned {
    final Instance by;
    /** Static: whom it brought back. */
    final List<Token> tokens;

    final Optional<Value> value;
    boolean usedUp;

    Returned(Instance by, List<Token> tokens, Optional<Value> value) {
        this.by = by;
        this.tokens = new ArrayList<>(tokens);
        this.value = value;
    }

    /** Whether both can be used at once (R-RET-3). */
    boolean goesWith(Returned other) {
        boolean sameInstance = by == other.by;
        boolean samePlace = by.parent == other.by.parent && by.place.equals(other.by.place);
        if (by.visit.isPresent() && other.by.visit.isPresent()) {
            return !samePlace || by.visit.equals(other.by.visit);
        }
        return !sameInstance || this == other;
    }
}
