package org.sami.spn.reference;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongFunction;

/**
 * Holds the nets of a seed's random plans to the engine: the graph of one that abstracts nothing, and a session of another one. Loaded a second time, next to a spoilt
 * translation, by {@link SpoiltTranslationTest}.
 */
public final class NetJudge implements LongFunction<Optional<String>> {
    /** Nothing is judged yet. */
    public NetJudge() {}

    @Override
    public Optional<String> apply(long seed) {
        return ExactNetTest.difference(seed)
                .or(() -> PlanNetDifferentialTest.difference(seed, new AtomicLong(), new AtomicLong()));
    }
}
