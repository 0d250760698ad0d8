package org.sami.crw.cli.pair;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CrwProcess;
import org.sami.pair.postgres.PairDatabase;
import org.sami.pair.postgres.PairFolder;
import org.sami.pair.postgres.Programs;
import org.sami.session.client.testing.TwoNetworks;

/** Two bases that {@code crw pair} made, each with its own folder and database, and what runs on them. Databases are stopped at the end. */
final class PairedProcesses implements AutoCloseable {
    private static final double AT_MOST_S = 120;
    private static final long COMMAND_S = 120;
    private static final String PASSWORDS = "pgpass";

    private static final AtomicInteger MADE = new AtomicInteger();

    private final Path folder;
    private final List<Base> bases;

    /**
     * One base.
     *
     * @param address as the other reaches it
     * @param by the command that runs others there: in its network, by its clock
     */
    record Base(String address, Path folder, List<String> by) {
        PairFolder pair() {
            return new PairFolder(folder);
        }
    }

    private PairedProcesses(Path folder, List<Base> bases) {
        this.folder = folder;
        this.bases = bases;
    }

    /** At two addresses of this machine's loopback that no other test has. */
    static PairedProcesses onLoopback(Path folder) throws IOException, InterruptedException {
        return onLoopback(folder, List.of());
    }

    /** The same, the second with another clock: what runs there, its database as well, sees that clock's date and time. */
    static PairedProcesses onLoopback(Path folder, OtherClock ofSecond) throws IOException, InterruptedException {
        return onLoopback(folder, ofSecond.command());
    }

    private static PairedProcesses onLoopback(Path folder, List<String> inSecond)
            throws IOException, InterruptedException {
        long process = ProcessHandle.current().pid();
        String network = "127." + (100 + process % 100) + "." + process / 100 % 250 + ".";
        int first = 2 * MADE.incrementAndGet();
        return made(folder, network + first, network + (first + 1), List.of(), inSecond);
    }

    /** In two networks that are joined by a cable. */
    static PairedProcesses inNetworks(Path folder, TwoNetworks networks) throws IOException, InterruptedException {
        return made(
                folder, TwoNetworks.FIRST_ADDRESS, TwoNetworks.SECOND_ADDRESS, networks.inFirst(), networks.inSecond());
    }

    private static PairedProcesses made(
            Path folder, String first, String second, List<String> inFirst, List<String> inSecond)
            throws IOException, InterruptedException {
        assumeTrue(Programs.installed().isPresent(), Programs.HOW_TO_GET);
        PairedProcesses pair = new PairedProcesses(
                folder,
                List.of(
                        new Base(first, folder.resolve("first"), inFirst),
                        new Base(second, folder.resolve("second"), inSecond)));
        String invitation = folder.resolve("invitation").toString();
        try {
            pair.run(0, "pair", "init", second, "--here", first, "--invitation", invitation);
            pair.run(1, "pair", "join", invitation);
            return pair;
        } catch (IOException | RuntimeException | Error fault) {
            pair.close();
            throw fault;
        }
    }

    /** A base's address, as the other reaches it. */
    String address(int base) {
        return bases.get(base).address();
    }

    /** The passwords of the databases' roles, by the files that hold them for their owner. */
    List<String> passwords() throws IOException {
        Set<String> all = new LinkedHashSet<>();
        for (Base base : bases) {
            Files.readAllLines(base.folder().resolve(PASSWORDS)).stream()
                    .map(line -> line.substring(line.lastIndexOf(':') + 1))
                    .forEach(all::add);
        }
        return List.copyOf(all);
    }

    /** The files of both bases that hold a text, but for those that are to hold passwords. */
    List<Path> filesWith(String text) throws IOException {
        List<Path> found = new ArrayList<>();
        for (Base base : bases) {
            try (Stream<Path> files = Files.walk(base.folder())) {
                for (Path file : files.filter(Files::isRegularFile).toList()) {
                    if (!file.endsWith(PASSWORDS)
                            && Files.exists(file) // a database removes files meanwhile
                            && Files.readString(file, StandardCharsets.ISO_8859_1)
                                    .contains(text)) {
                        found.add(file);
                    }
                }
            }
        }
        return found;
    }

    /** Runs a command on a base to its end, which is good; gives what it said. */
    String run(int base, String... arguments) throws IOException, InterruptedException {
        try (CrwProcess process = start(base, arguments)) {
            assertThat(process.await(COMMAND_S)).as(process.err()).isZero();
            return process.out();
        }
    }

    /** Runs a command on a base, which refuses with an exit code; gives what it said to that. */
    String refused(int base, int exitCode, String... arguments) throws IOException, InterruptedException {
        try (CrwProcess process = start(base, arguments)) {
            assertThat(process.await(COMMAND_S)).as(process.out()).isEqualTo(exitCode);
            return process.err();
        }
    }

    /** Starts a command on a base. */
    CrwProcess start(int base, String... arguments) throws IOException {
        List<String> line = new ArrayList<>(List.of(arguments));
        line.addAll(List.of("--pair-folder", bases.get(base).folder().toString()));
        return CrwProcess.startBy(bases.get(base).by(), folder, line);
    }

    /** Serves the pair's session on a base, or stands by there. */
    CrwProcess serve(int base) throws IOException {
        return start(base, "serve", "--pair", "--port", "0");
    }

    /** The same, with lines that the base carries out once it has the session. */
    CrwProcess serve(int base, List<String> script) throws IOException {
        Path file = Files.write(folder.resolve("script"), script);
        return start(base, "serve", "--pair", "--port", "0", "--script", file.toString());
    }

    /** Makes a base's replica a database that takes writes, as {@code pg_ctl promote} does. */
    void promote(int base) throws IOException, InterruptedException {
        Files.createFile(bases.get(base).folder().resolve("data").resolve("promote"));
        new ProcessBuilder("kill", "-USR1", Long.toString(database(base).pid()))
                .start()
                .waitFor();
    }

    /** Ends a base's database as the loss of its power does, and waits until its processes are gone. */
    void cutPower(int base) throws IOException {
        ProcessHandle server = database(base);
        List<ProcessHandle> all = new ArrayList<>(server.descendants().toList());
        all.add(server);
        all.forEach(ProcessHandle::destroyForcibly);
        all.forEach(process -> process.onExit().join());
    }

    private ProcessHandle database(int base) throws IOException {
        String pid = Files.readAllLines(bases.get(base).folder().resolve("data").resolve("postmaster.pid"))
                .get(0)
                .strip();
        return ProcessHandle.of(Long.parseLong(pid)).orElseThrow();
    }

    /** Waits until a base has the session; on a machine on which it stood still for seconds, it asks for the word of a person, which it gets. */
    void awaitGoesOn(int base, CrwProcess process) throws IOException, InterruptedException {
        Await.until("it has the session", AT_MOST_S, () -> hasSession(process) || asksAPerson(process));
        if (!hasSession(process)) {
            run(base, "take-over", "--confirm");
        }
    }

    private static boolean hasSession(CrwProcess process) {
        return process.out().contains("the session is at ");
    }

    private static boolean asksAPerson(CrwProcess process) {
        return process.out().contains("if not, 'crw take-over'");
    }

    /** Waits until a process says something. */
    static void await(CrwProcess process, String words) {
        try {
            Await.until("'" + words + "'", AT_MOST_S, () -> process.out().contains(words) || !process.isAlive());
        } catch (AssertionError late) {
            throw new AssertionError(late.getMessage() + ", it says: " + process.out() + process.err(), late);
        }
        assertThat(process.out()).as(process.err()).contains(words);
    }

    @Override
    public void close() throws IOException {
        for (Base base : bases) {
            if (base.pair().isThere() && PairDatabase.of(base.pair()).isRunning()) {
                PairDatabase.of(base.pair()).stop();
            }
        }
    }
}
