package org.sami.crw.session;

import java.util.function.Consumer;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.session.record.SessionNote;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Ids;

/** Notes in the journal messages to the operator, and passes them on. Safe for use by several threads. */
final class SessionMessages implements MessageSink {
    private final SessionTelemetry telemetry;
    private final MessageSink models;
    private final ListenerList<SessionListener> listeners = new ListenerList<>();
    private final RobotKind robots;
    private boolean closed;

    SessionMessages(SessionTelemetry telemetry, MessageSink models) {
        this(telemetry, models, RobotKind.BOAT);
    }

    /** Messages of handlers and proxies, with the word for the session's robots. */
    SessionMessages(SessionTelemetry telemetry, MessageSink models, RobotKind robots) {
        this.robots = robots;
        this.telemetry = telemetry;
        this.models = models;
    }

    Registration add(SessionListener listener) {
        return listeners.add(listener);
    }

    /** Tells all listeners something. */
    void each(Consumer<SessionListener> news) {
        listeners.each(news);
    }

    /** Takes no further message: links that end now are ended by the session itself. A message being taken is finished first. */
    synchronized void close() {
        closed = true;
    }

    @Override
    public void tell(OperatorMessage given) {
        OperatorMessage message =
                given.source() == OperatorMessage.Source.DOMAIN ? given.withText(robots.say(given.text())) : given;
        if (note(() -> telemetry.message(message), SessionNote.of(message))) {
            models.tell(message);
        }
    }

    /** Tells something about a link. */
    void ofLink(long atMillis, String text) {
        SessionNote note = new SessionNote(atMillis, SessionNote.LINK, Ids.NONE, robots.say(text));
        note(() -> telemetry.message(note), note);
    }

    /** Returns whether it was noted: not after {@link #close}, so that a report has all messages that the journal has. */
    private synchronized boolean note(Runnable written, SessionNote note) {
        if (!closed) {
            written.run();
            listeners.each(listener -> listener.onNote(note));
        }
        return !closed;
    }

    /** Shows something that need not be kept. */
    void notice(String text) {
        listeners.each(listener -> listener.onNotice(robots.say(text)));
    }
}
