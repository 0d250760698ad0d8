package org.sami.spn.reference;

import java.util.Optional;
import java.util.function.LongFunction;

/**
 * Compares nets that follow whether any robots are in a place with nets that name them, for a seed's random plans. {@link SpoiltPresenceTest} loads it a second time, next to
 * a spoilt translation.
 */
public final class PresentJudge implements LongFunction<Optional<String>> {
    /** Nothing is judged yet. */
    public PresentJudge() {}

    @Override
    public Optional<String> apply(long seed) {
        return PresentNetTest.difference(seed);
    }
}
