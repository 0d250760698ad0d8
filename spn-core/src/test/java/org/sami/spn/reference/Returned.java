package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;

/**
 * What one instance gave its parent at one time: a completed visit's, or through an end place of a static one. "One return is
 * one occurrence for all transitions that check it" (SEMANTICS, Sub-missions). Compared by identity.
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

    /** "The transition takes the tokens of the visit whose CheckReturn it used, no others": both at once cannot be. */
    boolean goesWith(Returned other) {
        boolean sameInstance = by == other.by;
        boolean samePlace = by.parent == other.by.parent && by.place.equals(other.by.place);
        if (by.visit.isPresent() && other.by.visit.isPresent()) {
            return !samePlace || by.visit.equals(other.by.visit);
        }
        return !sameInstance || this == other;
    }
}
