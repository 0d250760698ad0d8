package org.sami.dreamm.tryout;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.json.DomainLibrary;

/** The way out of a round is looked for off the document's thread. */
class NextStepSearchTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final String PLAN = "clv";

    private final TryOut tryOut = new TryOut(
            new ProjectDocument(LIBRARY.vocabulary(), LIBRARY.projectOf(PLAN).orElseThrow(), Optional.empty()));
    private final Queue<Runnable> work = new ArrayDeque<>();
    private final List<Boolean> taken = new ArrayList<>();
    private final NextStepSearch steps = new NextStepSearch(tryOut, work::add, Runnable::run);

    @BeforeEach
    void start() {
        tryOut.start(PLAN);
    }

    @Test
    void whatIsExpectedIsTakenAtOnce() {
        steps.stepOn(taken::add);

        assertThat(taken).containsExactly(true);
        assertThat(work).isEmpty();
        assertThat(tryOut.steps()).isEqualTo(1);
    }

    @Test
    void whatLeadsOnOtherwiseIsLookedForOnTheWorkerAndSaidMeanwhile() {
        tryOut.setMockOperator(false);

        steps.stepOn(taken::add);

        assertThat(steps.isLooking()).isTrue();
        assertThat(tryOut.message()).startsWith("Looking for what leads on");
        assertThat(taken).isEmpty();
        steps.stepOn(taken::add);
        assertThat(work).as("one look at a time").hasSize(1);

        work.remove().run();

        assertThat(steps.isLooking()).isFalse();
        assertThat(taken).containsExactly(false);
        assertThat(tryOut.message()).contains("by hand");
    }

    @Test
    void lookThatIsStoppedTakesNothing() {
        tryOut.setMockOperator(false);
        steps.stepOn(taken::add);

        steps.cancel();

        assertThat(steps.isLooking()).isFalse();
        assertThat(tryOut.message()).contains("was stopped");
        work.remove().run();
        assertThat(taken).isEmpty();
        assertThat(tryOut.message()).contains("was stopped");
    }

    @Test
    void lookIsGivenUpWhereTheRunGoesOnByHandOrEnds() {
        tryOut.setMockOperator(false);
        steps.stepOn(taken::add);
        tryOut.setMockOperator(true);
        assertThat(tryOut.stepOn()).isTrue();

        assertThat(steps.isLooking()).isFalse();
        work.remove().run();
        assertThat(taken).isEmpty();
        assertThat(tryOut.steps()).isEqualTo(1);

        tryOut.back(1);
        tryOut.setMockOperator(false);
        steps.stepOn(taken::add);
        tryOut.stop();
        assertThat(steps.isLooking()).isFalse();
        work.remove().run();
        assertThat(taken).isEmpty();
    }
}
