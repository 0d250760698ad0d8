package org.sami.bench.postgres;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.LongStream;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.protocol.Input;

/**
 * How many inputs a second become durable, in batches of as many as wait for a host, and how long one that comes alone takes: in PostgreSQL on this machine, which forces each batch to its disk,
 * and in SQLite. System property {@code quick} = true for a few seconds; {@code journal} = the address of a database whose single inputs are timed too, such as that of a pair of bases. A journal
 * is made there.
 */
public final class PostgresBenchmarkMain {
    private static final String SUBJECT = "journal.";
    private static final int OUTSTANDING = 1024;
    private static final long PAUSE_NANOS = 5_000_000;

    private PostgresBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws IOException {
        int batches = Boolean.getBoolean("quick") ? 40 : 200;
        Path folder = Files.createTempDirectory("journal-benchmark");
        try (EmbeddedPostgres server = EmbeddedPostgres.builder()
                .setOverrideWorkingDirectory(
                        Path.of("build", "postgres").toAbsolutePath().toFile())
                .setServerConfig("fsync", "on")
                .setServerConfig("full_page_writes", "on")
                .start()) {
            String database = "postgresql://localhost:" + server.getPort() + "/postgres?user=postgres&schema=run";
            perSecond(JournalAddress.parse(database + "_warm"), batches);
            perSecond(JournalAddress.of(folder.resolve("warm.journal")), batches);
            double postgres = perSecond(JournalAddress.parse(database), batches);
            double sqlite = perSecond(JournalAddress.of(folder.resolve("run.journal")), batches);
            List<Figure> figures = new ArrayList<>(List.of(
                    figure("postgres", postgres, "inputs/s"),
                    figure("sqlite", sqlite, "inputs/s"),
                    figure("ratio", postgres / sqlite, "of SQLite")));
            int singles = Boolean.getBoolean("quick") ? 200 : 3000;
            figures.addAll(singly("postgres", JournalAddress.parse(database + "_single"), singles));
            figures.addAll(singly("sqlite", JournalAddress.of(folder.resolve("single.journal")), singles));
            String other = System.getProperty("journal", "");
            if (!other.isEmpty()) {
                figures.addAll(singly("journal", JournalAddress.parse(other), singles));
            }
            FigureFile.print(figures);
            FigureFile.replace(FigureFile.ofThisBuild(), SUBJECT, figures);
        } finally {
            try (var files = Files.list(folder)) {
                for (Path file : files.toList()) {
                    Files.delete(file);
                }
            }
            Files.delete(folder);
        }
    }

    private static Figure figure(String name, double value, String unit) {
        return new Figure(SUBJECT + name, Map.of("outstanding", OUTSTANDING), value, unit, 0);
    }

    /** Inputs that come one by one, with a pause between: how long until each survives the loss of power. */
    private static List<Figure> singly(String where, JournalAddress address, int inputs) throws IOException {
        long[] nanos = new long[inputs];
        try (StoredJournal journal = address.create(JournalHeader.of("", Map.of(), Map.of()), JournalOptions.DEFAULT)) {
            for (int i = -inputs / 10; i < inputs; i++) { // the first ones warm it up
                LockSupport.parkNanos(PAUSE_NANOS);
                long index = journal.lastIndex() + 1;
                JournalEntry entry = new JournalEntry(index, index, new Input.ProxyJoined("boat" + index));
                long begun = System.nanoTime();
                journal.append(List.of(entry), Durability.POWER);
                nanos[Math.max(i, 0)] = System.nanoTime() - begun;
            }
        }
        Arrays.sort(nanos);
        return List.of(
                single(where, "median", nanos[inputs / 2]),
                single(where, "p99", nanos[(int) Math.ceil(inputs * 0.99) - 1]));
    }

    private static Figure single(String where, String which, long nanos) {
        return new Figure(SUBJECT + where + ".single." + which, Map.of("outstanding", 1), nanos / 1e6, "ms", 0);
    }

    private static double perSecond(JournalAddress address, int batches) throws IOException {
        try (StoredJournal journal = address.create(JournalHeader.of("", Map.of(), Map.of()), JournalOptions.DEFAULT)) {
            long begun = System.nanoTime();
            for (int batch = 0; batch < batches; batch++) {
                long after = journal.lastIndex();
                journal.append(
                        LongStream.rangeClosed(after + 1, after + OUTSTANDING)
                                .mapToObj(
                                        index -> new JournalEntry(index, index, new Input.ProxyJoined("boat" + index)))
                                .toList(),
                        Durability.POWER);
            }
            return batches * OUTSTANDING / ((System.nanoTime() - begun) / 1e9);
        }
    }
}
