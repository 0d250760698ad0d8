package org.sami.dreamm.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.replay.PlanReplay.Moment;
import org.sami.dreamm.tryout.Breakpoint;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.replay.JournalRun;

/** A journal that a session wrote, on the plans that an author has. */
class PlanReplayTest {
    private static final String DOMAIN = "/org/sami/domain/crw";
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath(DOMAIN).orThrow();
    private static final Project PROJECT = LIBRARY.projectOf("clv").orElseThrow();
    private static final Plan PLAN = PROJECT.plan("clv").orElseThrow();

    @TempDir
    private Path folder;

    private Path file;
    private PlanReplay replay;

    @BeforeEach
    void write() throws IOException {
        file = RecordedSession.write(folder.resolve("session.journal"));
        replay = new PlanReplay(JournalRun.open(file));
    }

    @Test
    void tokensStandWhereTheyStoodForwardsAndBack() {
        String start = PLAN.startPlace().orElseThrow().id();

        assertThat(replay.goTo(500).missions()).isEmpty();
        Moment begun = replay.goTo(1500);
        assertThat(begun.mission("clv").orElseThrow().name()).isEqualTo("Visit");
        assertThat(begun.mission("clv").orElseThrow().marking().tokens()).containsOnlyKeys(start);
        Moment chosen = replay.goTo(9000);
        assertThat(chosen.mission("clv").orElseThrow().marking().tokens()).doesNotContainKey(start);
        assertThat(chosen.fired()).isNotEmpty();

        assertThat(replay.goTo(1500)).isEqualTo(begun);
        assertThat(replay.goTo(0).missions()).isEmpty();
        assertThat(replay.journal().timeLine().endMillis()).isEqualTo(5000);
        assertThat(replay.journal().timeLine().marks())
                .extracting(mark -> mark.text())
                .contains("Visit starts", "decision 1 answered by operator");
    }

    @Test
    void playingOnStopsBehindTheEntryThatMeetsABreakpoint() {
        Breakpoint start = new Breakpoint("clv", PLAN.startPlace().orElseThrow().id());
        replay.goTo(0);

        Moment stopped = replay.goOn(9000, Set.of(start));

        assertThat(stopped.stopped()).contains(start);
        assertThat(stopped.atMillis()).isEqualTo(1000);
        assertThat(replay.goOn(9000, Set.of(start)).stopped()).isEmpty();
        assertThat(replay.journal().taken()).isEqualTo(4);
    }

    @Test
    void planThatIsNotAsItWasIsSaidToBeSo() {
        assertThat(replay.difference(PLAN)).isEmpty();
        assertThat(replay.difference(PLAN.withLayout(Map.of()))).isEmpty();
        assertThat(replay.difference(PLAN.withTransitions(PLAN.transitions().subList(1, 3))))
                .hasValueSatisfying(
                        text -> assertThat(text).contains("clv", "not as it was in the session", "transitions differ"));
        assertThat(replay.difference(LIBRARY.projectOf("measure")
                        .orElseThrow()
                        .plan("measure")
                        .orElseThrow()))
                .hasValueSatisfying(text -> assertThat(text).contains("no plan measure"));
    }

    @Test
    void fileThatIsNoJournalIsRefusedWithItsName() throws IOException {
        Path text = folder.resolve("notes.txt");
        Files.writeString(text, "no journal");

        assertThatThrownBy(() -> JournalRun.open(text))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("notes.txt");
        assertThatThrownBy(() -> JournalRun.open(folder.resolve("absent")))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("absent");
    }
}
