package org.sami.crw.cli.pair;

import java.io.IOException;
import java.time.Clock;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.function.Consumer;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.session.Session;
import org.sami.pair.postgres.BasePair;
import org.sami.pair.postgres.Protection;
import org.sami.pair.postgres.StandbyMonitor;
import org.sami.pair.postgres.StandbyPresence;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.protocol.Priority;

/** This base of a pair while it serves a session, or stands by for one. */
public final class PairedBase {
    /** The pair's fault among those of the session. */
    private static final String SUBJECT = "the pair";

    private static final DateTimeFormatter SECONDS = DateTimeFormatter.ofPattern("HH:mm:ss");

    private final BasePair pair;
    private final String name;
    private final JournalAddress journal;
    private final boolean standsBy;

    private PairedBase(BasePair pair, String name, JournalAddress journal, boolean standsBy) {
        this.pair = pair;
        this.name = name;
        this.journal = journal;
        this.standsBy = standsBy;
    }

    /**
     * This base and one of its sessions.
     *
     * @param part what it does at present
     * @param name of the session
     */
    static PairedBase of(BasePair pair, BasePair.Part part, String name) throws IOException {
        boolean standsBy = part == BasePair.Part.REPLICA;
        return new PairedBase(
                pair, name, JournalAddress.parse(pair.journal(name).text()), standsBy);
    }

    /** Where the session's journal is. */
    public JournalAddress journal() {
        return journal;
    }

    /** Whether this base waits for the other's end. */
    public boolean standsBy() {
        return standsBy;
    }

    /** Says to the other base that this one stands by, until it is closed. */
    public StandbyPresence standBy() {
        return pair.standBy(name);
    }

    /**
     * Looks after the standby while this base has the session; says how the pair stands by lines and in the session's health.
     *
     * @param onReplaced run once the other base went on with the session, so that this one ends with it; on the monitor's thread
     */
    public StandbyMonitor monitor(Session session, Consumer<String> lines, Runnable onReplaced) throws IOException {
        HealthModel health = session.models().health();
        return pair.monitor(name, Clock.system(ZoneId.systemDefault()), (now, since) -> {
            lines.accept("pair: " + now.text() + ", since " + SECONDS.format(since));
            if (now.state() == Protection.State.PROTECTED) {
                health.over(HealthKind.JOURNAL, SUBJECT);
            } else {
                boolean goesOn = now.state() == Protection.State.ALONE || now.state() == Protection.State.COPIED;
                Priority severity = goesOn ? Priority.MEDIUM : Priority.CRITICAL;
                health.report(
                        HealthFault.of(HealthKind.JOURNAL, SUBJECT, severity, "The pair: " + now.text(), now.advice()));
            }
            if (now.state() == Protection.State.REPLACED) {
                lines.accept(now.advice());
                onReplaced.run();
            }
        });
    }
}
