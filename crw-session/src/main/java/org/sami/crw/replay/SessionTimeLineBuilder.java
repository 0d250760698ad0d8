package org.sami.crw.replay;

import java.util.List;
import org.sami.crw.message.OperatorMessage;
import org.sami.session.record.SessionNote;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Ids;
import org.sami.spn.replay.TimeLine;
import org.sami.spn.replay.TimeLine.Kind;
import org.sami.spn.replay.TimeLine.Mark;
import org.sami.spn.replay.TimeLineBuilder;

/** Goes through a session's journal once and marks what happened: its entries, messages and lost links. */
final class SessionTimeLineBuilder implements SessionTelemetry.Reader {
    private final TimeLineBuilder builder = new TimeLineBuilder();
    private long rowMillis;

    private SessionTimeLineBuilder() {}

    static TimeLine of(Engine engine, List<JournalEntry> entries, List<TelemetryRow> rows) {
        SessionTimeLineBuilder line = new SessionTimeLineBuilder();
        EngineState state = engine.newState();
        for (JournalEntry entry : entries) {
            line.builder.entry(entry, engine.step(state, entry.atMillis(), entry.input()));
        }
        for (TelemetryRow row : rows) {
            line.rowMillis = row.atMillis();
            line.builder.until(row.atMillis());
            SessionTelemetry.read(List.of(row), line);
        }
        return line.builder.build();
    }

    @Override
    public void message(OperatorMessage message) {
        builder.mark(new Mark(message.atMillis(), Kind.MESSAGE, message.mission(), message.text()));
    }

    @Override
    public void message(SessionNote note) {
        if (note.kind().equals(SessionNote.LINK)) {
            builder.mark(new Mark(note.atMillis(), Kind.ALARM, Ids.NONE, note.text()));
        }
    }

    @Override
    public void lost(String boat) {
        builder.mark(new Mark(rowMillis, Kind.ALARM, Ids.NONE, "the link to " + boat + " is lost"));
    }
}
