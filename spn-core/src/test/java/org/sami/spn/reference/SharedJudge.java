package org.sami.spn.reference;

import java.util.Optional;
import java.util.function.LongFunction;

/** Holds the net of a seed's random plan with a shared sub-mission to the engine. Loaded a second time, next to a spoilt translation, by {@link SpoiltSharedTest}. */
public final class SharedJudge implements LongFunction<Optional<String>> {
    /** Nothing is judged yet. */
    public SharedJudge() {}

    @Override
    public Optional<String> apply(long seed) {
        return SharedNetTest.difference(seed);
    }
}
