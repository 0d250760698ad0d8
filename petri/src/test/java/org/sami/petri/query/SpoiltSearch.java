package org.sami.petri.query;

import java.nio.file.Path;
import java.util.function.LongConsumer;
import org.sami.spn.testing.SpoiltClasses;

/** Searches and proofs of which one line is spoilt, before a judge of random nets. */
final class SpoiltSearch {
    private static final Path SOURCES = Path.of("src/main/java/org/sami/petri");
    private static final int MOST_SEEDS = 2_000;
    private static final int SEEDS_OF_THE_RIGHT = 200;

    private SpoiltSearch() {}

    /** Has a judge look at nets with the code as it is: it throws where something differs. */
    static void judgeTheRight(LongConsumer judge) {
        for (long seed = 0; seed < SEEDS_OF_THE_RIGHT; seed++) {
            judge.accept(seed);
        }
    }

    /**
     * Whether a judge sees a difference with a line of a source in place of another.
     *
     * @param judge a {@code LongConsumer} of seeds that throws where something differs, with a constructor without arguments
     */
    static boolean isNoticed(Path folder, Class<?> judge, String source, String right, String wrong)
            throws ReflectiveOperationException {
        LongConsumer spoilt = (LongConsumer) SpoiltClasses.with(
                        folder,
                        SOURCES.resolve(source + ".java"),
                        right,
                        wrong,
                        name -> name.startsWith("org.sami.petri."))
                .loadClass(judge.getName())
                .getConstructors()[0]
                .newInstance();
        boolean isNoticed = false;
        for (long seed = 0; seed < MOST_SEEDS && !isNoticed; seed++) {
            isNoticed = isNoticed(spoilt, seed);
        }
        return isNoticed;
    }

    /** A net that cannot be searched any more is a difference too. */
    private static boolean isNoticed(LongConsumer judge, long seed) {
        try {
            judge.accept(seed);
            return false;
        } catch (AssertionError | IllegalArgumentException | IllegalStateException | IndexOutOfBoundsException broken) {
            return true;
        }
    }
}
