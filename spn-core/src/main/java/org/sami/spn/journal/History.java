package org.sami.spn.journal;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.protocol.Effect;

/** The past of a session: its valid entries, and the state after any of them by snapshot and replay. */
final class History {
    private final String where;
    private final Connection connection;
    private final Contents contents;
    private final Attachments attachments;
    private final ProjectDocuments documents;
    private final Optional<JournalPart.KeptState> kept;

    /**
     * The past that a database holds.
     *
     * @param kept a state after one of the valid entries that needs not be read
     */
    History(String where, Connection connection, Contents contents, Optional<JournalPart.KeptState> kept) {
        this.kept = kept;
        this.where = where;
        this.connection = connection;
        this.contents = contents;
        this.attachments = new Attachments(connection);
        this.documents = new ProjectDocuments(connection);
    }

    EngineState stateAt(long index, Engine engine) throws JournalException {
        if (index < 0 || index > contents.lastValid()) {
            throw new IllegalArgumentException("entries go to " + contents.lastValid() + ", not to " + index);
        }
        Optional<EngineState> ahead = kept(index, engine);
        if (ahead.isPresent()) {
            return goOn(engine, ahead.get(), kept.orElseThrow().index(), index);
        }
        long from = index;
        while (true) {
            Map.Entry<Long, Checksum> snapshot = contents.snapshots().floorEntry(from);
            if (snapshot == null) {
                return goOn(engine, engine.newState(), 0, index);
            }
            Optional<EngineState> state = decoded(snapshot.getKey(), snapshot.getValue(), engine);
            if (state.isPresent()) {
                return goOn(engine, state.get(), snapshot.getKey(), index);
            }
            from = snapshot.getKey() - 1;
        }
    }

    /** Steps through entries again; the listener hears what listeners of the session heard. */
    void replay(Engine engine, long first, long last, HostListener listener) throws JournalException {
        EngineState state = stateAt(first - 1, engine);
        entries(first - 1, last, entry -> {
            List<Effect> effects = engine.step(state, entry.atMillis(), entry.input());
            listener.onStep(entry.index(), entry.atMillis(), entry.input(), effects, engine.view(state));
        });
    }

    /** The entries behind an index, up to and including another, in order. */
    void entries(long after, long last, Consumer<JournalEntry> consumer) throws JournalException {
        try (PreparedStatement select = connection.prepareStatement(
                "SELECT idx, at_millis, input FROM entries WHERE idx > ? AND idx <= ? ORDER BY idx")) {
            select.setLong(1, after);
            select.setLong(2, last);
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    consumer.accept(entry(rows));
                }
            }
        } catch (SQLException fault) {
            throw new JournalException(where, after + 1, "cannot be read: " + fault.getMessage(), fault);
        }
    }

    List<WorldMark> marks() throws JournalException {
        List<WorldMark> marks = new ArrayList<>();
        for (Map.Entry<Long, Checksum> mark : contents.marks().entrySet()) {
            String text = attachments
                    .mark(mark.getKey(), mark.getValue())
                    .orElseThrow(() -> new JournalException(
                            where, mark.getKey(), "its mark is damaged: the checksum does not hold"));
            marks.add(new WorldMark(mark.getKey(), text));
        }
        return marks;
    }

    Optional<byte[]> snapshot(long index) {
        return Optional.ofNullable(contents.snapshots().get(index)).flatMap(sum -> attachments.snapshot(index, sum));
    }

    private JournalEntry entry(ResultSet row) throws SQLException, JournalException {
        long index = row.getLong(1);
        return new JournalEntry(index, row.getLong(2), InputText.read(where, index, row.getString(3), documents));
    }

    private EngineState goOn(Engine engine, EngineState state, long after, long last) throws JournalException {
        List<Effect> forgotten = new ArrayList<>();
        entries(after, last, entry -> {
            engine.step(state, entry.atMillis(), entry.input(), forgotten::add);
            forgotten.clear();
        });
        return state;
    }

    /** The state that is kept, where no snapshot is nearer to an entry. */
    private Optional<EngineState> kept(long index, Engine engine) {
        Long snapshot = contents.snapshots().floorKey(index);
        return kept.filter(state -> state.index() <= index && (snapshot == null || state.index() >= snapshot))
                .flatMap(state -> decoded(state.bytes(), engine));
    }

    private Optional<EngineState> decoded(long index, Checksum entryChecksum, Engine engine) {
        return attachments.snapshot(index, entryChecksum).flatMap(bytes -> decoded(bytes, engine));
    }

    private Optional<EngineState> decoded(byte[] bytes, Engine engine) {
        try {
            return Optional.of(StateCodec.decode(bytes, engine, documents::find));
        } catch (IllegalArgumentException older) {
            return Optional.empty(); // of another version of the state's format: an earlier one, or the start, will do
        }
    }
}
