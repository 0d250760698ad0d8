package org.sami.crw.proxy.queue;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Stop;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

class CommandQueueTest {
    private static final List<Priority> PRIORITIES = List.of(Priority.values());

    private final CommandQueue queue = new CommandQueue();

    private static FollowPath path(String id, long mission, Priority priority) {
        return FollowPath.goTo(id, mission, 1, GeoPoint.of(45, 10), priority);
    }

    private Map<BoatCommand, Withdrawal> submit(String id, long mission, Priority priority) {
        return queue.submit(path(id, mission, priority));
    }

    private String current() {
        return queue.current().map(queued -> queued.command().commandId()).orElse("none");
    }

    private List<String> waiting() {
        return queue.waiting().stream()
                .map(queued -> queued.command().commandId())
                .toList();
    }

    private void finish() {
        queue.finish(queue.current().orElseThrow());
    }

    @Test
    void runsCommandsOfOnePriorityInOrderOfSubmission() {
        submit("a", 1, Priority.MEDIUM);
        submit("b", 2, Priority.MEDIUM);
        submit("c", 3, Priority.MEDIUM);

        assertThat(current()).isEqualTo("a");
        assertThat(waiting()).containsExactly("b", "c");
        finish();
        assertThat(current()).isEqualTo("b");
        finish();
        finish();
        assertThat(current()).isEqualTo("none");
    }

    @Test
    void higherPriorityHasItsTurnFirst() {
        submit("running", 1, Priority.HIGH);
        submit("low", 2, Priority.LOW);
        submit("medium", 3, Priority.MEDIUM);
        submit("high", 4, Priority.HIGH);

        assertThat(current()).isEqualTo("running");
        assertThat(waiting()).containsExactly("high", "medium", "low");
    }

    @Test
    void higherPriorityWithdrawsWhatRuns() {
        submit("a", 1, Priority.LOW);
        submit("b", 2, Priority.LOW);

        assertThat(submit("c", 3, Priority.HIGH))
                .containsExactly(Map.entry(path("a", 1, Priority.LOW), Withdrawal.PREEMPTED));
        assertThat(current()).isEqualTo("c");
        assertThat(waiting()).containsExactly("b");
    }

    @Test
    void criticalRunsNowAndWhatItInterruptedReturns() {
        submit("a", 1, Priority.HIGH);
        submit("b", 2, Priority.HIGH);
        queue.current().orElseThrow().visitedUpTo(1);

        assertThat(submit("c", 3, Priority.CRITICAL)).isEmpty();
        assertThat(current()).isEqualTo("c");
        assertThat(waiting()).containsExactly("a", "b");
        assertThat(queue.waiting().get(0).isInterrupted()).isTrue();
        submit("d", 4, Priority.CRITICAL);
        assertThat(current()).isEqualTo("c");
        finish();
        assertThat(current()).isEqualTo("d");
        finish();

        assertThat(current()).isEqualTo("a");
        assertThat(queue.current().orElseThrow().isInterrupted()).isFalse();
        assertThat(queue.current().orElseThrow().visited()).isEqualTo(1);
    }

    @Test
    void newerCommandOfAMissionTakesThePlaceOfItsOlderOne() {
        submit("a1", 1, Priority.MEDIUM);
        submit("b1", 2, Priority.MEDIUM);

        assertThat(submit("b2", 2, Priority.LOW))
                .containsValue(Withdrawal.SUPERSEDED)
                .hasSize(1);
        assertThat(submit("a2", 1, Priority.MEDIUM))
                .containsValue(Withdrawal.SUPERSEDED)
                .hasSize(1);

        assertThat(current()).isEqualTo("a2");
        assertThat(waiting()).containsExactly("b2");
    }

    @Test
    void criticalCommandOfTheSameMissionInterruptsToo() {
        submit("path", 1, Priority.MEDIUM);
        assertThat(submit("now", 1, Priority.CRITICAL)).isEmpty();
        assertThat(current()).isEqualTo("now");
        assertThat(submit("path2", 1, Priority.MEDIUM)).containsValue(Withdrawal.SUPERSEDED);
        assertThat(current()).isEqualTo("now");
        finish();

        assertThat(current()).isEqualTo("path2");
    }

    @Test
    void clearedBlockGivesOthersTheirTurnAgainAndTakesNoCommandBack() {
        queue.submit(new Stop("block", 1, 1, Priority.LOW, true));
        finish();
        submit("other", 2, Priority.MEDIUM);
        assertThat(current()).isEqualTo("none");

        assertThat(queue.unblock()).containsExactly(1L);

        assertThat(current()).isEqualTo("other");
        assertThat(queue.blockedBy()).isEmpty();
        assertThat(queue.unblock()).isEmpty();
    }

    @Test
    void restoredBlocksHaveWhatTheyDoNotAllowWaitAgain() {
        queue.submit(new Stop("other", 3, 3, Priority.HIGH, true));
        submit("own", 2, Priority.LOW);
        assertThat(current()).isEqualTo("other");

        queue.restoreBlocks(List.of(1L, 2L));

        assertThat(current()).isEqualTo("own");
        assertThat(queue.blocks()).containsExactly(1L, 2L);
        queue.withdraw(2L);
        queue.withdraw(1L);
        assertThat(current()).isEqualTo("other");
        assertThat(queue.blocks()).containsExactly(3L);
    }

    @Test
    void idThatIsQueuedAlreadyIsIgnored() {
        submit("a", 1, Priority.MEDIUM);

        assertThat(submit("a", 1, Priority.HIGH)).isEmpty();
        assertThat(queue.size()).isEqualTo(1);
        assertThat(queue.current().orElseThrow().command().priority()).isEqualTo(Priority.MEDIUM);
    }

    @Test
    void blockKeepsTheBoatUntilItsMissionIsWithdrawn() {
        queue.submit(new Stop("block", 1, 1, Priority.LOW, true));
        submit("other", 2, Priority.HIGH);
        assertThat(current()).isEqualTo("block");
        finish();

        assertThat(current()).isEqualTo("none");
        assertThat(queue.blockedBy()).contains(1L);
        submit("own", 1, Priority.LOW);
        assertThat(current()).isEqualTo("own");
        finish();
        submit("critical", 3, Priority.CRITICAL);
        assertThat(current()).isEqualTo("critical");
        finish();
        assertThat(current()).isEqualTo("none");

        assertThat(queue.withdraw(1)).isEmpty();
        assertThat(current()).isEqualTo("other");
        assertThat(queue.blockedBy()).isEmpty();
    }

    @Test
    void blockBeginsWhenItsCommandRuns() {
        submit("a", 1, Priority.HIGH);
        queue.submit(new Stop("block", 2, 1, Priority.LOW, true));

        assertThat(queue.blockedBy()).isEmpty();
        finish();
        assertThat(queue.blockedBy()).contains(2L);
    }

    @Test
    void withdrawingAMissionLeavesTheOthers() {
        submit("a", 1, Priority.MEDIUM);
        submit("b", 2, Priority.MEDIUM);
        submit("a-critical", 1, Priority.CRITICAL);

        assertThat(queue.withdraw(1)).extracting(BoatCommand::commandId).containsExactly("a", "a-critical");
        assertThat(current()).isEqualTo("b");
        assertThat(queue.withdraw(1)).isEmpty();
    }

    @Test
    void whatRunsIsAlwaysFirstAmongWhatMayRun() {
        SplittableRandom random = new SplittableRandom(21);
        for (int i = 0; i < 20_000; i++) {
            long mission = random.nextInt(6);
            int choice = random.nextInt(10);
            if (choice < 6) {
                Priority priority = PRIORITIES.get(random.nextInt(4));
                BoatCommand command = random.nextInt(5) == 0
                        ? new Stop("c" + i, mission, 1, priority, true)
                        : path("c" + i, mission, priority);
                queue.submit(command);
            } else if (choice < 8) {
                queue.current().ifPresent(queue::finish);
            } else {
                queue.withdraw(mission);
            }

            queue.current()
                    .ifPresent(now -> assertThat(queue.waiting()).allSatisfy(later -> {
                        boolean mayRun = later.isCritical()
                                || queue.blockedBy().isEmpty()
                                || queue.blockedBy().get() == later.command().mission();
                        assertThat(mayRun
                                        && later.command()
                                                        .priority()
                                                        .compareTo(now.command().priority())
                                                > 0)
                                .isFalse();
                    }));
            assertThat(queue.size()).isLessThanOrEqualTo(12);
        }
    }
}
