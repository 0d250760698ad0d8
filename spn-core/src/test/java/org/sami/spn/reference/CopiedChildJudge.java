package org.sami.spn.reference;

import java.util.Optional;
import java.util.function.LongFunction;

/** Holds the net of a seed's random plan with a sub-mission and copies of robots to the engine. Loaded a second time, next to a spoilt translation, by {@link SpoiltCopiesTest}. */
public final class CopiedChildJudge implements LongFunction<Optional<String>> {
    /** Nothing is judged yet. */
    public CopiedChildJudge() {}

    @Override
    public Optional<String> apply(long seed) {
        return CopiedChildNetTest.difference(seed);
    }
}
