package org.sami.crw.sim.run;

import java.io.IOException;
import java.util.List;
import java.util.OptionalLong;
import java.util.function.Supplier;
import org.sami.spn.host.Durability;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.JournalEntry;

/** A journal whose process dies as soon as so many entries are in it. */
final class CrashingJournal implements RunJournal {
    /** The death of the process: nothing catches it on its way out of the run. */
    static final class Crash extends Error {}

    private final RunJournal real;
    private final long after;

    CrashingJournal(RunJournal real, long after) {
        this.real = real;
        this.after = after;
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
                inputs.append(entries, durability);
                if (inputs.lastIndex() >= after) {
                    throw new Crash();
                }
            }

            @Override
            public void offerSnapshot(Supplier<byte[]> state) throws IOException {
                inputs.offerSnapshot(state);
            }

            @Override
            public void sync() throws IOException {
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
        real.mark(atMillis, fingerprint);
    }

    @Override
    public void stopped(long atMillis) throws IOException {
        real.stopped(atMillis);
    }

    @Override
    public boolean isCatchingUp() {
        return real.isCatchingUp();
    }

    @Override
    public OptionalLong resumedFrom() {
        return real.resumedFrom();
    }

    @Override
    public void over() throws IOException {
        real.over();
    }
}
