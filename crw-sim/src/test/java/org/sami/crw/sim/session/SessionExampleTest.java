package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.session.api.RefusedException;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.DomainLibrary;

/** The example of docs/session.md compiles and does what it says. */
@Timeout(900)
class SessionExampleTest {
    private static final Path SOURCE =
            Path.of("src", "test", "java", "org", "sami", "crw", "sim", "session", "SessionExampleTest.java");

    private final DomainLibrary library =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    @TempDir
    private Path folder;

    @Test
    void exampleRunsAMissionAndStopsTheFleet() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            List<String> told = new CopyOnWriteArrayList<>();

            example(
                    told,
                    TestSession.address(world.boat("anna")),
                    folder.resolve("journal"),
                    JournalHeader.of("{}", Map.of(), Map.of()));

            assertThat(told).anyMatch(line -> line.startsWith("mission ") && line.endsWith(" runs"));
            assertThat(told).anyMatch(line -> line.startsWith("anna "));
        }
    }

    @Test
    void pageShowsWhatIsCompiled() throws Exception {
        String page = Files.readString(Path.of("..", "docs", "session.md"));
        String shown = page.substring(page.indexOf("```java\n") + "```java\n".length());
        List<String> lines = shown.substring(0, shown.indexOf("```"))
                .lines()
                .map(String::strip)
                .toList();

        assertThat(lines).hasSizeBetween(10, 20);
        assertThat(Files.readString(SOURCE).lines().map(String::strip).toList()).containsSequence(lines);
    }

    private void example(List<String> told, BoatAddress address, Path journal, JournalHeader header) throws Exception {
        SessionSetup setup = SessionSetup.of(
                library.vocabulary(), library.projectOf("station-keep").orElseThrow());
        try (Session session = Session.open(setup.with(SessionJournal.create(journal, header)))) {
            session.addListener((index, atMillis, input, effects, view) -> told.add(index + ": " + effects));
            session.begin();
            String boat = session.fleet().connect(address).toCompletableFuture().get();
            session.start("station-keep", "hold the bay", Map.of())
                    .thenAccept(mission -> told.add("mission " + mission + " runs"))
                    .exceptionally(fault -> {
                        told.add("refused: " + RefusedException.reason(fault));
                        return null;
                    });
            session.fleet().why(boat).thenAccept(why -> told.add(why.text()));
            session.fleet().stopAll().toCompletableFuture().get();
            session.leave();
        }
    }
}
