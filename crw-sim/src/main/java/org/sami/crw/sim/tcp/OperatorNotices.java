package org.sami.crw.sim.tcp;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.sami.crw.operator.MessageSink;
import org.sami.crw.operator.OperatorMessage;
import org.sami.crw.sim.report.NoteResult;
import org.sami.spn.protocol.Ids;

/**
 * What the operator is told in a run: kept for the report and the journal; what the domain says of boats and links also waits here
 * to be shown at once. Safe for use by several threads.
 */
final class OperatorNotices implements MessageSink {
    private static final String LINK = "link";

    private final SessionNotes notes;
    private final List<NoteResult> told = new ArrayList<>();
    private final Queue<String> toShow = new ConcurrentLinkedQueue<>();
    private volatile boolean closed;

    OperatorNotices(SessionNotes notes) {
        this.notes = notes;
    }

    /** Takes nothing more: the run is over. What was taken can still be had. */
    void close() {
        closed = true;
    }

    @Override
    public void tell(OperatorMessage message) {
        if (closed) {
            return;
        }
        String source = message.source().name().toLowerCase(Locale.ROOT);
        keep(new NoteResult(message.atMillis(), source + " message", message.mission(), message.text()));
        if (message.source() == OperatorMessage.Source.DOMAIN) {
            show(message.text());
        }
    }

    /** Tells something about a link. */
    void ofLink(long atMillis, String text) {
        if (closed) {
            return;
        }
        keep(new NoteResult(atMillis, LINK, Ids.NONE, text));
        show(text);
    }

    /** Shows something that need not be kept. */
    void show(String text) {
        toShow.add(text);
    }

    private synchronized void keep(NoteResult note) {
        told.add(note);
        notes.message(note);
    }

    /** What was told in an earlier process. */
    synchronized void restored(NoteResult note) {
        told.add(note);
    }

    /** Everything so far, in the order in which it was told. */
    synchronized List<NoteResult> all() {
        return List.copyOf(told);
    }

    /** The next line to be shown; null if none waits. */
    String next() {
        return toShow.poll();
    }
}
