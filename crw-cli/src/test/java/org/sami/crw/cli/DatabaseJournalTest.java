package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.replay.Replay;
import org.sami.crw.replay.ReplayedJournal;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalReader;
import org.sami.work.postgres.testing.TestDatabase;

/** What commands do with a journal in PostgreSQL is what they do with one in a file. */
@Tag("long")
@Timeout(600)
class DatabaseJournalTest {
    private static final int STILL_RUNS = 5;

    private static final List<String> RUN =
            List.of("run", "clv", "--boats", "2", "--locations", "3", "--seed", "7", "--speed", "max", "--json");

    private static final String SESSION = """
        add boat 45.4,10.9 2
        wait boats 2 within 60
        start clv
        wait decision within 60
        answer all
        wait decision within 60
        answer 45.4001,10.9;45.4001,10.9001
        wait decision within 60
        answer 1
        wait ended within 120
        note weed near the pier
        quit
        """;

    @TempDir
    private Path folder;

    private final String database = TestDatabase.address().text();

    @Test
    void runThatEndedEarlyIsResumedAsOneInAFile() throws Exception {
        String file = at("run.journal");
        List<String> reports = new ArrayList<>();
        for (String journal : List.of(file, database)) {
            assertThat(run(RUN, "--for", "30", "--journal", journal).exitCode()).isEqualTo(STILL_RUNS);
            String report = at("report-" + reports.size());
            reports.add(withoutItsTimes(crw(List.of("resume", journal, "--speed", "max", "--json"), "--report", report)
                    .out()));
        }

        assertThat(reports.get(1)).isEqualTo(reports.get(0));
        assertThat(files(folder.resolve("report-1"))).isEqualTo(files(folder.resolve("report-0")));
        assertShownAlike(file, database);
    }

    @Test
    void sessionIsCopiedToAFileAndBackWithOneHashAndReadAlikeEverywhere() throws Exception {
        String script = Files.writeString(folder.resolve("script"), SESSION).toString();
        crw(List.of("session", "--journal", database, "--script", script));
        String file = at("copy.journal");
        String again = TestDatabase.address().text();

        crw(List.of("copy-journal", database, file));
        crw(List.of("copy-journal", file, again));

        assertThat(checksum(file)).isEqualTo(checksum(database));
        assertThat(checksum(again)).isEqualTo(checksum(database));
        for (String copy : List.of(file, again)) {
            assertShownAlike(database, copy);
            assertThat(replayed(copy)).isEqualTo(replayed(database));
        }
        crw(List.of("export", database, at("of-database")));
        crw(List.of("export", file, at("of-file")));
        assertThat(files(folder.resolve("of-database")))
                .isEqualTo(files(folder.resolve("of-file")))
                .hasSizeGreaterThan(5);
    }

    private static void assertShownAlike(String one, String other) {
        for (List<String> options : List.of(
                List.<String>of(), List.of("--entries"), List.of("--at", "5"), List.of("--statistics", "--json"))) {
            String shown =
                    crw(List.of("journal", one), options.toArray(String[]::new)).out();
            assertThat(crw(List.of("journal", other), options.toArray(String[]::new))
                            .out()
                            .replace(other, one))
                    .as("journal %s", options)
                    .isEqualTo(shown)
                    .isNotBlank();
        }
    }

    /** What a window that replays it shows at its end. */
    private static List<Object> replayed(String address) throws IOException {
        ReplayedJournal journal = ReplayedJournal.open(JournalAddress.parse(address));
        Replay replay = new Replay(journal, Runnable::run, Runnable::run);
        replay.goTo(journal.timeLine().endMillis());
        return List.of(
                journal.timeLine().marks(),
                replay.models().missions().snapshot(),
                replay.models().messages().snapshot(),
                replay.models().log().snapshot());
    }

    private static CommandResult crw(List<String> command, String... more) {
        CommandResult result = run(command, more);
        assertThat(result.exitCode())
                .as("%s: %s %s", command, result.out(), result.err())
                .isZero();
        return result;
    }

    private static CommandResult run(List<String> command, String... more) {
        List<String> line = new ArrayList<>(command);
        line.addAll(List.of(more));
        return CommandResult.crw(line.toArray(String[]::new));
    }

    /** A report, but for when it was made, how long that took, and from where it was resumed. */
    private static String withoutItsTimes(String report) {
        return report.replaceAll("\"(wallSeconds|resumedFrom)\" : [^,]*,", "")
                .replaceAll("\\d{4}-\\d\\d-\\d\\dT[\\d:.]+Z", "");
    }

    private String at(String name) {
        return folder.resolve(name).toString();
    }

    private static String checksum(String address) throws IOException {
        try (JournalReader reader = JournalAddress.parse(address).read()) {
            return reader.lastIndex() + " " + reader.checksum();
        }
    }

    /** The files of a folder that other programs read, by name. */
    private static Map<String, String> files(Path of) throws IOException {
        Map<String, String> texts = new TreeMap<>();
        try (Stream<Path> all = Files.walk(of)) {
            for (Path file : all.filter(one -> one.toString().matches(".*\\.(csv|json|geojson)"))
                    .toList()) {
                texts.put(of.relativize(file).toString(), withoutItsTimes(Files.readString(file)));
            }
        }
        return texts;
    }
}
