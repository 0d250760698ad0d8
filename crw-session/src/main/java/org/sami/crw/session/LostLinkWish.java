package org.sami.crw.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.operator.OperatorLog;
import org.sami.crw.operator.OperatorLogEntry.Kind;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.session.record.LostLinkWishRows;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.TelemetryRow;

/**
 * What a session wishes that its boats do when their link is lost; one wish for all of them, or none. What it began with stands in the settings of its
 * journal, a change is a row of telemetry, so that the wish stays where another process goes on, and fronts elsewhere know it. No boat is set by it.
 * Safe for use by several threads.
 */
public final class LostLinkWish {
    private static final String SETTING = "lostLinkWish";

    private final SessionTelemetry telemetry;
    private final LongSupplier nowMillis;
    private final OperatorLog log;
    private volatile Optional<LostLinkAction> wish;

    /**
     * The wish of a journal's settings.
     *
     * @param nowMillis the session's time
     */
    LostLinkWish(SessionJournal journal, SessionTelemetry telemetry, LongSupplier nowMillis, OperatorLog log) {
        this.telemetry = telemetry;
        this.nowMillis = nowMillis;
        this.log = log;
        Map<String, String> settings =
                journal.header().map(JournalHeader::settings).orElse(Map.of());
        wish = LostLinkWishRows.action(settings.getOrDefault(SETTING, ""));
    }

    /** Restores what earlier processes made of it. */
    void restore(List<TelemetryRow> earlier) {
        wish = LostLinkWishRows.after(earlier, wish);
    }

    /** Notes a wish among the settings of a session's journal that is to be made. */
    public static void note(Optional<LostLinkAction> wish, Map<String, String> settings) {
        wish.ifPresent(action -> settings.put(SETTING, LostLinkWishRows.word(Optional.of(action))));
    }

    /** What is wished; empty for nothing. */
    Optional<LostLinkAction> now() {
        return wish;
    }

    /** Begins with what its process was started with; empty leaves what the journal says. */
    void begin(Optional<LostLinkAction> asked) {
        if (asked.isPresent() && !asked.equals(wish)) {
            become(asked);
        }
    }

    /** Changes it as an operator wants it. */
    void change(Optional<LostLinkAction> to) {
        become(to);
        log.add(Kind.BOAT, words(to), "");
    }

    /** A change in words, as what somebody did. */
    public static String words(Optional<LostLinkAction> to) {
        return to.isPresent()
                ? "wished that boats " + LostLinkWishRows.word(to) + " when their link is lost"
                : "wished nothing of boats whose link is lost";
    }

    /** One after the other, so that the newest row says what is wished. */
    private synchronized void become(Optional<LostLinkAction> to) {
        wish = to;
        telemetry.add(nowMillis.getAsLong(), "", LostLinkWishRows.KIND, LostLinkWishRows.json(to));
    }
}
