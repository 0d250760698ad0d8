package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostPlans;
import org.sami.spn.host.HostStatus;
import org.sami.spn.host.ManualClock;
import org.sami.spn.host.ManualExecutor;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ValueType;

/** Sessions that load projects, killed after any of their entries and taken up from their journals. */
class ProjectLoadResumeTest {
    private static final Project OLD = project("old", 1);
    private static final Input MENDED = load(project("mended", 2));
    private static final Input THIRD = load(project("third", 3));

    /** Loads between missions and under them, the same project twice, one that cannot be loaded, and none at all. */
    private static final List<Input> INPUTS = List.of(
            new Input.ProxyJoined("b1"),
            start(),
            MENDED,
            start(),
            new Input.SetVariable(Ids.NONE, "@n", new IntegerValue(7)),
            THIRD,
            new Input.LoadProject("no project"),
            start(),
            done(1),
            MENDED,
            MENDED,
            done(2),
            start(),
            new Input.AbortMission(3),
            done(4));

    @TempDir
    Path folder;

    private final Engine engine = new Engine(HostPlans.VOCABULARY, OLD);
    private final List<Effect> effects = new ArrayList<>();

    private static Project project(String place, long n) {
        Plan plan = new NetBuilder("p")
                .start(place)
                .output(place, "Do")
                .places("after-" + place)
                .transition("done", "Done")
                .in(place, "done", "generic >= 1")
                .out("done", "after-" + place, "take all any")
                .build();
        VariableSpec global = new VariableSpec("@n", ValueType.Simple.INTEGER, Optional.of(new IntegerValue(n)));
        return NetBuilder.project(List.of(global), plan);
    }

    private static Input load(Project project) {
        return new Input.LoadProject(new ProjectWriter(HostPlans.VOCABULARY).text(project));
    }

    private static Input start() {
        return new Input.StartMission("p", "p", Map.of());
    }

    private static Input done(long activation) {
        return new Input.Received(new Occurrence("Done", activation, activation, List.of("b1"), List.of(), Map.of()));
    }

    /** Hosts the session for so many more inputs. */
    private byte[] run(SqliteJournal journal, EngineState state, List<Input> inputs) {
        ManualExecutor executor = new ManualExecutor();
        EngineHost host = EngineHostBuilder.of(engine, state)
                .journal(journal)
                .clock(new ManualClock())
                .executor(executor)
                .batchLimit(1)
                .build();
        host.addListener((index, at, input, ofStep, view) -> effects.addAll(ofStep));
        host.register("Do", (activation, context) -> {}, executor);
        host.resume();
        inputs.forEach(host::post);
        executor.runAll();
        assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.RUNNING);
        return StateCodec.encode(state);
    }

    @Test
    void theSessionHasMissionsOfThreeProjectsAtOnce() throws IOException {
        try (SqliteJournal journal = SqliteJournal.create(folder.resolve("j"), header(), options(0))) {
            EngineState state = engine.newState();
            run(journal, state, INPUTS.subList(0, 8));
            assertThat(engine.view(state).missions())
                    .extracting(m -> m.projectVersion() + " " + m.marking().keySet())
                    .containsExactly("1 [old]", "2 [mended]", "3 [third]");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 4})
    void aSessionThatDiedAfterAnyEntryGoesOnAsIfNothingHadHappened(int snapshotEvery) throws IOException {
        byte[] whole;
        try (SqliteJournal journal = SqliteJournal.create(folder.resolve("whole"), header(), options(snapshotEvery))) {
            whole = run(journal, engine.newState(), INPUTS);
        }
        List<Effect> wholeEffects = List.copyOf(effects);
        for (int crash = 0; crash <= INPUTS.size(); crash++) {
            effects.clear();
            Path died = folder.resolve("died-" + crash);
            Path live = folder.resolve("live-" + crash);
            try (SqliteJournal journal = SqliteJournal.create(live, header(), options(snapshotEvery))) {
                run(journal, engine.newState(), INPUTS.subList(0, crash));
                Files.copy(live, died);
                if (Files.exists(Database.log(live))) {
                    Files.copy(Database.log(live), Database.log(died));
                }
            }
            try (SqliteJournal journal = SqliteJournal.open(died, options(snapshotEvery))) {
                assertThat(journal.recovery().damage()).isEmpty();
                assertThat(journal.lastIndex()).isEqualTo(crash);
                assertThat(run(journal, journal.restore(engine), INPUTS.subList(crash, INPUTS.size())))
                        .as("died after %d", crash)
                        .isEqualTo(whole);
                assertThat(effects).as("died after %d", crash).isEqualTo(wholeEffects);
            }
        }
    }

    private static JournalHeader header() {
        return JournalHeader.of("the old project", Map.of("domain.json", "its words"), Map.of());
    }

    private static JournalOptions options(int snapshotEvery) {
        return JournalOptions.DEFAULT.withSnapshotEvery(snapshotEvery).withoutSync();
    }
}
