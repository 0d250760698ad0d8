package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;

class DecisionModelsTest {
    @Test
    void theHighestPriorityComesFirstThenTheOldest() {
        DecisionQueue queue = new DecisionQueue();

        queue.open(decision(1, Priority.MEDIUM), 100);
        queue.open(decision(2, Priority.CRITICAL), 300);
        queue.open(decision(3, Priority.MEDIUM), 200);
        queue.open(decision(4, Priority.MEDIUM), 100);
        queue.open(decision(5, Priority.CRITICAL), 400);

        assertThat(ids(queue)).containsExactly(2L, 5L, 1L, 4L, 3L);
    }

    @Test
    void whatIsClosedWaitsNoLonger() {
        DecisionQueue queue = new DecisionQueue();
        queue.apply(new Effect.DecisionOpened(decision(1, Priority.LOW)), 10);
        queue.apply(new Effect.DecisionOpened(decision(2, Priority.LOW)), 20);

        queue.apply(new Effect.DecisionClosed(1, Optional.empty(), Optional.empty()), 30);
        queue.apply(new Effect.DecisionClosed(9, Optional.empty(), Optional.empty()), 30);

        assertThat(ids(queue)).containsExactly(2L);
        assertThat(queue.find(1)).isEmpty();
        assertThat(queue.find(2)).map(PendingDecision::openedAtMillis).contains(20L);
    }

    @Test
    void aSnapshotDoesNotChange() {
        DecisionQueue queue = new DecisionQueue();
        queue.open(decision(1, Priority.LOW), 10);
        List<PendingDecision> snapshot = queue.pending();

        queue.close(1, Optional.empty(), Optional.empty());

        assertThat(snapshot).hasSize(1);
        assertThat(queue.pending()).isEmpty();
    }

    @Test
    void listenersHearOfEachChangeOnceAndDoNotHarmEachOther() {
        DecisionQueue queue = new DecisionQueue();
        List<String> heard = new ArrayList<>();
        queue.addListener(new DecisionListener() {
            @Override
            public void opened(PendingDecision decision) {
                throw new IllegalStateException("a listener that fails");
            }

            @Override
            public void closed(PendingDecision decision, Optional<Answer> answer, Optional<Answerer> by) {}
        });
        Registration registration = queue.addListener(recording(heard));

        queue.open(decision(1, Priority.LOW), 10);
        queue.open(decision(1, Priority.LOW), 10);
        queue.close(1, Optional.of(new Answer.YesNo(true)), Optional.of(Answerer.AUTONOMY));
        registration.close();
        queue.open(decision(2, Priority.LOW), 10);

        assertThat(heard).containsExactly("opened 1", "closed 1 by AUTONOMY");
    }

    @Test
    void aNewMessageOfLittleWeightDoesNotDisplaceAnOlderCriticalOne() {
        MessageList list = new MessageList(3);

        list.add(message("a", Priority.CRITICAL, ""));
        list.add(message("b", Priority.LOW, ""));
        list.add(message("c", Priority.HIGH, ""));
        list.add(message("d", Priority.HIGH, ""));

        assertThat(list.messages()).extracting(OperatorMessage::text).containsExactly("a", "d", "c");
        assertThat(list.told()).isEqualTo(4);
    }

    @Test
    void aMessageReplacesTheOneWithItsKeyword() {
        MessageList list = new MessageList(10);
        List<String> heard = new ArrayList<>();
        Consumer<OperatorMessage> ear = message -> heard.add(message.text());
        list.addListener(ear);

        list.add(message("boat 1 critical", Priority.CRITICAL, "comm-1"));
        list.add(message("boat 2 critical", Priority.CRITICAL, "comm-2"));
        list.add(message("boat 1 nominal", Priority.LOW, "comm-1"));

        assertThat(list.messages())
                .extracting(OperatorMessage::text)
                .containsExactly("boat 2 critical", "boat 1 nominal");
        assertThat(heard).hasSize(3);
    }

    @Test
    void aListThatKeepsNothingIsRefused() {
        assertThatThrownBy(() -> new MessageList(0)).hasMessageContaining("0");
    }

    private static DecisionListener recording(List<String> heard) {
        return new DecisionListener() {
            @Override
            public void opened(PendingDecision decision) {
                heard.add("opened " + decision.decision().id());
            }

            @Override
            public void closed(PendingDecision decision, Optional<Answer> answer, Optional<Answerer> by) {
                heard.add("closed " + decision.decision().id() + " by "
                        + by.map(Enum::name).orElse("nobody"));
            }
        };
    }

    private static List<Long> ids(DecisionQueue queue) {
        return queue.pending().stream().map(pending -> pending.decision().id()).toList();
    }

    private static OperatorMessage message(String text, Priority priority, String keyword) {
        return new OperatorMessage(0, 1, OperatorMessage.Source.PLAN, priority, text, List.of(), keyword);
    }

    private static Decision decision(long id, Priority priority) {
        return new Decision(
                id,
                1,
                1,
                "OperatorApprove",
                "Go on?",
                new Question.Approve(),
                Optional.empty(),
                OptionalLong.empty(),
                priority,
                List.of());
    }
}
