package org.sami.spn.journal;

import java.util.List;
import java.util.Optional;

/**
 * What somebody has read of a journal and keeps in memory: a reader that is given it reads only what was written since. Immutable.
 */
public final class JournalPart {
    private final Contents contents;
    private final Optional<KeptState> state;
    private final KeptTelemetry telemetry;

    /**
     * The state of an engine after an entry.
     *
     * @param bytes as {@link org.sami.spn.engine.StateCodec} encodes it
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    record KeptState(long index, byte[] bytes) {}

    /**
     * Telemetry up to a row.
     *
     * @param next where the rows behind it begin
     */
    record KeptTelemetry(List<TelemetryRow> rows, long next, Optional<String> damage) {
        static final KeptTelemetry NONE = new KeptTelemetry(List.of(), 0, Optional.empty());
    }

    JournalPart(Contents contents, Optional<KeptState> state, KeptTelemetry telemetry) {
        this.contents = contents;
        this.state = state;
        this.telemetry = telemetry;
    }

    /** Entries that were found to be valid, without a state and telemetry. */
    static JournalPart of(Contents contents) {
        return new JournalPart(contents, Optional.empty(), KeptTelemetry.NONE);
    }

    /** The same without a state and telemetry, which take room. */
    public JournalPart entriesOnly() {
        return of(contents);
    }

    /** Index of its last entry; 0 where there is none. */
    public long lastIndex() {
        return contents.lastValid();
    }

    /** Index of the entry whose state is in it; empty where none is. */
    public Optional<Long> stateAt() {
        return state.map(KeptState::index);
    }

    Contents contents() {
        return contents;
    }

    Optional<KeptState> state() {
        return state;
    }

    KeptTelemetry telemetry() {
        return telemetry;
    }
}
