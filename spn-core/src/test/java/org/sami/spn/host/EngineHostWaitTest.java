package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.host.HostPlans.number;
import static org.sami.spn.host.HostPlans.start;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostStatus.Kind;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** What a host does while its journal cannot be written, with an executor and a clock that the test turns by hand. */
class EngineHostWaitTest {
    private static final String FULL = "the journal cannot be written: the disk is full";

    private final List<String> log = new ArrayList<>();
    private final WatchedJournal journal = new WatchedJournal(log);
    private final ManualExecutor executor = new ManualExecutor();
    private final ManualClock clock = new ManualClock();
    private final Engine engine = HostPlans.engine();
    private final EngineState state = engine.newState();
    private final EngineHost host = builder().build();

    private EngineHostBuilder builder() {
        return EngineHostBuilder.of(engine, state).journal(journal).clock(clock).executor(executor);
    }

    private void listen() {
        host.addListener(new HostListener() {
            @Override
            public void onStep(long index, long at, Input input, List<Effect> effects, EngineView view) {
                log.add("heard " + index + " at " + at);
            }

            @Override
            public void onWaiting(HostStatus status) {
                log.add("waits: " + status.reason());
            }

            @Override
            public void onGoingOn() {
                log.add("goes on");
            }

            @Override
            public void onFailed(HostStatus status) {
                log.add("failed: " + status.reason());
            }
        });
    }

    private void passTo(long millis) {
        clock.moveTo(millis);
        executor.runAll();
    }

    @Test
    void nothingLeavesWhileTheJournalRefusesAndAllOfItInOrderWhenItTakesAgain() {
        listen();
        host.register("Do", (activation, context) -> log.add("handled"), Runnable::run);
        journal.refuseForNow();
        host.post(start("Do"));
        executor.runAll();
        host.post(number(2));
        executor.runAll();

        assertThat(host.status()).isEqualTo(new HostStatus(Kind.WAITING, FULL));
        assertThat(log).containsExactly("waits: " + FULL);

        passTo(1000); // still full, which is told once
        assertThat(log).containsExactly("waits: " + FULL);

        journal.accept();
        passTo(2000);

        assertThat(host.status().kind()).isEqualTo(Kind.RUNNING);
        assertThat(log)
                .containsExactly(
                        "waits: " + FULL,
                        "recovered",
                        "append to 1 PROCESS",
                        "goes on",
                        "heard 1 at 0",
                        "handled",
                        "snapshot offered",
                        "append to 2 PROCESS",
                        "heard 2 at 2000",
                        "snapshot offered");
    }

    @Test
    void timersThatCameDueMeanwhileEndWhenItGoesOn() {
        host.post(start("timer"));
        executor.runAll();
        journal.refuseForNow();
        passTo(1000);
        assertThat(host.status().kind()).isEqualTo(Kind.WAITING);
        journal.accept();
        passTo(5000);

        int running = host.ask(view -> view.missions().size());
        assertThat(running).isZero();
    }

    @Test
    void whoAsksIsAnsweredWhileItWaits() {
        journal.refuseForNow();
        host.post(number(1));
        executor.runAll();

        assertThat(host.ask(EngineView::globals)).containsKey("@n");
    }

    @Test
    void aJournalThatFailsByItselfIsNoticedWithoutAnInput() {
        listen();
        journal.refuseForNow();
        host.checkJournal();
        executor.runAll();
        assertThat(log).containsExactly("waits: " + FULL);

        journal.accept();
        passTo(1000);
        assertThat(log).contains("goes on");
        assertThat(journal.entries()).isEmpty();
    }

    @Test
    void itsPatienceEnds() {
        try (EngineHost hasty = builder().journalRetryMillis(3000).build()) {
            journal.refuseForNow();
            hasty.post(number(1));
            executor.runAll();
            passTo(1000);
            passTo(2000);
            assertThat(hasty.status().kind()).isEqualTo(Kind.WAITING);
            passTo(3000);

            assertThat(hasty.status())
                    .isEqualTo(new HostStatus(Kind.FAILED, FULL + "; it could not be written for 3 s"));
            assertThat(hasty.post(number(2))).isFalse();
        }
    }

    @Test
    void moreThanItCanKeepStopsIt() {
        journal.refuseForNow();
        host.post(number(1));
        executor.runAll();
        List<Input> many = Collections.nCopies(60_000, number(7));

        assertThat(host.post(many)).isTrue();
        assertThat(host.post(many)).isFalse();
        assertThat(host.status().reason()).isEqualTo(FULL + "; more than 100000 inputs wait for it");
    }

    @Test
    void closedWhileItWaitsItSaysHowMuchIsNotInTheJournal() {
        journal.refuseForNow();
        host.post(number(1));
        executor.runAll();
        host.post(List.of(number(2), number(3)));
        host.close();

        assertThat(host.status()).isEqualTo(new HostStatus(Kind.FAILED, FULL + "; the last 3 inputs are not in it"));
    }

    @Test
    void closedWhenThereIsRoomAgainItLosesNothing() {
        journal.refuseForNow();
        host.post(number(1));
        executor.runAll();
        host.post(number(2));
        journal.accept();
        host.close();

        assertThat(host.status().kind()).isEqualTo(Kind.CLOSED);
        assertThat(journal.entries()).hasSize(2);
    }

    @Test
    void anErrorOfTheEngineOrOfAListenerStopsItInWords() {
        listen();
        host.addListener((index, at, input, effects, view) -> {
            throw new OutOfMemoryError("Java heap space");
        });
        host.post(number(1));
        executor.runAll();

        assertThat(host.status())
                .isEqualTo(new HostStatus(
                        Kind.FAILED,
                        "the engine met an error",
                        "at entry 2 or after: java.lang.OutOfMemoryError: Java heap space"));
        assertThat(log).contains("failed: " + host.status().reason());
    }

    @Test
    void itIsStoppedForAFaultThatWasFoundElsewhereAndToldOnce() {
        listen();
        host.fail("the fleet's thread has no memory left");
        host.fail("again");
        executor.runAll();

        assertThat(log).containsExactly("failed: the fleet's thread has no memory left");
        assertThat(host.post(number(1))).isFalse();
    }
}
