package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.host.HostPlans.number;
import static org.sami.spn.host.HostPlans.start;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/** What a host does with time and telemetry. */
class HostTimeTest extends HostOnManualExecutor {
    @Test
    void aTimerWakesTheEngineWhenItIsDue() {
        host.post(start("timer"));
        executor.runAll();
        clock.moveTo(999);
        executor.runAll();
        assertThat(inputs()).hasSize(1);

        clock.moveTo(1000);
        executor.runAll();

        assertThat(journal.entries().get(1)).isEqualTo(new JournalEntry(2, 1000, new Input.TimeReached()));
        assertThat(host.ask(EngineView::missions)).isEmpty();
    }

    @Test
    void aTimerThatEndedWakesNobody() {
        host.post(start("timer"));
        executor.runAll();
        host.post(new Input.AbortMission(1));
        executor.runAll();

        clock.moveTo(5000);
        executor.runAll();

        assertThat(inputs()).hasSize(2);
    }

    @Test
    void timeInTheJournalNeverGoesBack() {
        clock.moveTo(500);
        host.post(number(1));
        executor.runAll();
        clock.moveTo(400);
        host.post(number(2));
        executor.runAll();

        assertThat(journal.entries()).extracting(JournalEntry::atMillis).containsExactly(500L, 500L);
    }

    @Test
    void telemetryIsNoInputUnlessATransitionWaitsForIt() {
        host.postIfAwaited(pose("boat-1"));
        executor.runAll();
        assertThat(inputs()).isEmpty();

        host.post(start("watch"));
        executor.runAll();
        host.postIfAwaited(pose("boat-1"));
        executor.runAll();
        assertThat(inputs()).containsExactly(start("watch"), new Input.Received(pose("boat-1")));

        host.postIfAwaited(pose("boat-1"));
        executor.runAll();
        assertThat(inputs()).as("the mission ended, nothing waits any longer").hasSize(2);
    }

    @Test
    void onlyTheLatestTelemetryOfEachProxyWaits() {
        host.post(start("watch"));
        executor.runAll();
        for (int i = 0; i < 10; i++) {
            host.postIfAwaited(pose("boat-1"));
            host.postIfAwaited(pose("boat-2"));
        }
        executor.runAll();

        assertThat(inputs())
                .containsExactly(
                        start("watch"), new Input.Received(pose("boat-1")), new Input.Received(pose("boat-2")));
        assertThat(host.load().telemetryReplaced()).isEqualTo(18);
    }

    @Test
    void newsThatIsNoTelemetryIsAlwaysAnInput() {
        Occurrence news = Occurrence.news("News", List.of(), Map.of());
        host.postIfAwaited(news);
        executor.runAll();

        assertThat(inputs()).containsExactly(new Input.Received(news));
    }

    private static Occurrence pose(String proxy) {
        return Occurrence.news("Pose", List.of(proxy), Map.of());
    }
}
