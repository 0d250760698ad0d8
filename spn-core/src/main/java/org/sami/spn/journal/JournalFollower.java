package org.sami.spn.journal;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.JournalException;

/**
 * Follows a journal that another process writes: reads new entries and telemetry whenever it is asked to, and applies the entries to an engine of its own. Effects go nowhere. Only reads, so that a
 * replica of the database will do. For one thread at a time.
 */
public final class JournalFollower implements AutoCloseable {
    /** Rows of telemetry in memory, some 250 bytes each. Those of a longer session are read by whoever goes on with it. */
    private static final int MOST_TELEMETRY = 500_000;

    private final JournalAddress address;
    private final int mostTelemetry;
    private final Reading reading;
    private Optional<JournalReader> reader = Optional.empty();
    private Optional<Applied> applied = Optional.empty();

    /** How the journal is read. */
    @FunctionalInterface
    interface Reading {
        /** Opens it to read what is not known of it. */
        JournalReader open(Optional<JournalPart> known) throws JournalException;
    }

    /** How far the journal has been applied. */
    private static final class Applied {
        final Engine engine;
        final EngineState state;
        List<TelemetryRow> telemetry = new ArrayList<>();
        boolean keepsTelemetry = true;
        long index;
        long nextTelemetry;
        Optional<String> telemetryDamage = Optional.empty();
        JournalPart entries;

        Applied(Engine engine, EngineState state, JournalPart entries) {
            this.engine = engine;
            this.state = state;
            this.entries = entries;
            this.index = entries.lastIndex();
        }

        void add(TelemetryScan scan) {
            Telemetry found = scan.run();
            telemetry.addAll(found.rows());
            nextTelemetry = scan.next();
            telemetryDamage = telemetryDamage.or(found::damage);
        }
    }

    /** A follower that has read nothing yet. */
    public JournalFollower(JournalAddress address) {
        this(address, MOST_TELEMETRY, address::read);
    }

    JournalFollower(JournalAddress address, int mostTelemetry, Reading reading) {
        this.address = address;
        this.mostTelemetry = mostTelemetry;
        this.reading = reading;
    }

    /**
     * Reads what was written since, and applies it; at first the whole journal, from its last snapshot on.
     *
     * @throws JournalException if the journal cannot be read now, or is not there: to be called again later
     * @throws RuntimeException if this program cannot go on with such a journal, or cannot apply an entry of it: this follower is of no use then
     */
    public void follow() throws JournalException {
        try {
            JournalReader from = reader.isPresent() ? reader.get() : open();
            if (applied.isPresent() && !from.readOn()) {
                applied = Optional.empty(); // another journal stands there
                close();
                from = open();
            }
            if (applied.isPresent()) {
                apply(applied.get(), from);
            } else {
                begin(from);
                close(); // the next reader has little to read, and may give up sooner where nothing answers
            }
        } catch (JournalException fault) {
            close();
            throw fault;
        }
    }

    private JournalReader open() throws JournalException {
        JournalReader opened = reading.open(applied.map(earlier -> earlier.entries));
        if (!opened.goesOn()) {
            applied = Optional.empty();
        }
        reader = Optional.of(opened);
        return opened;
    }

    private void begin(JournalReader from) throws JournalException {
        Engine engine = engine(from.header());
        Applied first = new Applied(engine, from.stateAt(from.lastIndex(), engine), from.entriesRead());
        followTelemetry(first, from);
        applied = Optional.of(first);
    }

    private void followTelemetry(Applied to, JournalReader from) {
        if (to.keepsTelemetry) {
            to.add(from.telemetryFrom(to.nextTelemetry));
            if (to.telemetry.size() > mostTelemetry) {
                to.keepsTelemetry = false;
                to.telemetry = new ArrayList<>();
            }
        }
    }

    private Engine engine(JournalHeader header) {
        try {
            JournalTables.refuseOtherRules(address.toString(), header);
            return JournalPlans.engine(address, header);
        } catch (JournalException unfit) {
            throw new IllegalArgumentException(unfit.getMessage(), unfit);
        }
    }

    private void apply(Applied to, JournalReader from) throws JournalException {
        to.entries = from.entriesRead(); // first: it goes with the reader, however far the entries are applied
        from.entries(to.index + 1, from.lastIndex(), entry -> {
            to.engine.step(to.state, entry.atMillis(), entry.input(), effect -> {});
            to.index = entry.index();
        });
        followTelemetry(to, from);
    }

    /** Index of the last entry that was applied; 0 where none was. */
    public long applied() {
        return applied.map(all -> all.index).orElse(0L);
    }

    /** What is wrong with the journal behind that entry, in a sentence; empty where nothing is. */
    public Optional<String> damage() {
        return applied.flatMap(all -> all.entries.contents().damage());
    }

    /** What has been read, with the state after the last entry; empty where nothing has. Not to be followed on after that. */
    public Optional<JournalPart> part() {
        return applied.map(all -> new JournalPart(
                all.entries.contents(),
                Optional.of(new JournalPart.KeptState(all.index, StateCodec.encode(all.state))),
                all.keepsTelemetry
                        ? new JournalPart.KeptTelemetry(
                                Collections.unmodifiableList(all.telemetry), all.nextTelemetry, all.telemetryDamage)
                        : JournalPart.KeptTelemetry.NONE));
    }

    /** Closes its connection; it can follow on by another. */
    @Override
    public void close() {
        Optional<JournalReader> open = reader;
        reader = Optional.empty();
        open.ifPresent(JournalFollower::close);
    }

    private static void close(JournalReader one) {
        try {
            one.close();
        } catch (JournalException gone) {
            System.getLogger(JournalFollower.class.getName())
                    .log(System.Logger.Level.DEBUG, "closing a reader: {0}", gone.getMessage());
        }
    }
}
