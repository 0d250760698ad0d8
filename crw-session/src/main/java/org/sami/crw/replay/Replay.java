package org.sami.crw.replay;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.ReplayFeed;
import org.sami.session.api.BoatStart;
import org.sami.session.follow.RecordedBoats;
import org.sami.session.record.SessionPictures;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Effect;

/**
 * Shows what lay before the operator at any moment of a journal: models of its own, to which the journal's inputs and telemetry are given again.
 * The same moment gives the same snapshots, whichever way it was reached: forwards nothing is left out, and backwards it starts from the beginning.
 *
 * <p>Nothing acts: there is no host, no link and no clock. {@link #goTo} computes on the caller's thread and is for one at a time that is
 * no window's; models and {@link #shownMillis} belong to the owner's.
 */
public final class Replay {
    private static final long SECOND_MS = 1000;

    /** So many items are replayed before the models' owner is waited for: a long journal does not pile up before a window. */
    private static final int MOST_AHEAD = 2000;

    private final ReplayedJournal journal;
    private final Engine engine;
    private final OperatorModels models;
    private final ReplayFeed feed;
    private final RecordedBoats boats;
    private final ListenerList<HostListener> listeners = new ListenerList<>();
    private EngineState state;
    private int nextEntry;
    private int nextRow;
    private long atMillis;
    private long tickedMillis;
    private int ahead;
    private volatile long shownMillis;

    /**
     * A replay at the start of its journal.
     *
     * @param owner of the models: a window's event thread
     * @param computing computes what sensors measured for the map, one after the other
     */
    public Replay(ReplayedJournal journal, Executor owner, Executor computing) {
        this.journal = journal;
        engine = journal.engine();
        models = new OperatorModels(owner, () -> shownMillis, computing, HandlerModules.robotsOf(journal.vocabulary()));
        feed = models.replayFeed();
        boats = new RecordedBoats(feed, models, journal.address().file().map(SessionPictures::besides));
        begin();
        goTo(0);
    }

    private void begin() {
        state = engine.newState();
        nextEntry = 0;
        nextRow = 0;
        atMillis = 0;
        tickedMillis = 0;
        boats.clear();
        clock(0);
        feed.begin(engine.view(state));
    }

    /** The journal that is shown. */
    public ReplayedJournal journal() {
        return journal;
    }

    /** What lay before the operator. */
    public OperatorModels models() {
        return models;
    }

    /** Tells a listener of the engine's steps as they are taken again, also those of the way to a moment. From any thread. */
    public Registration addListener(HostListener listener) {
        return listeners.add(listener);
    }

    /** The moment that the models show, in ms of the session's clock. From any thread. */
    public long shownMillis() {
        return shownMillis;
    }

    /** Asks the engine's state at the moment that was gone to last. Waits while another moment is gone to. */
    public synchronized <T> T ask(Function<EngineView, T> question) {
        return question.apply(engine.view(state));
    }

    /**
     * What a way of a boat depends on at the moment that was gone to last; empty where the journal does not say it. Waits while another moment is gone
     * to.
     */
    public synchronized Optional<BoatStart> start(String boat) {
        return boats.start(boat);
    }

    /** Goes to a moment, forwards or back; before the start and behind the end there is none. Gives the moment. */
    public synchronized long goTo(long millis) {
        long to = Math.max(0, Math.min(journal.timeLine().endMillis(), millis));
        feed.hold();
        if (to < atMillis) {
            begin();
        }
        while (tellNext(to)) {
            breathe();
        }
        atMillis = to;
        clock(to);
        boats.show(to);
        feed.look(engine.view(state), journal.vocabulary());
        feed.draw(to);
        feed.release();
        return to;
    }

    /** Tells the next item of the journal, if it is not later than a moment. Gives whether it did. */
    private boolean tellNext(long to) {
        List<JournalEntry> entries = journal.entries();
        List<TelemetryRow> rows = journal.rows();
        long entryAt = nextEntry < entries.size() ? entries.get(nextEntry).atMillis() : Long.MAX_VALUE;
        long rowAt = nextRow < rows.size() ? rows.get(nextRow).atMillis() : Long.MAX_VALUE;
        long at = Math.min(entryAt, rowAt);
        if (at > to) {
            return false;
        }
        clock(at);
        if (rowAt < entryAt) {
            boats.take(rows.get(nextRow++));
        } else {
            step(entries.get(nextEntry++));
        }
        if (at - tickedMillis >= SECOND_MS) {
            tickedMillis = at;
            feed.tick(at);
        }
        return true;
    }

    private void step(JournalEntry entry) {
        List<Effect> effects = engine.step(state, entry.atMillis(), entry.input());
        EngineView view = engine.view(state);
        models.onPastStep(entry.atMillis(), entry.input(), effects, view);
        listeners.each(listener -> listener.onStep(entry.index(), entry.atMillis(), entry.input(), effects, view));
    }

    /** The models' clock goes on between what happened before and what happens next. */
    private void clock(long millis) {
        feed.then(() -> shownMillis = millis);
    }

    private void breathe() {
        if (++ahead >= MOST_AHEAD) {
            ahead = 0;
            CompletableFuture<Void> told = new CompletableFuture<>();
            feed.then(() -> told.complete(null));
            told.join();
        }
    }
}
