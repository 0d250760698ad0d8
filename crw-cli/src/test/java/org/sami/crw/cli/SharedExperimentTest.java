package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.cli.CommandResult.crw;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.spn.testing.JavaProcess;
import org.sami.work.postgres.testing.TestDatabase;

/** {@code crw experiment --workers}: processes that divide the runs of an experiment, on a real PostgreSQL. */
@Tag("long")
class SharedExperimentTest {
    private static final List<String> TABLE = List.of(
            "experiment",
            "--table",
            "7.2",
            "--boats",
            "3",
            "--locations",
            "8",
            "--area",
            "150",
            "--set",
            "alarms=1",
            "--alarm-length",
            "10",
            "--repetitions",
            "4",
            "--jobs",
            "1");
    private static final List<String> MISSIONS = List.of(
            "experiment",
            "clv",
            "--area",
            "100",
            "--locations",
            "3",
            "--seeds",
            "1..3",
            "--conditions",
            "calm,rough",
            "--jobs",
            "1");

    /** How often a worker may make a run to its end between two looks at it, on a machine that has much else to do. */
    private static final int MOST_ATTEMPTS = 10;

    /** Processes that start side by side on such a machine. */
    private static final double END_WITHIN_S = 600;

    private static final String BEGUN =
            "SELECT count(*) FROM runs WHERE result IS NULL AND worker IS NOT NULL" + " AND ends > clock_timestamp()";

    private final PostgresAddress address = TestDatabase.address();

    @TempDir
    Path folder;

    private List<String> shared(List<String> experiment, String out) {
        return with(experiment, out, "--workers", address.text());
    }

    private List<String> with(List<String> experiment, String out, String... more) {
        List<String> arguments = new ArrayList<>(experiment);
        arguments.addAll(List.of(more));
        arguments.addAll(List.of("--out", folder.resolve(out).toString()));
        return arguments;
    }

    private static CommandResult run(List<String> arguments) {
        return crw(arguments.toArray(new String[0]));
    }

    private Process start(List<String> arguments, String name) throws IOException {
        return JavaProcess.builder(folder, Crw.class, arguments.toArray(new String[0]))
                .redirectOutput(folder.resolve(name + ".out").toFile())
                .redirectError(folder.resolve(name + ".err").toFile())
                .start();
    }

    private static void end(Process process) {
        Await.until("it ends", END_WITHIN_S, () -> !process.isAlive());
    }

    /** Leaves behind what a worker leaves that is killed in the middle of a run. */
    private void killInARun() throws Exception {
        for (int attempt = 1; ; attempt++) {
            Process killed = start(shared(TABLE, "killed"), "killed");
            Await.until("a run is under way", END_WITHIN_S, () -> count(BEGUN) > 0 || !killed.isAlive());
            killed.destroyForcibly().waitFor();
            if (count("SELECT count(*) FROM runs WHERE result IS NULL AND begun = 1") == 1) {
                return;
            }
            assertThat(attempt)
                    .as(Files.readString(folder.resolve("killed.err")))
                    .isLessThan(MOST_ATTEMPTS);
            TestDatabase.run(address, "UPDATE runs SET result = NULL, begun = 0, worker = NULL, ends = '-infinity'");
        }
    }

    private long count(String sql) {
        try {
            return TestDatabase.number(address, sql);
        } catch (SQLException noTablesYet) {
            return 0;
        }
    }

    private Map<String, String> files(String out) throws IOException {
        Map<String, String> files = new TreeMap<>();
        try (var all = Files.list(folder.resolve(out))) {
            for (Path file : all.toList()) {
                files.put(file.getFileName().toString(), Files.readString(file, StandardCharsets.ISO_8859_1));
            }
        }
        return files;
    }

    @Test
    void twoWorkersMakeTheFilesOfOneWhereAThirdWasKilledInARun() throws Exception {
        run(with(TABLE, "alone"));
        killInARun();

        Process one = start(shared(TABLE, "one"), "one");
        Process other = start(shared(TABLE, "other"), "other");
        end(one);
        end(other);

        assertThat(one.exitValue())
                .as(Files.readString(folder.resolve("one.err")))
                .isZero();
        assertThat(other.exitValue()).isZero();
        assertThat(files("one")).hasSize(6).isEqualTo(files("alone"));
        assertThat(files("other")).isEqualTo(files("alone"));
        assertThat(Files.readString(folder.resolve("one.out")))
                .isEqualTo(Files.readString(folder.resolve("other.out")));
        assertThat(count("SELECT count(*) FROM runs WHERE begun = 2")).isPositive();
        assertThat(Files.readString(folder.resolve("one.err")))
                .contains("4 of 4 repetitions are made: ")
                .contains("(process " + one.pid() + ")");
    }

    @Test
    void whatAWorkerMadeBeforeItWasStoppedIsKeptAndTheNextCallGoesOn() throws Exception {
        run(with(MISSIONS, "alone.csv"));
        Process stopped = start(shared(MISSIONS, "stopped.csv"), "stopped");
        Await.until(
                "a run is made", END_WITHIN_S, () -> count("SELECT count(result) FROM runs") > 0 || !stopped.isAlive());
        stopped.destroy();
        end(stopped);
        long made = count("SELECT count(result) FROM runs");
        assertThat(count("SELECT count(*) FROM runs WHERE result IS NULL AND begun > 0"))
                .as("what it had begun is given back")
                .isZero();

        CommandResult next = run(shared(MISSIONS, "next.csv"));

        assertThat(next.exitCode()).as(next.err()).isZero();
        assertThat(next.err()).contains(made + " runs of 6 were made before").contains("6 of 6 runs ended");
        assertThat(Files.readString(folder.resolve("next.csv")))
                .isEqualTo(Files.readString(folder.resolve("alone.csv")));
    }

    @Test
    void nobodyJoinsWithOtherSettingsAndWhatDiffersIsNamed() {
        run(shared(MISSIONS, "first.csv"));
        List<String> others = new ArrayList<>(MISSIONS);
        others.set(others.indexOf("1..3"), "1..2");
        others.set(others.indexOf("100"), "120");

        CommandResult refused = run(shared(others, "refused.csv"));

        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err())
                .contains("is another one")
                .contains("seeds: 1..3 there, 1..2 here")
                .contains("clv areaM: 100.0 there, 120.0 here")
                .doesNotContain("conditions:");
    }

    @Test
    void aRunThatIsGivenUpIsAFailedRunOfTheTable() throws Exception {
        run(shared(MISSIONS, "first.csv"));
        TestDatabase.run(address, "UPDATE runs SET result = NULL, begun = 2, ends = '-infinity' WHERE run = 1");

        CommandResult shown = run(shared(MISSIONS, "shown.csv"));

        assertThat(shown.exitCode()).isEqualTo(4);
        assertThat(shown.out()).contains("clv, calm, seed 2: failed after 0 s: given up: ");
        assertThat(shown.err()).contains("1 of the runs is given up");
        assertThat(Files.readString(folder.resolve("shown.csv"))).contains("clv,calm,2,failed,given up: ");
    }

    @Test
    void anAddressWithAPasswordIsRefused() {
        CommandResult refused = run(with(MISSIONS, "no.csv", "--workers", "postgresql://me:secret@localhost/runs"));

        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err()).contains("leave the password out").doesNotContain("secret");
    }
}
