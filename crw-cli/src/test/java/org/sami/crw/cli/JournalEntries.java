package org.sami.crw.cli;

import java.nio.file.Path;
import java.util.function.BooleanSupplier;
import org.sami.boat.server.testing.Await;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalReader;

/** How far a process of {@code crw} is, by the journal that it writes: the same on any machine, however fast it is. */
public final class JournalEntries {
    /** Until it is given up that a run gets on. */
    private static final double AT_MOST_S = 300;

    private JournalEntries() {}

    /** How many entries are in a journal, also in one that is being written; 0 while it cannot be read. */
    public static long in(Path journal) {
        try (JournalReader reader = JournalReader.open(journal)) {
            return reader.lastIndex();
        } catch (JournalException beginsOrEnds) {
            return 0;
        }
    }

    /** The same, with the telemetry: it grows also while boats only sail. */
    public static long withTelemetryIn(Path journal) {
        try (JournalReader reader = JournalReader.open(journal)) {
            return reader.lastIndex() + reader.telemetry().rows().size();
        } catch (JournalException beginsOrEnds) {
            return 0;
        }
    }

    /** Kills a process, as {@code kill -9} does, once its journal has so many entries; it may have ended before. */
    public static void killAt(long entry, Path journal, CrwProcess process) throws InterruptedException {
        killOnce(() -> in(journal) >= entry, process);
    }

    /** Kills a process, as {@code kill -9} does, once something is so; it may have ended before. */
    public static void killOnce(BooleanSupplier so, CrwProcess process) throws InterruptedException {
        Await.until("the place to kill it", AT_MOST_S, () -> so.getAsBoolean() || !process.isAlive());
        process.kill();
    }
}
