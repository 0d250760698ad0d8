package org.sami.crw.sim.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.function.Supplier;
import org.sami.spn.host.Durability;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.JournalEntry;

/** A journal whose process dies as soon as so many entries are in it, or that leaves what its death at any entry would have left. */
final class CrashingJournal implements RunJournal {
    /** The death of the process: whoever catches it on its way out of the run meets it again at the next thing that the journal is to do. */
    static final class Crash extends Error {}

    private interface AfterAppend {
        void accept(long lastIndex) throws IOException;
    }

    private final RunJournal real;
    private final AfterAppend then;
    private boolean isDead;

    CrashingJournal(RunJournal real, long after) {
        this(real, lastIndex -> {
            if (lastIndex >= after) {
                throw new Crash();
            }
        });
    }

    private CrashingJournal(RunJournal real, AfterAppend then) {
        this.real = real;
        this.then = then;
    }

    /**
     * A journal that lives on. Whenever entries are in its file it copies that, and the log next to it, as they are: what the process would have left, had it
     * been killed then.
     *
     * @param left gets the copies, by the last entry in each
     */
    static CrashingJournal leaving(RunJournal real, Path file, Map<Long, Path> left) {
        return new CrashingJournal(real, lastIndex -> {
            Path copy = file.resolveSibling(file.getFileName() + "-" + lastIndex);
            Files.copy(file, copy);
            Files.copy(log(file), log(copy));
            left.put(lastIndex, copy);
        });
    }

    private static Path log(Path file) {
        return file.resolveSibling(file.getFileName() + "-wal");
    }

    @Override
    public InputJournal inputs() {
        InputJournal inputs = real.inputs();
        return new InputJournal() {
            @Override
            public long lastIndex() {
                return inputs.lastIndex();
            }

            @Override
            public long lastMillis() {
                return inputs.lastMillis();
            }

            @Override
            public void append(List<JournalEntry> entries, Durability durability) throws IOException {
                live();
                inputs.append(entries, durability);
                try {
                    then.accept(inputs.lastIndex());
                } catch (Crash crash) {
                    isDead = true;
                    throw crash;
                }
            }

            @Override
            public void offerSnapshot(Supplier<byte[]> state) throws IOException {
                live();
                inputs.offerSnapshot(state);
            }

            @Override
            public void sync() throws IOException {
                live();
                inputs.sync();
            }

            @Override
            public void close() throws IOException {
                inputs.close();
            }
        };
    }

    @Override
    public void mark(long atMillis, Supplier<String> fingerprint) throws IOException {
        live();
        real.mark(atMillis, fingerprint);
    }

    @Override
    public void stopped(long atMillis) throws IOException {
        live();
        real.stopped(atMillis);
    }

    @Override
    public boolean isCatchingUp() {
        live();
        return real.isCatchingUp();
    }

    @Override
    public OptionalLong resumedFrom() {
        live();
        return real.resumedFrom();
    }

    @Override
    public void over() throws IOException {
        live();
        real.over();
    }

    private void live() {
        if (isDead) {
            throw new Crash();
        }
    }
}
