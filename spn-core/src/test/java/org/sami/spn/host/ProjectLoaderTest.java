package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.ValueType;

/** Projects loaded into a hosted session: checked first, answered when durable, refused as a whole. */
class ProjectLoaderTest {
    private static final Project OLD = project("old");
    private static final Project MENDED = project("mended");

    @TempDir
    Path folder;

    private final ManualExecutor executor = new ManualExecutor();
    private final MemoryJournal journal = new MemoryJournal();
    private final Engine engine = new Engine(TestVocabulary.TEST, OLD);
    private final EngineState state = engine.newState();
    private final EngineHost host = EngineHost.builder(engine, state)
            .journal(journal)
            .clock(new ManualClock())
            .executor(executor)
            .build();
    private final ProjectLoader loader = new ProjectLoader(host, TestVocabulary.TEST);

    private static Project project(String place, VariableSpec... globals) {
        return NetBuilder.project(List.of(globals), plan(place).build());
    }

    private static NetBuilder plan(String place) {
        return new NetBuilder("p")
                .start(place)
                .output(place, "Approve")
                .end("end")
                .transition("yes", "Yes")
                .in(place, "yes", "generic >= 1")
                .out("yes", "end", "take all any");
    }

    private Project newest() {
        return host.ask(EngineView::project);
    }

    @Test
    void aLoadIsAnsweredWithItsVersionWhenItIsDurable() {
        CompletableFuture<ProjectLoader.Loaded> loaded = loader.load(MENDED);
        assertThat(loaded).isNotDone();

        executor.runAll();

        assertThat(loaded.join().version()).isEqualTo(OptionalInt.of(2));
        assertThat(journal.entries()).hasSize(1);
        assertThat(newest()).isEqualTo(MENDED);
    }

    @Test
    void aLoadIsRefusedInWordsWhereTheHostFailsBefore() {
        CompletableFuture<ProjectLoader.Loaded> loaded = loader.load(MENDED);
        host.fail("the disk is full");

        assertThat(loaded.join().version()).isEmpty();
        assertThat(loaded.join().findings())
                .extracting(Finding::message)
                .contains("The project is not loaded: the disk is full");
    }

    @Test
    void aFileIsReadCheckedAndLoaded() throws Exception {
        Path file = folder.resolve("mended.json");
        Files.writeString(file, new ProjectWriter(TestVocabulary.TEST).text(MENDED));

        CompletableFuture<ProjectLoader.Loaded> loaded = loader.load(file);
        executor.runAll();

        assertThat(loaded.join().version()).isEqualTo(OptionalInt.of(2));
    }

    @Test
    void aPlanWithErrorsRefusesTheWholeProjectAndNothingIsPosted() {
        Plan good = plan("good").build();
        Plan twoStarts = new NetBuilder("bad").start("a").start("b").end("e").build();

        ProjectLoader.Loaded loaded =
                loader.load(NetBuilder.project(good, twoStarts)).join();
        executor.runAll();

        assertThat(loaded.version()).isEmpty();
        assertThat(loaded.findings()).anyMatch(Finding::isError);
        assertThat(journal.entries()).isEmpty();
    }

    @Test
    void aFileThatIsNotThereRefuses() {
        ProjectLoader.Loaded loaded = loader.load(folder.resolve("none.json")).join();

        assertThat(loaded.version()).isEmpty();
        assertThat(loaded.findings())
                .singleElement()
                .satisfies(finding -> assertThat(finding.message()).contains("none.json"));
    }

    @Test
    void whatTheEngineRefusesIsAnErrorThatSaysWhy() {
        Project declared = project("old", new VariableSpec("@g", ValueType.Simple.TEXT, Optional.empty()));
        Project retyped = project("new", new VariableSpec("@g", ValueType.Simple.INTEGER, Optional.empty()));
        CompletableFuture<ProjectLoader.Loaded> first = loader.load(declared);
        host.post(new Input.StartMission("p", "p", Map.of()));

        CompletableFuture<ProjectLoader.Loaded> refused = loader.load(retyped);
        executor.runAll();

        assertThat(first.join().version()).isEqualTo(OptionalInt.of(2));
        assertThat(refused.join().version()).isEmpty();
        assertThat(refused.join().findings())
                .filteredOn(Finding::isError)
                .singleElement()
                .satisfies(
                        finding -> assertThat(finding.message()).contains("@g").contains("mission 1"));
        assertThat(newest()).isEqualTo(declared);
    }

    @Test
    void aProjectOfAnotherVocabularyIsRefused() {
        Plan drives = new NetBuilder("p")
                .start("s")
                .output("s", "Drive")
                .end("end")
                .transition("t", "Done")
                .in("s", "t", "generic >= 1")
                .out("t", "end", "take all any")
                .build();

        ProjectLoader.Loaded loaded = loader.load(new Reading<>(Optional.of(NetBuilder.project(drives)), List.of()))
                .join();

        assertThat(loaded.version()).isEmpty();
        assertThat(loaded.findings())
                .singleElement()
                .satisfies(finding -> assertThat(finding.message()).contains("another vocabulary"));
        assertThat(journal.entries()).isEmpty();
    }

    @Test
    void aSessionThatHasEndedRefuses() {
        host.close();

        ProjectLoader.Loaded loaded = loader.load(MENDED).join();

        assertThat(loaded.version()).isEmpty();
        assertThat(loaded.findings()).extracting(Finding::code).contains(ProjectLoader.REFUSED);
    }
}
