package org.sami.crw.sim.session;

import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;
import org.sami.spn.host.Durability;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.MemoryJournal;

/** A journal whose disk a test fills, and makes room on again. */
final class FullJournal implements InputJournal {
    private final MemoryJournal memory = new MemoryJournal();
    private volatile boolean full;

    void fill() {
        full = true;
    }

    void makeRoom() {
        full = false;
    }

    List<JournalEntry> entries() {
        return memory.entries();
    }

    @Override
    public long lastIndex() {
        return memory.lastIndex();
    }

    @Override
    public long lastMillis() {
        return memory.lastMillis();
    }

    @Override
    public void append(List<JournalEntry> entries, Durability durability) throws IOException {
        check();
        memory.append(entries, durability);
    }

    @Override
    public void check() throws IOException {
        if (full) {
            throw new IOException("the disk is full");
        }
    }

    @Override
    public boolean isRecoverable() {
        return true;
    }

    @Override
    public void recover() throws IOException {
        check();
    }

    @Override
    public void offerSnapshot(Supplier<byte[]> state) {
        // the entries are all there
    }

    @Override
    public void sync() throws IOException {
        check();
    }

    @Override
    public void close() {
        // they stay readable
    }
}
