package org.sami.crw.sim.resume;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.protocol.Input;

/** The journal of a run on boats that are other processes: that of its session, with the run in its header. */
public final class ConnectedJournal implements EarlierProcesses, AutoCloseable {
    private final SessionJournal session;

    private ConnectedJournal(SessionJournal session) {
        this.session = session;
    }

    /** A journal that nobody reads again. */
    public static ConnectedJournal none() {
        return new ConnectedJournal(SessionJournal.none());
    }

    /**
     * The journal of a run that begins.
     *
     * @throws IOException if there is one already, or none can be made
     */
    public static ConnectedJournal create(JournalAddress address, RunRecord record) throws IOException {
        return new ConnectedJournal(SessionJournal.create(address, record.toHeader()));
    }

    /**
     * The journal of a run that is taken up.
     *
     * @throws IOException if it is no journal, is damaged from its head, or another process writes it
     */
    public static ConnectedJournal open(JournalAddress address) throws IOException {
        return new ConnectedJournal(SessionJournal.open(address));
    }

    /** The session's. */
    public SessionJournal session() {
        return session;
    }

    @Override
    public RunRecord record() {
        return RunRecord.of(session.header().orElseThrow());
    }

    @Override
    public List<String> differences(String project, Map<String, String> vocabulary) {
        return session.header().orElseThrow().differences(record().source(), project, vocabulary);
    }

    @Override
    public String damage() {
        return session.damage();
    }

    @Override
    public OptionalLong resumedFrom() {
        return session.resumedFrom();
    }

    @Override
    public long cameToMillis() {
        return session.cameToMillis();
    }

    /** The boats with which an earlier process started the mission, in order; empty if none did. */
    public Optional<List<String>> startedWith() throws IOException {
        List<String> joined = new ArrayList<>();
        boolean[] started = new boolean[1];
        session.earlierEntries(entry -> {
            if (entry.input() instanceof Input.ProxyJoined proxy && !started[0]) {
                joined.add(proxy.proxy());
            }
            started[0] |= entry.input() instanceof Input.StartMission;
        });
        return started[0] ? Optional.of(joined) : Optional.empty();
    }

    @Override
    public void close() throws IOException {
        session.close();
    }
}
