package org.sami.crw.gui.decision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;

class ShownDecisionTest {
    private static final PendingDecision FIRST = pending(1);
    private static final PendingDecision SECOND = pending(2);
    private static final PendingDecision URGENT = pending(3);

    private long now;
    private final ShownDecision shown = new ShownDecision(() -> now);

    private static PendingDecision pending(long id) {
        Decision decision = new Decision(
                id,
                1,
                id,
                "Approve",
                "Go on?",
                new Question.Approve(),
                Optional.empty(),
                OptionalLong.empty(),
                Priority.MEDIUM,
                List.of());
        return new PendingDecision(decision, 0);
    }

    private long id() {
        return shown.shown().map(one -> one.decision().id()).orElse(0L);
    }

    @Test
    void showsTheMostUrgentOne() {
        assertThat(id()).isZero();

        shown.queue(List.of(FIRST, SECOND));
        assertThat(id()).isEqualTo(1);

        shown.queue(List.of(URGENT, FIRST, SECOND));
        assertThat(id()).isEqualTo(3);
        assertThat(shown.queue()).containsExactly(URGENT, FIRST, SECOND);
    }

    @Test
    void replacesNothingWhileThePointerIsDownNorShortlyAfter() {
        shown.queue(List.of(FIRST));
        shown.pointerDown();
        shown.queue(List.of(URGENT, FIRST));
        assertThat(id()).isEqualTo(1);

        now = 5000;
        shown.pointerUp();
        now += ShownDecision.REST_MILLIS - 1;
        assertThat(shown.settle()).isFalse();
        assertThat(id()).isEqualTo(1);

        now++;
        assertThat(shown.settle()).isTrue();
        assertThat(id()).isEqualTo(3);
    }

    @Test
    void keepsOneThatWasAnsweredElsewhereUntilThePointerIsAway() {
        shown.queue(List.of(FIRST, SECOND));
        shown.pointerDown();
        shown.queue(List.of(SECOND));

        assertThat(id()).isEqualTo(1);
        assertThat(shown.isOver()).isTrue();

        shown.pointerUp();
        now += ShownDecision.REST_MILLIS;
        shown.settle();
        assertThat(id()).isEqualTo(2);
        assertThat(shown.isOver()).isFalse();
    }

    @Test
    void keepsOneThatIsWorkedOn() {
        shown.queue(List.of(FIRST));
        shown.keep();

        shown.queue(List.of(URGENT, FIRST));
        assertThat(id()).isEqualTo(1);

        shown.follow();
        assertThat(id()).isEqualTo(3);
    }

    @Test
    void browsesInACircleAndStaysThere() {
        shown.queue(List.of(FIRST, SECOND));

        shown.browse(1);
        assertThat(id()).isEqualTo(2);
        shown.queue(List.of(URGENT, FIRST, SECOND));
        assertThat(id()).isEqualTo(2);
        assertThat(shown.position()).isEqualTo(2);

        shown.browse(1);
        assertThat(id()).isEqualTo(3);
        shown.browse(-1);
        assertThat(id()).isEqualTo(2);
    }

    @Test
    void goesOnToTheNextWhenTheKeptOneWaitsNoLonger() {
        shown.queue(List.of(FIRST, SECOND));
        shown.select(2);

        shown.queue(List.of(FIRST));
        assertThat(id()).isEqualTo(1);

        shown.queue(List.of(URGENT, FIRST));
        assertThat(id()).as("follows again").isEqualTo(3);

        shown.queue(List.of());
        assertThat(id()).isZero();
        shown.browse(1);
        assertThat(id()).isZero();
    }

    @Test
    void showsADecisionAsItIsNow() {
        shown.queue(List.of(FIRST));
        PendingDecision attended = new PendingDecision(FIRST.presentation(), 0, true);

        shown.queue(List.of(attended));

        assertThat(shown.shown()).contains(attended);
    }
}
