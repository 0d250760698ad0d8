package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.message.MessageGroup;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.decision.DecisionListener;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;

class DecisionModelsTest {
    @Test
    void theHighestPriorityComesFirstThenTheOldest() {
        DecisionQueue queue = new DecisionQueue(Runnable::run);

        open(queue, decision(1, Priority.MEDIUM), 100);
        open(queue, decision(2, Priority.CRITICAL), 300);
        open(queue, decision(3, Priority.MEDIUM), 200);
        open(queue, decision(4, Priority.MEDIUM), 100);
        open(queue, decision(5, Priority.CRITICAL), 400);

        assertThat(ids(queue)).containsExactly(2L, 5L, 1L, 4L, 3L);
    }

    @Test
    void whatIsClosedWaitsNoLonger() {
        DecisionQueue queue = new DecisionQueue(Runnable::run);
        open(queue, decision(1, Priority.LOW), 10);
        open(queue, decision(2, Priority.LOW), 20);

        close(queue, 1);
        close(queue, 9);

        assertThat(ids(queue)).containsExactly(2L);
        assertThat(queue.find(1)).isEmpty();
        assertThat(queue.find(2)).map(PendingDecision::openedAtMillis).contains(20L);
    }

    @Test
    void aSnapshotDoesNotChange() {
        DecisionQueue queue = new DecisionQueue(Runnable::run);
        open(queue, decision(1, Priority.LOW), 10);
        List<PendingDecision> snapshot = queue.pending();

        close(queue, 1);

        assertThat(snapshot).hasSize(1);
        assertThat(queue.pending()).isEmpty();
    }

    @Test
    void listenersHearOfEachChangeOnceAndDoNotHarmEachOther() {
        DecisionQueue queue = new DecisionQueue(Runnable::run);
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

        open(queue, decision(1, Priority.LOW), 10);
        open(queue, decision(1, Priority.LOW), 10);
        queue.close(1, Optional.of(new Answer.YesNo(true)), Optional.of(Answerer.AUTONOMY));
        registration.close();
        open(queue, decision(2, Priority.LOW), 10);

        assertThat(heard).containsExactly("opened 1", "closed 1 by AUTONOMY");
    }

    @Test
    void aNewMessageOfLittleWeightDoesNotDisplaceAnOlderCriticalOne() {
        MessageList list = new MessageList(3, Runnable::run, new OperatorLog(Runnable::run, () -> 0), () -> 0);

        list.add(message("a", Priority.CRITICAL, ""));
        list.add(message("b", Priority.LOW, ""));
        list.add(message("c", Priority.HIGH, ""));
        list.add(message("d", Priority.HIGH, ""));
        list.publish();

        assertThat(list.messages()).extracting(OperatorMessage::text).containsExactly("a", "d", "c");
        assertThat(list.snapshot()).extracting(MessageEntry::number).containsExactly(1L, 4L, 3L);
    }

    @Test
    void aMessageReplacesTheOneWithItsKeyword() {
        MessageList list = new MessageList(10, Runnable::run, new OperatorLog(Runnable::run, () -> 0), () -> 0);

        list.add(message("boat 1 critical", Priority.CRITICAL, "comm-1"));
        list.add(message("boat 2 critical", Priority.CRITICAL, "comm-2"));
        list.acknowledge(1);
        list.add(message("boat 1 nominal", Priority.LOW, "comm-1"));
        list.publish();

        assertThat(list.messages())
                .extracting(OperatorMessage::text)
                .containsExactly("boat 2 critical", "boat 1 nominal");
        assertThat(list.snapshot()).extracting(MessageEntry::acknowledged).containsExactly(false, false);
    }

    @Test
    void aMessageOfOneBoatDoesNotReplaceThatOfAnotherWithItsKeyword() {
        MessageList list = new MessageList(10, Runnable::run, new OperatorLog(Runnable::run, () -> 0), () -> 0);

        list.add(about("anna", "lost", Priority.CRITICAL));
        list.add(about("bert", "lost", Priority.CRITICAL));
        list.publish();
        list.acknowledge(2);
        list.add(about("anna", "is back", Priority.LOW));
        list.publish();

        assertThat(list.messages()).extracting(OperatorMessage::text).containsExactly("bert lost", "anna is back");
        MessageGroup group = list.groups().get(0);
        assertThat(group.keyword()).isEqualTo("link");
        assertThat(group.count()).isEqualTo(3);
        assertThat(group.unacknowledged()).isEqualTo(1);
        assertThat(group.newest().message().text()).isEqualTo("anna is back");
        assertThat(group.boats()).containsExactly("bert", "anna");
    }

    private static OperatorMessage about(String boat, String what, Priority priority) {
        List<String> boats = List.of(boat);
        MapRelevance map = new MapRelevance(
                Optional.of(new MapRelevance.Boats(boats, false, false, false)), Optional.empty(), Optional.empty());
        return new OperatorMessage(0, 1, OperatorMessage.Source.PLAN, priority, boat + " " + what, boats, "link", map);
    }

    @Test
    void aMessageIsAcknowledgedAndItsKeywordMutedForThoseThatCome() {
        MessageList list = new MessageList(10, Runnable::run, new OperatorLog(Runnable::run, () -> 0), () -> 0);
        List<List<MessageEntry>> heard = new ArrayList<>();
        list.addListener(heard::add);
        list.add(message("boat 1 critical", Priority.CRITICAL, "comm-1"));
        list.publish();

        list.acknowledge(1);
        list.mute("comm-1", true);
        list.publish();
        list.add(message("boat 1 still critical", Priority.CRITICAL, "comm-1"));
        list.publish();

        assertThat(heard).hasSize(3);
        assertThat(heard.get(1)).singleElement().satisfies(entry -> {
            assertThat(entry.acknowledged()).isTrue();
            assertThat(entry.muted()).isTrue();
        });
        assertThat(heard.get(2)).singleElement().satisfies(entry -> {
            assertThat(entry.message().text()).isEqualTo("boat 1 still critical");
            assertThat(entry.acknowledged()).isFalse();
            assertThat(entry.muted()).isTrue();
        });
        assertThatThrownBy(() -> list.mute("", true)).hasMessageContaining("keyword");
    }

    @Test
    void aListThatKeepsNothingIsRefused() {
        assertThatThrownBy(() -> new MessageList(0, Runnable::run, new OperatorLog(Runnable::run, () -> 0), () -> 0))
                .hasMessageContaining("0");
    }

    private static void open(DecisionQueue queue, Decision decision, long atMillis) {
        queue.open(new PendingDecision(decision, atMillis));
        queue.publish();
    }

    private static void close(DecisionQueue queue, long decision) {
        queue.close(decision, Optional.empty(), Optional.empty());
        queue.publish();
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
