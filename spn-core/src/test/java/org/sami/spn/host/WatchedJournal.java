package org.sami.spn.host;

import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;

/** A memory journal that tells a log when it was written, and refuses when told to. */
final class WatchedJournal implements InputJournal {
    private final MemoryJournal memory = new MemoryJournal();
    private final List<String> log;
    private boolean refusing;
    private boolean recoverable;

    WatchedJournal(List<String> log) {
        this.log = log;
    }

    void refuse() {
        refusing = true;
    }

    /** Refuses until it is told to accept. */
    void refuseForNow() {
        refusing = true;
        recoverable = true;
    }

    void accept() {
        refusing = false;
    }

    @Override
    public boolean isRecoverable() {
        return recoverable;
    }

    @Override
    public void check() throws IOException {
        if (refusing) {
            throw new IOException("the disk is full");
        }
    }

    @Override
    public void recover() throws IOException {
        check();
        log.add("recovered");
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
        if (refusing) {
            throw new IOException("the disk is full");
        }
        memory.append(entries, durability);
        log.add("append to " + memory.lastIndex() + " " + durability);
    }

    @Override
    public void prepare(List<JournalEntry> entries) {
        log.add("prepared to " + entries.get(entries.size() - 1).index());
    }

    @Override
    public void offerSnapshot(Supplier<byte[]> state) {
        log.add("snapshot offered");
    }

    @Override
    public void sync() {
        log.add("sync");
    }

    @Override
    public void close() {
        log.add("close");
    }
}
