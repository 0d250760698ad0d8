package org.sami.spn.reference;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.LongFunction;
import org.sami.spn.testing.SpoiltClasses;

/** Judges nets of plans that are made by code of which one line is spoilt. */
final class SpoiltNets {
    private final Class<?> judge;
    private final long mostSeeds;

    /**
     * Says who judges.
     *
     * @param judge a {@code LongFunction} from a seed to what differs, with a constructor without arguments
     * @param mostSeeds that are tried, from 1 on
     */
    SpoiltNets(Class<?> judge, long mostSeeds) {
        this.judge = judge;
        this.mostSeeds = mostSeeds;
    }

    /** The first difference that the judge sees with a line of a source in place of another; empty where the spoilt line is not noticed. */
    Optional<?> difference(Path folder, Path source, String right, String wrong) throws ReflectiveOperationException {
        LongFunction<?> spoilt =
                (LongFunction<?>) SpoiltClasses.with(folder, source, right, wrong, SpoiltNets::isOfNets)
                        .loadClass(judge.getName())
                        .getConstructors()[0]
                        .newInstance();
        Optional<?> found = Optional.empty();
        for (long seed = 1; seed <= mostSeeds && found.isEmpty(); seed++) {
            found = judged(spoilt, seed);
        }
        return found;
    }

    /** Nets, and what compares them. */
    private static boolean isOfNets(String name) {
        return name.startsWith("org.sami.spn.plannet.")
                || name.startsWith("org.sami.spn.planspace.")
                || name.startsWith("org.sami.petri.")
                || name.startsWith("org.sami.spn.reference.");
    }

    /** What differs; a net that cannot be made or searched, or a run in which a robot is missing, is noticed too. */
    private static Optional<?> judged(LongFunction<?> judge, long seed) {
        try {
            return (Optional<?>) judge.apply(seed);
        } catch (IllegalArgumentException | IllegalStateException | IndexOutOfBoundsException broken) {
            return Optional.of("seed " + seed + ": " + broken);
        }
    }
}
