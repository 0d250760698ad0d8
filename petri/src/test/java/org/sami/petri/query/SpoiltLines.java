package org.sami.petri.query;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.function.LongConsumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Lines of the program that are spoilt one at a time, and judges of random nets that have to notice each of them. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
abstract class SpoiltLines {
    private final int least;
    private final List<LongConsumer> judges;

    /**
     * Lines of which there are some.
     *
     * @param least how many at least, so that none gets lost
     * @param judges who judge them
     */
    SpoiltLines(int least, LongConsumer... judges) {
        this.least = least;
        this.judges = List.of(judges);
    }

    /** What is spoilt, who judges, the class, the line and what it becomes. */
    abstract Stream<Arguments> lines();

    @Test
    void manyLinesAreSpoilt() {
        assertThat(lines()).hasSizeGreaterThanOrEqualTo(least);
        assertThat(lines().map(row -> row.get()[0])).doesNotHaveDuplicates();
    }

    @Test
    void theRightLinesAgree() {
        judges.forEach(SpoiltSearch::judgeTheRight);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("lines")
    void disagreesSoon(String spoilt, Class<?> judge, String source, String right, String wrong, @TempDir Path folder)
            throws ReflectiveOperationException {
        assertThat(SpoiltSearch.isNoticed(folder, judge, source, right, wrong))
                .as(spoilt)
                .isTrue();
    }
}
